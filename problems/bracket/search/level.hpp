// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "problems/bracket/cells/blocked_parts.hpp"
#include "problems/bracket/search/growth.hpp"
#include "problems/bracket/search/medium.hpp"
#include "problems/bracket/search/obstacles.hpp"

namespace leastcost::bracket {

/// One grid, of which a part is searched, and what is known there of the medium and of obstacles.
template <Medium M>
struct Level : Part<M::kDimension> {
  typename M::Known known;
  std::vector<Blocked<M::kDimension>> blocked;  ///< per cell; empty where there are no obstacles
};

/// What a path runs through.
template <Medium M>
struct Setting {
  M medium;
  Obstacles<M::kDimension> obstacles;
};

/// Calls f with the nodes of a part that fronts go to, those in and around the searched cells: at the rim a march is
/// wrong, and that spreads with the number of cells it goes. Measured in the plane: 24 suffice at 512 cells, 50 at
/// 2048.
template <class F>
void for_nodes_of_fronts(const Part<2>& part, const F& f) {
  const int around = std::max(24, part.grid.longest() / 40);
  std::vector<unsigned char> seen(part.density.size(), 0);
  for (const int cell : part.cells) {
    const std::array<int, 4> beside = part.nodes.beside(cell);
    const bool inner = std::ranges::all_of(beside, [&](int n) { return part.searched[static_cast<std::size_t>(n)]; });
    const int margin = inner ? 0 : around;
    const auto [i, j] = part.nodes.place(cell);
    for (int b = std::max(0, j - margin); b <= std::min(part.grid.cells[1] + 1, j + margin); ++b)
      for (int a = std::max(0, i - margin); a <= std::min(part.grid.cells[0] + 1, i + margin); ++a) {
        const int node = part.nodes.find({a, b});
        if (std::exchange(seen[static_cast<std::size_t>(node)], 1) == 0) f(node);
      }
  }
}
/// All nodes that are there: of which there are no others.
template <class F>
void for_nodes_of_fronts(const Part<3>& part, const F& f) {
  for (int node = 0; node < part.nodes.none(); ++node) f(node);
}

/// Which parts of the cells lie within obstacles. `is_deep`: per node.
template <class L>
void fill_blocked(const Obstacles<2>& obstacles, const std::vector<unsigned char>& is_deep, L& level) {
  for (const int cell : level.cells) {
    bool beside = false;
    for (const int row : level.nodes.rows_around(cell))
      for (int p = -1; p <= 1; ++p) beside = beside || is_deep[static_cast<std::size_t>(row + p)];
    level.blocked.push_back(beside ? BlockedParts(obstacles.depth(), level.grid, level.nodes.place(cell))
                                   : BlockedParts());
  }
}
template <class L>
void fill_blocked(const Obstacles<3>&, const std::vector<unsigned char>&, L&) {}

/// All that is known of a part, from its grid, nodes and searched cells on. Throws Stopped.
template <Medium M>
void fill_level(const Setting<M>& setting, bool is_fine, Level<M>& level, const StopLook& look) {
  level.density.assign(level.nodes.size() + 1, kInfinity);
  level.known.begin(setting.medium, level);
  std::vector<unsigned char> is_deep(setting.obstacles.any() ? level.density.size() : 0, 0);
  for_nodes_of_fronts(level, [&](int node) {
    look.now_and_then();
    const auto at = static_cast<std::size_t>(node);
    const Place<M::kDimension> place = level.nodes.place(node);
    const Vector<M::kDimension> x = level.grid.in_box(level.grid.node(place));
    const double deep = setting.obstacles.depth_of(level.grid, place);
    if (deep > 0) is_deep[at] = 1;
    const double n = setting.medium.density(x) * growth_at_depth(level.grid, deep);
    if (n > 0) level.density[at] = n;  // not where it is unknown
    level.known.learn_node(setting.medium, level, node, x);
  });
  level.known.end_of_nodes(level);
  if (setting.obstacles.any()) fill_blocked(setting.obstacles, is_deep, level);
  for (const int cell : level.cells) {
    look.now_and_then();
    level.known.learn_cell(setting.medium, level, cell, is_fine);
  }
  level.known.end_of_cells(setting.medium, level);
}

/// The whole box. Throws Stopped.
template <Medium M>
Level<M> whole_level(const Setting<M>& setting, const Box<M::kDimension>& box, int cells, const StopLook& look) {
  Level<M> level;
  level.grid = Grid<M::kDimension>::over(box, cells);
  level.nodes = Nodes<M::kDimension>(level.grid.cells);
  level.searched.assign(level.nodes.size() + 1, 0);
  for (int node = 0; node < level.nodes.none(); ++node) {
    const Place<M::kDimension> place = level.nodes.place(node);
    if (!level.grid.is_cell(place) || setting.obstacles.hold(level.grid, place)) continue;
    level.searched[static_cast<std::size_t>(node)] = 1;
    level.cells.push_back(node);
  }
  fill_level(setting, false, level, look);
  return level;
}

}  // namespace leastcost::bracket
