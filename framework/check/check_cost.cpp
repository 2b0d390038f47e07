// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/check/check_cost.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/encloses_metric.hpp>
#include "framework/base/symmetric_eigen.hpp"
#include "framework/check/fault_list.hpp"
#include "framework/check/observed_order.hpp"

namespace leastcost {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct PhiIsQ {
  static constexpr KernelKind kind = KernelKind::quadratic_at_zero;
  Jet2 operator()(double q) const { return {q, 1, 0}; }
};
/// exp(s^2) - 1.
struct PhiBends {
  static constexpr KernelKind kind = KernelKind::quadratic_at_zero;
  Jet2 operator()(double q) const { return {std::expm1(q), std::exp(q), std::exp(q)}; }
};

AmbientPath view(const Points& x, bool ring) { return {{x.data(), x.rows(), x.cols()}, {}, ring}; }

std::vector<double> squared(const SegmentCost& cost, const Points& x, bool ring) {
  std::vector<double> q(static_cast<std::size_t>(x.cols()) - 1);
  cost.squared_costs(view(x, ring), q);
  return q;
}

/// max |a - b| relative to the largest entry of both; infinite where one is not finite.
double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  if (!a.allFinite() || !b.allFinite()) return kInfinity;
  const double size = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  return size > 0 ? (a - b).cwiseAbs().maxCoeff() / size : 0;
}

void check_values(const SegmentCost& cost, const Eigen::VectorXd& a, const Eigen::VectorXd& b, FaultList& faults) {
  const double forward = move_cost(cost, a, b), back = move_cost(cost, b, a);
  faults.at_least("value", std::isfinite(forward) && forward > 0 ? 1 : 0, 1, "c(a, b) is finite and positive inside");
  faults.at_most("rest", move_cost(cost, a, a), 0, "c(x, x) is 0");
  faults.at_most("repeatable", move_cost(cost, a, b) == forward ? 0 : 1, 0, "c(a, b) is the same a second time");
  if (cost.traits().symmetric)
    faults.at_most("symmetric", std::abs(back / forward - 1), 1e-13, "c(b, a) / c(a, b) - 1, declared symmetric");
}

void check_additivity(const SegmentCost& cost, const CheckCostOptions& options, const Eigen::VectorXd& a,
                      const Eigen::VectorXd& b, FaultList& faults) {
  const auto defect = [&](double h) {
    const Eigen::VectorXd end = a + h * (b - a), middle = a + h / 2 * (b - a);
    return (move_cost(cost, a, middle) + move_cost(cost, middle, end)) / move_cost(cost, a, end) - 1;
  };
  if (cost.traits().additive)
    faults.at_most("additive", std::abs(defect(1)), 1e-13, "(c(a, m) + c(m, b)) / c(a, b) - 1, declared additive");
  else
    faults.at_least("defect_order", observed_order(defect, 0.5, 1e-13), options.defect_order - kOrderSlack,
                    "order of (c(a, m) + c(m, b)) / c(a, b) - 1 in |b - a|");
}

/// A way through m is no shorter, in many small moves.
void check_chord(const SegmentCost& cost, const Eigen::VectorXd& a, const Eigen::VectorXd& m, const Eigen::VectorXd& b,
                 FaultList& faults) {
  if (!cost.traits().below_curves) return;
  constexpr int kMoves = 64;
  Points x(a.size(), 2 * kMoves + 1);
  for (int i = 0; i <= kMoves; ++i) {
    const double t = i / static_cast<double>(kMoves);
    x.col(i) = (1 - t) * a + t * m;
    x.col(kMoves + i) = (1 - t) * m + t * b;
  }
  faults.at_most("below_curves", move_cost(cost, a, b) / total_cost(cost, view(x, false)), 1 + 1e-12,
                 "c(a, b) over the cost of a curve from a to b, declared below curves");
}

void check_line_element(const SegmentCost& cost, const Eigen::VectorXd& x, const Eigen::VectorXd& v,
                        FaultList& faults) {
  const double element = cost.line_element(x, v);
  faults.at_most("line_element", std::abs(cost.line_element(x, 3 * v) / element / 3 - 1),
                 cost.traits().quadratic_at_rest ? 1e-12 : 1e-7, "line_element(x, 3 v) / (3 line_element(x, v)) - 1");
  const auto error = [&](double h) { return move_cost(cost, x, x + h * v) / h / element - 1; };
  faults.at_least("line_element", observed_order(error, 0.05, 1e-8), 1 - kOrderSlack,
                  "order at which c(x, x + e v) / e approaches line_element(x, v)");
  if (!cost.traits().quadratic_at_rest) return;
  const Index d = x.size();
  ChainBlocks blocks;
  const Points three = x.replicate(1, 3);  // the middle is free: the lower right block of the first move
  cost.chain_blocks(view(three, false), KernelOf<PhiIsQ>(), 1, HessianKind::exact, blocks);
  const double q = v.dot(blocks.blocks.block(d, d, d, d) * v) / 2;
  faults.at_most("quadratic_at_rest", std::isfinite(q) ? std::abs(q / (element * element) - 1) : kInfinity, 1e-7,
                 "v' q_bb v / 2 at a = b over line_element(x, v)^2, less 1: q is twice differentiable at a = b");
}

/// The metric in intervals, at one point.
void check_enclosure(const SegmentCost& cost, const Eigen::VectorXd& x, const Eigen::VectorXd& v, FaultList& faults) {
  const auto* metric = find_ability<EnclosesMetric>(cost);
  const Index d = x.size();
  if (metric == nullptr || (d != 2 && d != 3)) return;
  std::array<IntervalJet<2>, 3> at;
  for (Index i = 0; i < d; ++i) at[static_cast<std::size_t>(i)] = IntervalJet<2>(x[i]);
  std::array<IntervalJet<2>, 6> upper;
  metric->enclose_metric(std::span<const IntervalJet<2>>(at).first(static_cast<std::size_t>(d)), upper);
  Interval squared(0);
  double size = 0;  // of the terms: they may cancel
  std::size_t k = 0;
  for (Index i = 0; i < d; ++i)
    for (Index j = i; j < d; ++j) {
      const Interval term = upper[k++].value() * Interval(i == j ? 1 : 2) * Interval(v[i]) * Interval(v[j]);
      squared += term;
      size += term.magnitude();
    }
  const double element = cost.line_element(x, v);
  faults.at_most(
      "enclosure",
      squared.is_finite() ? (std::abs(squared.middle() - element * element) + squared.width()) / size : kInfinity,
      1e-10, "v'G v in intervals at a point less line_element(x, v)^2, and its width, over its terms");
}

/// A direction for the columns that may move, a tenth of a move long or so.
Points free_direction(const Points& x, bool ring, std::mt19937_64& engine) {
  Points direction = random_matrix(x.rows(), x.cols(), engine);
  if (ring)
    direction.rightCols(1) = direction.col(0);
  else
    direction.leftCols(1).setZero(), direction.rightCols(1).setZero();
  const double move = (x.rightCols(x.cols() - 1) - x.leftCols(x.cols() - 1)).colwise().norm().minCoeff();
  return direction * (move / direction.norm());
}

void check_slopes(const SegmentCost& cost, const Kernel& kernel, const Points& x, bool ring, std::mt19937_64& engine,
                  FaultList& faults) {
  const Index d = x.rows(), columns = x.cols();
  const std::vector<double> q = squared(cost, x, ring);
  double sum = 0;
  for (const double value : q) sum += value;
  const double s0 = std::sqrt(sum / static_cast<double>(columns - 1));
  const Points direction = free_direction(x, ring, engine);

  const auto energy = [&](const Points& at) {
    double e = 0;
    for (const double value : squared(cost, at, ring)) {
      const double scaled = value / (s0 * s0);
      Jet2 jet;
      kernel.apply({&scaled, 1}, {&jet, 1});
      e += jet.value;
    }
    return e;
  };
  Points gradient(d, columns);
  const double value = energy(x), other = cost.energy_and_gradient(view(x, ring), kernel, s0, gradient);
  faults.at_most("value_and_gradient", std::abs(other - value) / std::abs(value), 1e-10,
                 "relative difference of q between value<double> and the gradient computation");
  if (!ring)
    faults.at_most("fixed_ends", gradient.col(0).cwiseAbs().maxCoeff() + gradient.rightCols(1).cwiseAbs().maxCoeff(), 0,
                   "gradient at the ends of an open path");
  ChainBlocks blocks;
  cost.chain_blocks(view(x, ring), kernel, s0, HessianKind::exact, blocks);
  const double slope = gradient.cwiseProduct(direction).sum();
  double curvature = 0;
  for (Index i = 0; i + 1 < columns; ++i) {
    const Eigen::VectorXd both = direction.middleCols(i, 2).reshaped();
    const auto block = blocks.blocks.middleCols(2 * d * i, 2 * d);
    curvature += both.dot(block * both);
    faults.at_most("hessian_symmetry", difference(block, block.transpose()), 1e-10, "asymmetry of an exact block");
  }
  const double floor = 1000 * kEps * (std::abs(value) + std::abs(slope) + std::abs(curvature));
  const auto change = [&](double h) { return energy(x + h * direction) - value; };
  faults.at_least("gradient", observed_order([&](double h) { return change(h) - h * slope; }, 0.05, floor),
                  2 - kOrderSlack, "Taylor slope of the energy with its gradient");
  faults.at_least("hessian",
                  observed_order([&](double h) { return change(h) - h * slope - h * h / 2 * curvature; }, 0.05, floor),
                  3 - kOrderSlack, "Taylor slope of the energy with its gradient and Hessian");
}

void check_gauss_newton(const SegmentCost& cost, const CheckCostOptions& options, const Kernel& kernel, const Points& x,
                        FaultList& faults) {
  const Index d = x.rows(), n = x.cols() - 1;
  double sum = 0;
  for (const double value : squared(cost, x, false)) sum += value;
  const double s0 = std::sqrt(sum / static_cast<double>(n));
  ChainBlocks gauss_newton, exact;
  cost.chain_blocks(view(x, false), kernel, s0, HessianKind::gauss_newton, gauss_newton);
  cost.chain_blocks(view(x, false), kernel, s0, HessianKind::exact, exact);
  for (Index i = 0; i < n; ++i) {
    const Eigen::MatrixXd block = gauss_newton.blocks.middleCols(2 * d * i, 2 * d);
    const double size = block.cwiseAbs().maxCoeff();
    faults.at_most("gauss_newton", difference(block, block.transpose()), 1e-12, "asymmetry of a Gauss-Newton block");
    const double least = block.allFinite() ? symmetric_eigenvalues(block)[0] : -kInfinity;
    faults.at_most("gauss_newton", -least / size, 1e-12, "least eigenvalue of a Gauss-Newton block, negated, relative");
    if (i == 0)
      faults.at_most("fixed_ends", block.topRows(d).cwiseAbs().maxCoeff(), 0, "block rows of the fixed source");
    if (i == n - 1)
      faults.at_most("fixed_ends", block.bottomRows(d).cwiseAbs().maxCoeff(), 0, "block rows of the fixed target");
    if (options.linear_residual)
      faults.at_most("gauss_newton", difference(block, exact.blocks.middleCols(2 * d * i, 2 * d)), 1e-10,
                     "difference to the exact block, claimed equal");
  }
}

void check_residual(const SegmentCost& cost, const Points& x, FaultList& faults) {
  const Index d = x.rows(), n = x.cols() - 1;
  const std::vector<double> q = squared(cost, x, true);
  Points r, jacobians, gradient(d, n + 1), from_residuals = Points::Zero(d, n + 1);
  cost.residuals(view(x, true), r, &jacobians);
  cost.energy_and_gradient(view(x, true), KernelOf<PhiIsQ>(), 1, gradient);
  for (Index i = 0; i < n; ++i) {
    const double own = q[static_cast<std::size_t>(i)];
    faults.at_most("residual", std::abs(r.col(i).squaredNorm() / own - 1), 1e-10, "|r|^2 / q - 1");
    const Eigen::VectorXd slope = 2 * jacobians.middleCols(2 * d * i, 2 * d).transpose() * r.col(i);
    from_residuals.col(i) += slope.head(d);
    from_residuals.col(i + 1) += slope.tail(d);
  }
  faults.at_most("residual_jacobian", difference(from_residuals, gradient), 1e-9, "2 J'r against the gradient of q");
}

void check_outside(const SegmentCost& cost, const Eigen::VectorXd& inside, const Eigen::VectorXd& point,
                   FaultList& faults) {
  const auto infinite = [&](double value) {
    faults.at_least("outside", value, kInfinity, "cost of a move that leaves the domain");
  };
  infinite(move_cost(cost, inside, point));
  infinite(move_cost(cost, point, inside));
  Points path(inside.size(), 3), gradient(inside.size(), 3);
  path << inside, point, inside;
  infinite(cost.energy_and_gradient(view(path, false), KernelOf<PhiIsQ>(), 1, gradient));
}

void check_derivatives(const SegmentCost& cost, const Points& x, bool ring, std::mt19937_64& engine,
                       FaultList& faults) {
  check_slopes(cost, KernelOf<PhiIsQ>(), x, ring, engine, faults);
  check_slopes(cost, KernelOf<PhiBends>(), x, ring, engine, faults);
}

}  // namespace

std::vector<Fault> check_cost(const SegmentCost& cost, const PointSampler& inside, std::mt19937_64& engine,
                              const CheckCostOptions& options) {
  FaultList faults;
  const Index d = cost.dim();
  const PointSampler in_domain = of_dimension(inside, d);
  for (const Eigen::VectorXd& point : options.outside) check_dimension(point, d);
  for (int repeat = 0; repeat < options.samples; ++repeat) {
    Points x(d, 4);
    for (Index i = 0; i < 4; ++i) x.col(i) = in_domain(engine);
    const Points near = x.col(0).replicate(1, 4) + 1e-8 * random_matrix(d, 4, engine);
    check_values(cost, x.col(0), x.col(1), faults);
    check_values(cost, near.col(0), near.col(1), faults);
    check_additivity(cost, options, x.col(0), x.col(1), faults);
    check_chord(cost, x.col(0), x.col(1), x.col(2), faults);
    check_chord(cost, x.col(0), (x.col(0) + x.col(2)) / 2, x.col(2), faults);
    check_line_element(cost, x.col(0), x.col(1) - x.col(0), faults);
    check_enclosure(cost, x.col(0), x.col(1) - x.col(0), faults);
    for (const Eigen::VectorXd& point : options.outside) check_outside(cost, x.col(0), point, faults);
    for (const Points& path : {x, near}) {
      check_gauss_newton(cost, options, KernelOf<PhiIsQ>(), path, faults);
      check_gauss_newton(cost, options, KernelOf<PhiBends>(), path, faults);
    }
    check_derivatives(cost, x, false, engine, faults);
    x.rightCols(1) = x.col(0);
    check_derivatives(cost, x, true, engine, faults);
    check_residual(cost, x, faults);
  }
  return faults.take();
}

std::vector<Fault> check_cost_derivatives(const SegmentCost& cost, const Points& path, bool ring,
                                          std::mt19937_64& engine) {
  FaultList faults;
  if (path.cols() < 3) throw InputError("slopes are checked along a path of three points at least");
  check_dimension(path.col(0), cost.dim());
  check_derivatives(cost, path, ring, engine, faults);
  return faults.take();
}

}  // namespace leastcost
