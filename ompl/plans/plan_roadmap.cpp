// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "ompl/plans/plan_roadmap.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>

namespace leastcost {

using Vector = Eigen::VectorXd;

PlanRoadmap::PlanRoadmap(const PlanSpace& space, Vector from, Vector to, double longest)
    : space_(space), longest_(longest) {
  node(from);
  node(to);
}

int PlanRoadmap::node(const Vector& place) {
  const int number = static_cast<int>(nodes_.size());
  nodes_.push_back(place);
  edges_.emplace_back();
  for (int i = 0; i < number; ++i) {
    const Vector& other = nodes_[static_cast<std::size_t>(i)];
    if ((space_.seen_from(other, place) - other).norm() < longest_) link(i, number, Known::nothing);
  }
  return number;
}

void PlanRoadmap::link(int i, int j, Known known) {
  if (Edge* there = edge(i, j)) {
    there->known = edge(j, i)->known = std::max(there->known, known);
    return;
  }
  const Vector& from = nodes_[static_cast<std::size_t>(i)];
  const double cost = space_.cost(from, space_.seen_from(from, nodes_[static_cast<std::size_t>(j)]));
  edges_[static_cast<std::size_t>(i)].push_back({j, cost, known});
  edges_[static_cast<std::size_t>(j)].push_back({i, cost, known});
}

PlanRoadmap::Edge* PlanRoadmap::edge(int i, int j) {
  for (Edge& edge : edges_[static_cast<std::size_t>(i)])
    if (edge.to == j) return &edge;
  return nullptr;
}

void PlanRoadmap::add(const Vector& place) { node(place); }

void PlanRoadmap::add_path(const Points& x) {
  int before = 0;
  for (Index i = 1; i < x.cols(); ++i) {
    const int here = i + 1 < x.cols() ? node(x.col(i)) : 1;
    link(before, here, space_.seen_from(x.col(i - 1), x.col(i)) == x.col(i) ? Known::valid : Known::nothing);
    before = here;
  }
}

std::vector<int> PlanRoadmap::way(bool valid_only) const {
  std::vector<double> least(nodes_.size(), std::numeric_limits<double>::infinity());
  std::vector<int> before(nodes_.size(), -1);
  using Open = std::pair<double, int>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  least[0] = 0;
  open.emplace(0, 0);
  while (!open.empty()) {
    const auto [cost, i] = open.top();
    open.pop();
    if (i == 1) break;
    if (cost > least[static_cast<std::size_t>(i)]) continue;
    for (const Edge& edge : edges_[static_cast<std::size_t>(i)]) {
      const auto to = static_cast<std::size_t>(edge.to);
      if ((valid_only && edge.known != Known::valid) || !(cost + edge.cost < least[to])) continue;
      least[to] = cost + edge.cost;
      before[to] = i;
      open.emplace(least[to], edge.to);
    }
  }
  if (before[1] < 0) return {};
  std::vector<int> way = {1};
  while (way.back() != 0) way.push_back(before[static_cast<std::size_t>(way.back())]);
  std::reverse(way.begin(), way.end());
  return way;
}

/// Whether all moves of a way are valid; those that are not are taken out.
bool PlanRoadmap::ask(const std::vector<int>& way) {
  bool valid = true;
  for (const Known wanted : {Known::clear_of_walls, Known::valid}) {  // what is quicker to ask first
    for (std::size_t k = 0; k + 1 < way.size(); ++k) {
      Edge* move = edge(way[k], way[k + 1]);
      if (move == nullptr || move->known >= wanted) continue;
      ++asked_;
      const Vector& from = nodes_[static_cast<std::size_t>(way[k])];
      const Vector to = space_.seen_from(from, nodes_[static_cast<std::size_t>(way[k + 1])]);
      if (wanted == Known::clear_of_walls ? space_.clear_of_walls(from, to) : space_.planner_moves(from, to)) {
        move->known = edge(way[k + 1], way[k])->known = wanted;
        continue;
      }
      valid = false;
      const auto drop = [&](int i, int j) {
        std::erase_if(edges_[static_cast<std::size_t>(i)], [j](const Edge& edge) { return edge.to == j; });
      };
      drop(way[k], way[k + 1]);
      drop(way[k + 1], way[k]);
    }
    if (!valid) return false;
  }
  return true;
}

Points PlanRoadmap::cheapest(const Monitor& monitor) {
  while (!monitor.interrupted()) {
    const std::vector<int> found = way(false);
    if (found.empty() || ask(found)) return points(found);
  }
  return points(way(true));
}

Points PlanRoadmap::points(const std::vector<int>& way) const {
  Points x(nodes_.front().size(), static_cast<Index>(way.size()));
  for (Index k = 0; k < x.cols(); ++k) {
    x.col(k) = nodes_[static_cast<std::size_t>(way[static_cast<std::size_t>(k)])];
    if (k > 0) x.col(k) = space_.seen_from(x.col(k - 1), x.col(k));
  }
  return x;
}

}  // namespace leastcost
