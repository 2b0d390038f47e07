// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/node_moves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
template <class Element>
bool by_metric(const Element& element, const std::vector<Vector2d>& moves, float* table) {
  constexpr double kRounding = 1e-9;
  const auto squared = [&](const Vector2d& v) { return std::pow(element(v), 2); };
  const Vector2d x(moves[0][0], 0), y(0, moves[moves.size() / 4][1]);
  const double xx = squared(x), yy = squared(y), xy = (squared(x + y) - xx - yy) / 2;
  const auto metric = [&](const Vector2d& v) {
    const double a = v[0] / x[0], b = v[1] / y[1];
    return a * a * xx + 2 * a * b * xy + b * b * yy;
  };
  for (const Vector2d& v : {Vector2d(-x), Vector2d(x - y), Vector2d(-0.5 * x - y), Vector2d(0.5 * y - x)})
    if (!(std::abs(squared(v) - metric(v)) <= kRounding * (xx + yy))) return false;
  for (std::size_t k = 0; k < moves.size(); ++k) table[k] = static_cast<float>(std::sqrt(metric(moves[k])));
  return true;
}

}  // namespace

NodeMoves::NodeMoves(const Problem& problem, const Eigen::Matrix2Xd& u, const Vector2d& step)
    : blocked_(static_cast<std::size_t>(u.cols()), 0) {
  constexpr Eigen::Index kManyNodes = 2'000'000;  // a table of sixteen parts takes 512 bytes a node
  divide(kOfMetric, step);
  if (!ask_densities(problem, u) && !ask_elements(problem, u)) {
    if (u.cols() <= kManyNodes) divide(kOfOthers, step);
    ask_all_elements(problem, u);
  }
  any_blocked_ = std::count(blocked_.begin(), blocked_.end(), 0) < u.cols();
}

void NodeMoves::divide(std::size_t parts, const Vector2d& step) {
  parts_ = parts;
  moves_.clear(), lengths_.clear();
  moves_.reserve(directions()), lengths_.reserve(directions());
  for (std::size_t k = 0; k < kRing.size(); ++k)
    for (std::size_t part = 0; part < parts; ++part) {
      const auto& [i, j] = kRing[k];
      const auto& [next_i, next_j] = kRing[(k + 1) % kRing.size()];
      const double t = double(part) / double(parts);
      moves_.emplace_back(-step.cwiseProduct((1 - t) * Vector2d(i, j) + t * Vector2d(next_i, next_j)));
      lengths_.push_back(moves_.back().norm());
    }
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

bool NodeMoves::ask_elements(const Problem& problem, const Eigen::Matrix2Xd& u) {
  const CoordinateCost cost(problem.manifold, problem.cost);
  const Points places = cost.places(u);
  CoordinateCost::Element element(cost);
  tables_.resize(blocked_.size() * directions());
  for (Eigen::Index i = 0; i < u.cols(); ++i) {
    element.move_to(places.middleCols<3>(3 * i));
    const auto node = static_cast<std::size_t>(i);
    blocked_[node] = element.is_inside() ? 0 : 1;
    if (element.is_inside() && !by_metric(element, moves_, &tables_[node * directions()])) return false;
  }
  return true;
}

void NodeMoves::ask_all_elements(const Problem& problem, const Eigen::Matrix2Xd& u) {
  const CoordinateCost cost(problem.manifold, problem.cost);
  const Points places = cost.places(u);
  CoordinateCost::Element element(cost);
  tables_.resize(blocked_.size() * directions());
  least_.assign(blocked_.size() * kRing.size(), std::numeric_limits<float>::infinity());
  for (Eigen::Index i = 0; i < u.cols(); ++i) {
    const auto node = static_cast<std::size_t>(i);
    element.move_to(places.middleCols<3>(3 * i));
    float* table = &tables_[node * directions()];
    if (!by_metric(element, moves_, table))
      for (std::size_t k = 0; k < directions(); ++k) table[k] = static_cast<float>(element(moves_[k]));
    const auto possible =
        static_cast<std::size_t>(std::count_if(table, table + directions(), [](float c) { return std::isfinite(c); }));
    blocked_[node] = possible > 0 ? 0 : 1;
    any_carried_ = any_carried_ || (possible > 0 && possible < directions());
    for (std::size_t k = 0; k < kRing.size(); ++k) {
      float& least = least_[node * kRing.size() + k];
      for (std::size_t part = 0; part < parts_ + 3; ++part)
        least = std::min(least, table[(parts_ * k + part + directions() - 1) % directions()]);
    }
  }
}

}  // namespace leastcost
