// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

#include "problems/graph/shortest_route.hpp"

namespace leastcost {

/// Nodes in a box of a regular lattice, in the plane (count[2] = 1) or in space. Node (i, j, k) has the number
/// i + count[0] (j + count[1] k).
struct Lattice {
  std::array<std::int32_t, 3> count = {1, 1, 1};

  std::int64_t size() const { return std::int64_t{count[0]} * count[1] * count[2]; }
  std::int32_t number(const std::array<std::int32_t, 3>& at) const {
    return at[0] + count[0] * (at[1] + count[1] * at[2]);
  }
  std::array<std::int32_t, 3> place(std::int32_t node) const {
    return {node % count[0], node / count[0] % count[1], node / count[0] / count[1]};
  }
};

/// A move from a node to one of its neighbours: 8 in the plane, 26 in space.
using LatticeStep = std::array<std::int32_t, 3>;
std::vector<LatticeStep> steps_of(const Lattice& lattice);

/// Least length of a way over the steps of a lattice, in sides of its cells: the octile distance of the plane, and its
/// like in space.
inline double octile_distance(const std::array<std::int32_t, 3>& from, const std::array<std::int32_t, 3>& to) {
  const std::int32_t x = std::abs(from[0] - to[0]), y = std::abs(from[1] - to[1]), z = std::abs(from[2] - to[2]);
  const std::int32_t most = std::max({x, y, z}), least = std::min({x, y, z}), middle = x + y + z - most - least;
  return std::numbers::sqrt3 * least + std::numbers::sqrt2 * (middle - least) + (most - middle);
}

struct AllPassable {
  bool operator()(std::int32_t, std::int32_t) const { return true; }
};

/// What a search knows of a node.
struct LatticeNode {
  double cost = std::numeric_limits<double>::infinity();
  std::int32_t before = -1;
};
/// A node in its queue: least key first, of equal ones the one that has come furthest.
struct OpenLatticeNode {
  double key, cost;
  std::int32_t node, before;
  bool operator<(const OpenLatticeNode& other) const { return key != other.key ? key > other.key : cost < other.cost; }
};

/// The least-cost route over the moves of a lattice from one of `starts` to one of `ends`: A*.
///   cost(from, place of from, k)  of the step steps_of(lattice)[k] from a node, >= 0; +infinity: not passable. Asked
///                                 only for steps that stay in the lattice
///   bound(node, place)            at most what is left from a node to the end of the route, the cost of that end
///                                 included, and consistent; 0 makes it Dijkstra's algorithm
///   passable(from, to)            whether a step may be made at all: for what is dear to find out, asked only of steps
///                                 that a least-cost route may need (lazy A*)
/// `stop` is asked now and then; true: give up.
template <class Cost, class Bound, class Passable = AllPassable>
GraphRoute lattice_route(const Lattice& lattice, const std::vector<RouteEnd>& starts, std::vector<RouteEnd> ends,
                         const Cost& cost, const Bound& bound, const std::function<bool()>& stop = {},
                         const Passable& passable = {}) {
  constexpr bool kLazy = !std::is_same_v<Passable, AllPassable>;
  constexpr std::int32_t kStopInterval = 256;  // settled nodes between two questions to the stop predicate
  const std::vector<LatticeStep> steps = steps_of(lattice);
  std::vector<LatticeNode> nodes(static_cast<std::size_t>(lattice.size()));
  std::vector<char> settled(nodes.size(), 0);
  std::priority_queue<OpenLatticeNode> open;
  const auto reach = [&](std::int32_t node, const std::array<std::int32_t, 3>& at, double total, std::int32_t before) {
    LatticeNode& record = nodes[static_cast<std::size_t>(node)];
    if (!(total < (kLazy ? std::numeric_limits<double>::infinity() : record.cost))) return;
    if (!kLazy) record.cost = total;
    open.push({total + bound(node, at), total, node, before});
  };
  std::sort(ends.begin(), ends.end(), [](const RouteEnd& a, const RouteEnd& b) { return a.node < b.node; });
  for (const RouteEnd& start : starts) reach(start.node, lattice.place(start.node), start.cost, -1);
  GraphRoute route;
  std::int32_t last = -1;
  while (!open.empty()) {
    const OpenLatticeNode next = open.top();
    open.pop();
    if (!(next.key < route.cost)) break;
    if (settled[static_cast<std::size_t>(next.node)] != 0) continue;
    if (next.before >= 0 && !passable(next.before, next.node)) continue;
    settled[static_cast<std::size_t>(next.node)] = 1;
    nodes[static_cast<std::size_t>(next.node)] = {next.cost, next.before};
    if (++route.settled % kStopInterval == 0 && stop && stop()) {
      route.outcome = RouteOutcome::stopped;
      return route;
    }
    const auto end = std::lower_bound(ends.begin(), ends.end(), next.node,
                                      [](const RouteEnd& e, std::int32_t node) { return e.node < node; });
    if (end != ends.end() && end->node == next.node && next.cost + end->cost < route.cost) {
      route.cost = next.cost + end->cost;
      last = next.node;
    }
    const std::array<std::int32_t, 3> at = lattice.place(next.node);
    for (std::size_t k = 0; k < steps.size(); ++k) {
      std::array<std::int32_t, 3> to = at;
      bool inside = true;
      for (std::size_t d = 0; d < 3; ++d) {
        to[d] += steps[k][d];
        inside = inside && to[d] >= 0 && to[d] < lattice.count[d];
      }
      if (!inside) continue;
      const std::int32_t node = lattice.number(to);
      if (settled[static_cast<std::size_t>(node)] != 0) continue;
      reach(node, to, next.cost + cost(next.node, at, k), next.node);
    }
  }
  if (last < 0) return route;
  route.outcome = RouteOutcome::found;
  for (std::int32_t node = last; node >= 0; node = nodes[static_cast<std::size_t>(node)].before)
    route.nodes.push_back(node);
  std::reverse(route.nodes.begin(), route.nodes.end());
  return route;
}

}  // namespace leastcost
