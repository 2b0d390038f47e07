// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "problems/bracket/search/distance_bound.hpp"

namespace leastcost::bracket {

/// The sum of both bounds on a cell outside the sets around the ends, as a net that is nowhere above it.
template <Medium M>
Net<M::kDimension> sum_net(const Level<M>& level, const DistanceBound<M>& a, const DistanceBound<M>& b, int node) {
  constexpr int N = M::kDimension;
  const Net<N> va = value_net<N>(around(level.nodes, a.u, node)), vb = value_net<N>(around(level.nodes, b.u, node));
  Net<N> sum;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    const double x = std::min(va[k], a.cap) / a.ratio, y = std::min(vb[k], b.cap) / b.ratio;
    const double size = std::abs(x) + std::abs(y) + std::abs(a.offset) + std::abs(b.offset);
    sum[k] = x + y + a.offset + b.offset - 64 * kEps * size;
  }
  return sum;
}

/// Calls f with the places of those of parts^N equal parts of a cell on which the net is somewhere at most `upper`, the
/// 2^N of a cube after each other. `first`: the place of the first part.
template <int N, class F>
void for_parts_below(const Net<N>& net, double upper, const Place<N>& first, int parts, const F& f) {
  if (least_of(net) > upper) return;
  if (parts == 1) return f(first);
  for_halves<N>(net, [&](const Net<N>& of_half, const Place<N>& half) {
    Place<N> place = first;
    for (std::size_t k = 0; k < place.size(); ++k) place[k] += half[k] * parts / 2;
    for_parts_below<N>(of_half, upper, place, parts / 2, f);
  });
}

/// The cells of a level that a path of at most `upper` may enter: the bounds from both ends add up to no more there.
/// Whoever enters another one pays more, proved. By place, in cells `parts` times as fine.
template <Medium M>
std::vector<Place<M::kDimension>> reached_cells(const Obstacles<M::kDimension>& obstacles, const Level<M>& coarse,
                                                const DistanceBound<M>& from_s, const DistanceBound<M>& from_t,
                                                double upper, int parts, const StopLook& look) {
  constexpr int N = M::kDimension;
  const Grid<N> fine = coarse.grid.refined(parts);
  std::vector<Place<N>> out;
  for (const int node : coarse.cells) {
    look.now_and_then();
    const Place<N> p = coarse.nodes.place(node);
    const bool at_end = from_s.end.holds(p) || from_t.end.holds(p);
    const Net<N> sum = at_end ? net_of<N>(-kInfinity) : sum_net(coarse, from_s, from_t, node);
    Place<N> first = p;
    for (int& number : first) number = (number - 1) * parts + 1;
    for_parts_below<N>(sum, upper, first, parts, [&](const Place<N>& part) {
      if (!fine.cell(part).isEmpty() && !obstacles.hold(fine, part)) out.push_back(part);
    });
  }
  return out;
}

/// A finer level, of which these cells are searched, with the nodes around them that fronts need. `cells`: those of one
/// cube of 2^N cells after each other. Throws Stopped.
template <Medium M>
Level<M> tube_level(const Setting<M>& setting, const Grid<M::kDimension>& coarse,
                    const std::vector<Place<M::kDimension>>& cells, int parts, const StopLook& look) {
  Level<M> level;
  level.grid = coarse.refined(parts);
  level.nodes = nodes_around(coarse, level.grid, cells, parts);
  look();
  level.searched.assign(level.nodes.size() + 1, 0);
  for (const Place<M::kDimension>& p : cells) {
    level.cells.push_back(level.nodes.find(p));
    level.searched[static_cast<std::size_t>(level.cells.back())] = 1;
  }
  if constexpr (M::kDimension == 2) std::ranges::sort(level.cells);  // as they lie in memory
  fill_level(setting, true, level, look);
  return level;
}

}  // namespace leastcost::bracket
