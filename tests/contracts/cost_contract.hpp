// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Eigenvalues>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include <leastcost/framework/segment_cost.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/support/slopes.hpp"

namespace leastcost::test {

/// What the contract needs to know about a cost besides the cost.
struct CostCase {
  std::shared_ptr<const SegmentCost> cost;
  std::function<Eigen::VectorXd(Random&)> draw;  ///< a point well inside the domain of the cost
  std::vector<Eigen::VectorXd> outside = {};     ///< points where a move has infinite cost
  bool linear_residual = false;                  ///< the Gauss-Newton Hessian is claimed to be the exact one
  double defect_order = 2;  ///< of (c(a, m) + c(m, b)) / c(a, b) - 1 in |b - a|, where not additive
};

inline double squared(const SegmentCost& cost, const Points& x) {
  std::vector<double> q(static_cast<std::size_t>(x.cols()) - 1);
  cost.squared_costs({{x.data(), x.rows(), x.cols()}, {}, false}, q);
  double sum = 0;
  for (const double value : q) sum += value;
  return sum;
}

/// q >= 0, zero for no move, symmetric or says so.
inline void check_cost_values(const CostCase& c, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const double forward = move_cost(*c.cost, a, b);
  CHECK(forward > 0);
  CHECK(std::isfinite(forward));
  CHECK(move_cost(*c.cost, a, a) == 0);
  if (c.cost->traits().symmetric) CHECK(move_cost(*c.cost, b, a) == Approx(forward).epsilon(1e-14));
}

/// An AmbientPath over the columns; in a ring the last column is the first again.
inline AmbientPath view(const Points& x, bool ring) { return {{x.data(), x.rows(), x.cols()}, {}, ring}; }

/// Gradient by Taylor slope 2, exact chain blocks by slope 3, on a path through four random points, open (the ends are
/// constants) and as a ring (nothing is).
inline void check_cost_derivatives(const CostCase& c, const Kernel& kernel, const Points& x, bool ring,
                                   Random& random) {
  const Index d = x.rows(), columns = x.cols();
  const double s0 = std::sqrt(squared(*c.cost, x) / static_cast<double>(columns - 1));
  Points direction = random.matrix(d, columns);
  if (ring)
    direction.rightCols(1) = direction.col(0);
  else
    direction.leftCols(1).setZero(), direction.rightCols(1).setZero();
  direction *= (x.col(1) - x.col(0)).norm() / direction.norm();

  Points gradient(d, columns), ignored(d, columns);
  const double value = c.cost->energy_and_gradient(view(x, ring), kernel, s0, gradient);
  if (!ring) CHECK((gradient.col(0).isZero(0) && gradient.rightCols(1).isZero(0)));
  ChainBlocks blocks;
  c.cost->chain_blocks(view(x, ring), kernel, s0, HessianKind::exact, blocks);
  double slope = 0, curvature = 0;
  for (Index i = 0; i < columns; ++i) slope += gradient.col(i).dot(direction.col(i));
  for (Index i = 0; i + 1 < columns; ++i) {
    const Eigen::VectorXd both = direction.middleCols(i, 2).reshaped();
    curvature += both.dot(blocks.blocks.middleCols(2 * d * i, 2 * d) * both);
  }
  const auto difference = [&](double h) {
    const Points moved = x + h * direction;
    return c.cost->energy_and_gradient(view(moved, ring), kernel, s0, ignored) - value;
  };
  const double floor =
      1000 * std::numeric_limits<double>::epsilon() * (std::abs(value) + std::abs(slope) + std::abs(curvature));
  CHECK(observed_order([&](double h) { return difference(h) - h * slope; }, 0.05, floor) > 2 - kOrderSlack);
  CHECK(observed_order([&](double h) { return difference(h) - h * slope - h * h / 2 * curvature; }, 0.05, floor) >
        3 - kOrderSlack);
}

/// The Gauss-Newton blocks are semidefinite, decoupled from fixed ends, and exact where that is claimed.
inline void check_gauss_newton(const CostCase& c, const Kernel& kernel, const Points& x) {
  const Index d = x.rows(), n = x.cols() - 1;
  const double s0 = std::sqrt(squared(*c.cost, x) / static_cast<double>(n));
  ChainBlocks gauss_newton, exact;
  c.cost->chain_blocks(view(x, false), kernel, s0, HessianKind::gauss_newton, gauss_newton);
  c.cost->chain_blocks(view(x, false), kernel, s0, HessianKind::exact, exact);
  for (Index i = 0; i < n; ++i) {
    const Eigen::MatrixXd block = gauss_newton.blocks.middleCols(2 * d * i, 2 * d);
    const double size = block.cwiseAbs().maxCoeff();
    CHECK((block - block.transpose()).cwiseAbs().maxCoeff() <= 1e-12 * size);
    CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(block).eigenvalues().minCoeff() >= -1e-12 * size);
    if (i == 0) CHECK((block.topRows(d).isZero(0) && block.leftCols(d).isZero(0)));
    if (i == n - 1) CHECK((block.bottomRows(d).isZero(0) && block.rightCols(d).isZero(0)));
    if (c.linear_residual)
      CHECK((block - exact.blocks.middleCols(2 * d * i, 2 * d)).cwiseAbs().maxCoeff() <= 1e-10 * size);
  }
}

/// c(a, m) + c(m, b) = c(a, b) where the cost claims it; elsewhere the defect falls at the order it states.
inline void check_additivity(const CostCase& c, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const auto defect = [&](double h) {
    const Eigen::VectorXd end = a + h * (b - a), middle = a + h / 2 * (b - a);
    return (move_cost(*c.cost, a, middle) + move_cost(*c.cost, middle, end)) / move_cost(*c.cost, a, end) - 1;
  };
  if (c.cost->traits().additive)
    CHECK(std::abs(defect(1)) <= 1e-13);
  else
    CHECK(observed_order(defect, 0.5, 1e-13) > c.defect_order - kOrderSlack);
}

/// The line element is the limit of short moves, first order at least.
inline void check_line_element(const CostCase& c, const Eigen::VectorXd& x, const Eigen::VectorXd& v) {
  const double element = c.cost->line_element(x, v);
  CHECK(c.cost->line_element(x, 3 * v) == Approx(3 * element).epsilon(1e-12));
  const auto error = [&](double h) { return move_cost(*c.cost, x, x + h * v) / h / element - 1; };
  CHECK(observed_order(error, 0.05, 1e-8) > 1 - kOrderSlack);
}

/// Outside its domain a cost is +infinity, never NaN, and so are energy and gradient (or the energy says so).
inline void check_outside(const CostCase& c, const Eigen::VectorXd& inside) {
  Points gradient(inside.size(), 3);
  for (const Eigen::VectorXd& point : c.outside) {
    CHECK(move_cost(*c.cost, inside, point) == std::numeric_limits<double>::infinity());
    CHECK(move_cost(*c.cost, point, inside) == std::numeric_limits<double>::infinity());
    const Points path = (Points(inside.size(), 3) << inside, point, inside).finished();
    CHECK(c.cost->energy_and_gradient(view(path, false), KernelOf<Square>(), 1, gradient) ==
          std::numeric_limits<double>::infinity());
  }
}

/// The contract of SegmentCost (framework/segment_cost.hpp): typical, nearly degenerate (moves of 1e-8), random.
inline void check_cost_contract(const CostCase& c) {
  Random random;
  const Index d = c.cost->dim();
  CAPTURE(d, c.cost->traits().unit);
  for (int repeat = 0; repeat < 5; ++repeat) {
    Points x(d, 4);
    for (Index i = 0; i < 4; ++i) x.col(i) = c.draw(random);
    check_cost_values(c, x.col(0), x.col(1));
    check_additivity(c, x.col(0), x.col(1));
    check_line_element(c, x.col(0), x.col(1) - x.col(0));
    check_outside(c, x.col(0));
    const Points near = x.col(0).replicate(1, 4) + 1e-8 * random.matrix(d, 4);
    check_cost_values(c, near.col(0), near.col(1));
    for (const auto& kernel : {make_kernel<Square>(), make_kernel<Expm1Square>()}) {
      for (const bool ring : {false, true}) {
        Points ends = x;
        if (ring) ends.rightCols(1) = ends.col(0);
        CAPTURE(ring, repeat);
        check_cost_derivatives(c, *kernel, ends, ring, random);
      }
      check_gauss_newton(c, *kernel, x);
      check_gauss_newton(c, *kernel, near);
    }
  }
}

}  // namespace leastcost::test
