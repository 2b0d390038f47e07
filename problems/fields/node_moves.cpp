// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/node_moves.hpp"

#include <algorithm>
#include <cmath>

#include <leastcost/framework/cost/has_conformal_metric.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/bracket/coordinate_cost.hpp>
#include <leastcost/problems/bracket/cost_density.hpp>

namespace leastcost {
namespace {

using Eigen::Vector2d;

bool is_plane(const ConstraintManifold& domain) {
  const Dimensions d = domain.dimensions();
  return d.coordinate == 2 && d.ambient == 2 && find_ability<HasChart>(domain) == nullptr;
}

/// Fills a table from the metric at a node, where there is one; false: the line element comes from no metric.
template <class Element, class Moves, class Table>
bool by_metric(const Element& element, const Moves& moves, Table& table) {
  constexpr double kRounding = 1e-9;
  const auto squared = [&](const Vector2d& v) { return std::pow(element(v), 2); };
  const Vector2d x(moves[0][0], 0), y(0, moves[4][1]);
  const double xx = squared(x), yy = squared(y), xy = (squared(x + y) - xx - yy) / 2;
  const auto metric = [&](const Vector2d& v) {
    const double a = v[0] / x[0], b = v[1] / y[1];
    return a * a * xx + 2 * a * b * xy + b * b * yy;
  };
  for (const Vector2d& v : {Vector2d(-x), Vector2d(x - y), Vector2d(-0.5 * x - y), Vector2d(0.5 * y - x)})
    if (!(std::abs(squared(v) - metric(v)) <= kRounding * (xx + yy))) return false;
  for (std::size_t k = 0; k < table.size(); ++k) table[k] = static_cast<float>(std::sqrt(metric(moves[k])));
  return true;
}

}  // namespace

NodeMoves::NodeMoves(const Problem& problem, const Eigen::Matrix2Xd& u, const Vector2d& step)
    : blocked_(static_cast<std::size_t>(u.cols()), 0) {
  for (std::size_t k = 0; k < kRing.size(); ++k) {
    const auto& [i, j] = kRing[k];
    const auto& [next_i, next_j] = kRing[(k + 1) % kRing.size()];
    moves_[2 * k] = -step.cwiseProduct(Vector2d(i, j));
    moves_[2 * k + 1] = -step.cwiseProduct(Vector2d(i + next_i, j + next_j)) / 2;
  }
  for (std::size_t k = 0; k < kDirections; ++k) lengths_[k] = moves_[k].norm();
  if (!ask_densities(problem, u)) ask_elements(problem, u);
  any_blocked_ = std::count(blocked_.begin(), blocked_.end(), 0) < u.cols();
}

bool NodeMoves::ask_densities(const Problem& problem, const Eigen::Matrix2Xd& u) {
  if (!is_plane(*problem.manifold)) return false;
  const auto* density = find_ability<CostDensity>(*problem.cost);
  const auto* conformal = find_ability<HasConformalMetric>(*problem.cost);
  if (density == nullptr && (conformal == nullptr || !conformal->base().isIdentity(0))) return false;
  scales_.resize(blocked_.size());
  const Eigen::VectorXd unit = Vector2d(1, 0);
  for (Eigen::Index i = 0; i < u.cols(); ++i) {
    const double n = density != nullptr ? density->density(u.col(i)) : problem.cost->line_element(u.col(i), unit);
    const auto node = static_cast<std::size_t>(i);
    scales_[node] = n;
    blocked_[node] = n >= 0 && std::isfinite(n) ? 0 : 1;
  }
  return true;
}

void NodeMoves::ask_elements(const Problem& problem, const Eigen::Matrix2Xd& u) {
  const CoordinateCost cost(problem.manifold, problem.cost);
  const Points places = cost.places(u);
  CoordinateCost::Element element(cost);
  tables_.resize(blocked_.size());
  for (Eigen::Index i = 0; i < u.cols(); ++i) {
    const auto node = static_cast<std::size_t>(i);
    element.move_to(places.middleCols<3>(3 * i));
    Table& table = tables_[node];
    if (!by_metric(element, moves_, table))
      for (std::size_t k = 0; k < kDirections; ++k) table[k] = static_cast<float>(element(moves_[k]));
    const auto possible = std::count_if(table.begin(), table.end(), [](float c) { return std::isfinite(c); });
    blocked_[node] = possible > 0 ? 0 : 1;
    any_carried_ = any_carried_ || (possible > 0 && possible < static_cast<std::ptrdiff_t>(kDirections));
  }
}

}  // namespace leastcost
