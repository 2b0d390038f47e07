// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/georce.hpp>

#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/energy/stopping.hpp>
#include "framework/base/dense_solves.hpp"
#include "solvers/best_by_cost.hpp"
#include "solvers/limit_fields.hpp"

namespace leastcost {
namespace {

constexpr double kMetricDifference = 1e-6;  ///< of the extent of the path, for the derivative of the metric
constexpr int kGeorceHalvings = 30;

/// Notation of the paper: x_t points, u_t moves, G_t metrics at the starts of the moves, mu and nu_t multipliers.
class GeorceSolve {
 public:
  GeorceSolve(PathEnergy& energy, CoordinatePath& path, const GeorceOptions& options, const Monitor& monitor)
      : energy_(energy),
        path_(path),
        d_(path.u.rows()),
        moves_(path.segment_count()),
        options_(options),
        best_(energy, path),
        loop_(energy, path, {options.tolerance, options.max_iterations, options.max_evaluations}, monitor) {}

  SolveReport run() {
    own_energy_ = own_energy(path_, metric_);
    if (!std::isfinite(own_energy_))
      return best_.finish(loop_, Termination::non_finite, "the metric of the cost is not finite");
    double cost = best_.cost(), largest_move = 0;
    for (;;) {
      loop_.record(energy_.value(path_), std::numeric_limits<double>::quiet_NaN(), largest_move);  // ours: comparable
      if (const std::optional<Termination> end = loop_.must_end(path_)) return best_.finish(loop_, *end, "");
      if (!propose())
        return best_.finish(loop_, Termination::non_finite, "the metric of the cost is not positive definite");
      const double before = own_energy_;
      if (!backtrack()) return best_.at_rest(loop_, cost);
      largest_move = largest_move_;
      cost = best_.consider(path_);
      if (before - own_energy_ <= options_.tolerance * before) return best_.at_rest(loop_, cost);
    }
  }

 private:
  auto metric(Index t) const { return metric_.middleCols(d_ * t, d_); }
  Eigen::VectorXd move(const CoordinatePath& path, Index t) const { return path.u.col(t + 1) - path.u.col(t); }

  /// sum u' G u; +infinity where G is not finite.
  double own_energy(const CoordinatePath& path, Points& metric) {
    energy_.metrics(path, metric);
    double sum = 0;
    for (Index t = 0; t < moves_; ++t) {
      const Eigen::VectorXd u = move(path, t);
      sum += u.dot(metric.middleCols(d_ * t, d_) * u);
    }
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
  }

  /// nu_t = d/dy [u_t' G(y) u_t] at x_t, one coordinate at a time, all points at once.
  void differentiate_metric() {
    const double h = kMetricDifference * extent_of(path_.u);
    nu_.resize(d_, moves_);
    CoordinatePath shifted = path_;
    for (Index k = 0; k < d_; ++k) {
      shifted.u = path_.u;
      shifted.u.row(k).array() += h;
      energy_.metrics(shifted, plus_);
      shifted.u.row(k).array() -= 2 * h;
      energy_.metrics(shifted, minus_);
      for (Index t = 0; t < moves_; ++t) {
        const Eigen::VectorXd u = move(path_, t);
        nu_(k, t) = u.dot((plus_ - minus_).middleCols(d_ * t, d_) * u) / (2 * h);
      }
    }
  }

  /// The moves that satisfy the conditions for the multipliers of the current ones. False where a metric cannot be
  /// inverted.
  bool propose() {
    differentiate_metric();
    Points later = Points::Zero(d_, moves_);  // sum of nu_j, j > t
    for (Index t = moves_ - 2; t >= 0; --t) later.col(t) = later.col(t + 1) + nu_.col(t + 1);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(d_, d_);
    Eigen::VectorXd right = -2 * (path_.u.rightCols(1) - path_.u.col(0));
    inverse_.resize(d_, d_ * moves_);
    for (Index t = 0; t < moves_; ++t) {
      const std::optional<Eigen::MatrixXd> inverse = inverse_of_definite(metric(t));
      if (!inverse) return false;
      inverse_.middleCols(d_ * t, d_) = *inverse;
      sum += inverse_.middleCols(d_ * t, d_);
      right -= inverse_.middleCols(d_ * t, d_) * later.col(t);
    }
    const Eigen::VectorXd mu = solve_symmetric(sum, right);
    energy_.count({.linear_solves = 1});
    proposed_.resize(d_, moves_);
    for (Index t = 0; t < moves_; ++t) proposed_.col(t) = -0.5 * inverse_.middleCols(d_ * t, d_) * (mu + later.col(t));
    return proposed_.allFinite();
  }

  /// The convex combination of old and proposed moves that lowers the energy.
  bool backtrack() {
    double part = 1;
    for (int i = 0; i < kGeorceHalvings; ++i, part /= 2) {
      Points step(d_, moves_ - 1);
      Eigen::VectorXd x = path_.u.col(0);
      for (Index t = 0; t + 1 < moves_; ++t) {
        x += part * proposed_.col(t) + (1 - part) * move(path_, t);
        step.col(t) = x - path_.u.col(t + 1);
      }
      energy_.retract(path_, step, trial_);
      const double value = own_energy(trial_, trial_metric_);
      if (!(value < own_energy_)) continue;
      own_energy_ = value;
      largest_move_ = step.colwise().norm().maxCoeff();
      std::swap(path_, trial_);
      std::swap(metric_, trial_metric_);
      return true;
    }
    return false;
  }

  PathEnergy& energy_;
  CoordinatePath path_, trial_;
  Index d_, moves_;
  GeorceOptions options_;
  BestByCost best_;
  SolveLoop loop_;
  Points metric_, trial_metric_, plus_, minus_, inverse_, nu_, proposed_;
  double own_energy_ = 0, largest_move_ = 0;
};

}  // namespace

void GeorceOptions::fields(FieldVisitor& visit) {
  visit.field("tolerance", tolerance,
              {.help = "Stops when an iteration lowers its discrete energy by less than this fraction.", .minimum = 0});
  limit_fields(visit, max_iterations, max_evaluations);
}

std::optional<std::string> Georce::cannot_solve(const PathEnergy& energy, const CoordinatePath& path) const {
  const Problem& problem = energy.problem();
  if (problem.ring) return "georce needs an open path: it updates the points starting from the source";
  const bool chart = problem.manifold->shape() == Shape::flat || find_ability<HasChart>(*problem.manifold) != nullptr;
  if (!chart) return "georce works in a chart: a euclidean or a parametric manifold";
  if (!problem.cost->traits().quadratic_at_rest)
    return "georce needs a metric, but this cost has none (a Finsler cost)";
  PathEnergy own(problem, energy.reference_cost(), energy.deadline());
  Points metric;
  own.metrics(path, metric);
  const Index d = metric.rows();
  for (Index t = 0; t < path.segment_count(); ++t) {
    const Points g = metric.middleCols(d * t, d);
    if (!g.allFinite() || !cholesky_factor(g))
      return "georce needs a metric at every point, but that of this cost is infinite or not definite at point " +
             std::to_string(t) + " of the path";
  }
  return std::nullopt;
}

SolveReport Georce::do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  return GeorceSolve(energy, path, options_, monitor).run();
}

}  // namespace leastcost
