// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/grid_search.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include "problems/fields/lattice_box.hpp"

namespace leastcost {
namespace {

using Vector = Eigen::VectorXd;

bool is_euclidean(const SegmentCost& cost) {
  const auto* constant = find_ability<HasConstantMetric>(cost);
  return constant != nullptr && constant->metric().isIdentity(0);
}

}  // namespace

MoveCheck::MoveCheck(const Problem& problem)
    : problem_(problem),
      obstacles_(find_ability<ChecksMoves>(*problem.manifold)),
      euclidean_(is_euclidean(*problem.cost)) {}

double MoveCheck::cost(const Vector& a, const Vector& b) const {
  return euclidean_ ? (b - a).norm() : move_cost(*problem_.cost, a, b);
}

bool MoveCheck::below_curves() const { return problem_.cost->traits().below_curves; }

bool MoveCheck::clear(const Vector& a, const Vector& b, double piece) const {
  if (obstacles_ == nullptr) return true;
  const int pieces = std::max(1, static_cast<int>(std::ceil((b - a).norm() / piece)));
  Vector from = a;
  for (int k = 1; k <= pieces; ++k) {
    const Vector to = k == pieces ? b : Vector(a + double(k) / pieces * (b - a));
    if (!goes_clear(*obstacles_, from, to)) return false;
    from = to;
  }
  return true;
}

GridSearch::GridSearch(const Problem& problem, const MoveCheck& moves, const Vector& lower, const Vector& upper,
                       double resolution)
    : problem_(problem), moves_(moves), resolution_(resolution), first_(lower.size()) {
  constexpr double kRounding = 1e-9;  // a side of 8 cells has 8 of them
  for (Eigen::Index d = 0; d < lower.size(); ++d) {
    const double cells = std::max(1.0, std::floor((upper[d] - lower[d]) / resolution + kRounding));
    lattice_.count[static_cast<std::size_t>(d)] = static_cast<std::int32_t>(cells);
    first_[d] = (lower[d] + upper[d]) / 2 - resolution * (cells - 1) / 2;
  }
}

Vector GridSearch::center(std::int32_t node) const {
  const std::array<std::int32_t, 3> at = lattice_.place(node);
  Vector x = first_;
  for (Eigen::Index d = 0; d < x.size(); ++d) x[d] += resolution_ * at[static_cast<std::size_t>(d)];
  return x;
}

/// The nodes near an end that it has a clear move to (or from).
std::vector<RouteEnd> GridSearch::joined(const Vector& x, bool from) const {
  std::array<std::int32_t, 3> low{}, high{};
  for (std::size_t d = 0; d < static_cast<std::size_t>(x.size()); ++d) {
    const auto k = static_cast<Eigen::Index>(d);
    const double at = std::clamp(std::round((x[k] - first_[k]) / resolution_), 0.0, double(lattice_.count[d] - 1));
    low[d] = std::max(static_cast<std::int32_t>(at) - kEndReach, 0);
    high[d] = std::min(static_cast<std::int32_t>(at) + kEndReach, lattice_.count[d] - 1);
  }
  std::vector<RouteEnd> ends;
  for (std::int32_t k = low[2]; k <= high[2]; ++k)
    for (std::int32_t j = low[1]; j <= high[1]; ++j)
      for (std::int32_t i = low[0]; i <= high[0]; ++i) {
        const std::int32_t node = lattice_.number({i, j, k});
        const Vector at = center(node);
        const double cost = from ? moves_.cost(x, at) : moves_.cost(at, x);
        if (std::isfinite(cost) && moves_.clear(x, at, resolution_)) ends.push_back({node, cost});
      }
  return ends;
}

std::vector<Vector> GridSearch::route(const Monitor& monitor) const {
  const Vector &source = problem_.source.u, &target = problem_.target.u;
  const std::vector<RouteEnd> starts = joined(source, true), ends = joined(target, false);
  const std::vector<LatticeStep> steps = steps_of(lattice_);
  const auto move = [&](std::int32_t from, const std::array<std::int32_t, 3>&, std::size_t k) {
    const LatticeStep& step = steps[k];
    if (moves_.euclidean())
      return resolution_ * std::sqrt(double(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]));
    return moves_.cost(center(from),
                       center(from + step[0] + lattice_.count[0] * (step[1] + lattice_.count[1] * step[2])));
  };
  const bool below = moves_.below_curves();
  const auto bound = [&](std::int32_t node, const std::array<std::int32_t, 3>&) {
    return below ? moves_.cost(center(node), target) : 0.0;
  };
  const auto passable = [&](std::int32_t from, std::int32_t to) {
    return moves_.clear(center(from), center(to), 2 * resolution_);
  };
  const GraphRoute found = lattice_route(
      lattice_, starts, ends, move, bound, [&monitor] { return monitor.interrupted(); }, passable);
  if (found.outcome == RouteOutcome::stopped)
    throw Interrupted("grid: interrupted after " + std::to_string(found.settled) + " cells");
  std::vector<Vector> points;
  if (found.outcome != RouteOutcome::found) return points;
  points.push_back(source);
  for (const std::int32_t node : found.nodes) points.push_back(center(node));
  points.push_back(target);
  return points;
}

std::vector<Vector> with_shortcuts(const std::vector<Vector>& route, const MoveCheck& moves, double piece,
                                   const Monitor& monitor) {
  constexpr double kRounding = 1e-12;  // of the cost
  std::vector<Vector> out = {route.front()};
  double passed = 0;  // cost from the point kept last to the point before i
  for (std::size_t i = 1; i < route.size(); ++i) {
    if (monitor.interrupted()) throw Interrupted("grid: interrupted while the route was shortened");
    passed += moves.cost(route[i - 1], route[i]);
    const bool cheaper = moves.cost(out.back(), route[i]) <= passed * (1 + kRounding);
    if (i == 1 || (cheaper && moves.clear(out.back(), route[i], piece))) continue;
    out.push_back(route[i - 1]);
    passed = moves.cost(route[i - 1], route[i]);
  }
  out.push_back(route.back());
  return out;
}

}  // namespace leastcost
