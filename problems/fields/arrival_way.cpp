// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The way back down an arrival field.
#include <algorithm>

#include <leastcost/framework/base/errors.hpp>
#include "problems/fields/arrival_field.hpp"

namespace leastcost {
namespace {

InitializationError lost() {
  return InitializationError(
      "eikonal: the target was reached, but the path back to the source is lost between the nodes: use more cells");
}

}  // namespace

/// The nodes of the cells that have an edge in common.
ArrivalField::Window ArrivalField::cells_beside(const Place& edge) const {
  const std::array<std::int32_t, 3> a = lattice_.place(edge.a), b = lattice_.place(edge.b);
  Window window{};
  for (std::size_t d = 0; d < 2; ++d) {
    const std::int32_t beside = a[d] == b[d] ? 1 : 0;
    window.low[d] = std::max(std::min(a[d], b[d]) - beside, 0);
    window.high[d] = std::min(std::max(a[d], b[d]) + beside, lattice_.count[d] - 1);
  }
  return window;
}

std::vector<ArrivalField::Edge> ArrivalField::edges_in(const Window& window) const {
  std::vector<Edge> edges;
  for (std::int32_t j = window.low[1]; j <= window.high[1]; ++j)
    for (std::int32_t i = window.low[0]; i <= window.high[0]; ++i) {
      const std::int32_t node = lattice_.number({i, j, 0});
      edges.push_back({node, i < window.high[0] ? lattice_.number({i + 1, j, 0}) : node});
      edges.push_back({node, j < window.high[1] ? lattice_.number({i, j + 1, 0}) : node});
      // Either end of an edge may be the only one that is known.
      if (i > window.low[0]) edges.push_back({node, lattice_.number({i - 1, j, 0})});
      if (j > window.low[1]) edges.push_back({node, lattice_.number({i, j - 1, 0})});
    }
  return edges;
}

/// What comes before a place on the way. A node knows; within an edge it is the best place on another edge of the two
/// cells beside it, or a node of the edge itself.
ArrivalField::Place ArrivalField::before(const Place& place) const {
  if (place.a == place.b || place.t <= 0) return arrivals_[static_cast<std::size_t>(place.a)].from;
  if (place.t >= 1) return arrivals_[static_cast<std::size_t>(place.b)].from;
  const Eigen::VectorXd x = position(place);
  Arrival best;
  const Window beside = cells_beside(place), start = around(problem_.source.u, 1);
  const bool near = beside.low[0] >= start.low[0] - 1 && beside.high[0] <= start.high[0] + 1 &&
                    beside.low[1] >= start.low[1] - 1 && beside.high[1] <= start.high[1] + 1;
  if (near && moves_.clear(source_, x, kNever)) best.cost = move(source_, x);
  // Places that cost less come first. Where a current leaves few directions there may be none between the nodes.
  for (const double below : {cost(place), kNever}) {
    for (const Edge& edge : edges_in(beside)) {
      const bool same = std::min(edge.a, edge.b) == std::min(place.a, place.b) &&
                        std::max(edge.a, edge.b) == std::max(place.a, place.b);
      if (!same) try_edge(edge, x, best, below);
    }
    for (const std::int32_t node : {place.a, place.b}) {  // along the edge, which is clear
      const double c = cost({node, node, 0}) + move(x_.col(node), x);
      if (c < best.cost && cost({node, node, 0}) < below) best = {c, {node, node, 0}};
    }
    if (best.cost < kNever) return best.from;
  }
  throw lost();
}

std::vector<Eigen::Vector2d> ArrivalField::way() const {
  std::vector<Eigen::Vector2d> way = {problem_.target.u};
  for (Place place = at_target_.from; place.a >= 0; place = before(place)) {
    way.push_back(coordinates(place));
    if (way.size() > 2 * arrivals_.size()) throw lost();
  }
  way.emplace_back(problem_.source.u);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace leastcost
