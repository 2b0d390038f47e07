// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/plane/level.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace leastcost::bracket {
namespace {

/// Cells of a front around those that are searched: at the rim a march is wrong, and that spreads with the number of
/// cells it goes. Measured: 24 suffice at 512 cells, 50 at 2048.
int margin_of(const CellGrid& grid) { return std::max(24, std::max(grid.nx, grid.ny) / 40); }

/// By which the density grows so deep in what no path enters. Where it is flat paths dip, by a part of its square;
/// where it is steep u is too steep outside, as its inverse square is. Both are least for a length in the middle
/// between a cell and what obstacles are bent by.
double density_at_depth(const CellGrid& grid, double depth) {
  constexpr double kPart = 0.125, kLeast = 4;  // of the grid; cells
  const double cells = std::max(kLeast, std::sqrt(kPart * std::max(grid.nx, grid.ny)));
  const double deep = depth / (cells * grid.h);
  return 1 + deep * deep;
}

}  // namespace

double Medium::marched(const CellGrid& grid, int i, int j, double depth_here) const {
  const Eigen::Vector2d x = grid.in_box(grid.node(i, j));
  const double n = density != nullptr ? density->density(x) : is_known_at(x) ? 1 : kInfinity;
  return n * density_at_depth(grid, depth_here);
}

bool Medium::is_known_at(const Eigen::Vector2d& x) const {
  return dual != nullptr ? std::isfinite(dual->dual(x).xx) : CoordinateCost::Element(*sampled, x).is_inside();
}

EndRegion Medium::end_region(const CellGrid& grid, const Eigen::Vector2d& place, int k, bool reversed) const {
  if (sampled != nullptr) return bracket::end_region(*sampled, grid, place, k, reversed);
  return dual != nullptr ? bracket::end_region(*dual, grid, place, k, reversed)
                         : bracket::end_region(*density, grid, place, k);
}

/// Where the domain has no places fronts run on as in obstacles: with the norm of the nearest node that has one, and a
/// density that grows. `unknown`: nodes there, in the part that is marched over.
void fill_unknown(Level& level, std::vector<int> unknown) {
  constexpr int kLayers = 12;
  const CellGrid& grid = level.grid;
  for (int layer = 1; layer <= kLayers && !unknown.empty(); ++layer) {
    std::vector<int> rest;
    std::vector<std::pair<int, int>> filled;
    for (const int node : unknown) {
      int from = -1;
      for (int b = -1; b <= 1; ++b)
        for (int a = -1; a <= 1; ++a) {
          const int i = grid.column(node) + a, j = grid.row(node) + b;
          const bool inside = i >= 0 && j >= 0 && i < grid.stride() && j < grid.ny + 2;
          if (inside && level.norms.knows(static_cast<std::size_t>(grid.id(i, j)))) from = grid.id(i, j);
        }
      if (from < 0)
        rest.push_back(node);
      else
        filled.emplace_back(node, from);
    }
    for (const auto& [node, from] : filled) {
      level.norms.take_over(static_cast<std::size_t>(node), static_cast<std::size_t>(from));
      level.density[static_cast<std::size_t>(node)] = density_at_depth(grid, layer * grid.h);
    }
    unknown = std::move(rest);
  }
}

void fill_density(const Medium& medium, Level& level, const StopLook& look) {
  const CellGrid& grid = level.grid;
  level.density.assign(static_cast<std::size_t>(grid.nodes()), kInfinity);
  if (medium.dual != nullptr) level.duals.resize(level.density.size());
  if (medium.sampled != nullptr) level.norms.reset(level.density.size(), medium.directions);
  std::vector<unsigned char> is_deep(medium.depth ? level.density.size() : 0, 0);
  level.cells.clear();
  const int around = margin_of(grid);
  std::vector<unsigned char> seen(level.density.size(), 0);
  std::vector<int> unknown;
  for (int j = 1; j <= grid.ny; ++j)
    for (int i = 1; i <= grid.nx; ++i) {
      if (!level.searched[static_cast<std::size_t>(grid.id(i, j))]) continue;
      look.now_and_then();
      level.cells.push_back(grid.id(i, j));
      const auto inside = [&](int a, int b) { return level.searched[static_cast<std::size_t>(grid.id(a, b))] != 0; };
      const bool inner = inside(i + 1, j) && inside(i - 1, j) && inside(i, j + 1) && inside(i, j - 1);
      const int margin = inner ? 0 : around;
      for (int b = std::max(0, j - margin); b <= std::min(grid.ny + 1, j + margin); ++b)
        for (int a = std::max(0, i - margin); a <= std::min(grid.nx + 1, i + margin); ++a) {
          const auto node = static_cast<std::size_t>(grid.id(a, b));
          if (std::exchange(seen[node], 1) != 0) continue;
          const double deep = medium.depth_of(grid, a, b);
          if (deep > 0) is_deep[node] = 1;
          const double n = level.density[node] = medium.marched(grid, a, b, deep);
          if (medium.dual != nullptr) level.duals[node] = medium.dual->dual(grid.in_box(grid.node(a, b)));
          if (medium.sampled == nullptr) continue;
          if (n < kInfinity)
            level.norms.learn(node, {*medium.sampled, grid.in_box(grid.node(a, b))});
          else
            unknown.push_back(grid.id(a, b));
        }
    }
  if (medium.sampled != nullptr) fill_unknown(level, std::move(unknown));
  level.blocked.clear();
  if (!medium.depth) return;
  for (const int node : level.cells) {
    const int i = grid.column(node), j = grid.row(node);
    bool beside = false;
    for (int b = -1; b <= 1; ++b)
      for (int a = -1; a <= 1; ++a) beside = beside || is_deep[static_cast<std::size_t>(grid.id(i + a, j + b))];
    level.blocked.push_back(beside ? BlockedParts(medium.depth, grid, i, j) : BlockedParts());
  }
}

void fill_level(const Medium& medium, Level& level, const StopLook& look) {
  fill_density(medium, level, look);
  level.floors.clear();
  level.dual_cells.clear();
  if (medium.sampled != nullptr) {
    level.sampled_cells = SampledCells(*medium.sampled, level.grid, level.cells);
    return;
  }
  for (const int node : level.cells) {
    look.now_and_then();
    const int i = level.grid.column(node), j = level.grid.row(node);
    if (medium.dual != nullptr)
      level.dual_cells.push_back(dual_cell(*medium.dual, level.grid, i, j));
    else
      level.floors.push_back(density_floor(*medium.density, level.grid, i, j));
  }
}

Level whole_level(const Medium& medium, const Eigen::AlignedBox2d& box, int cells, const StopLook& look) {
  Level level;
  level.grid = CellGrid::over(box, cells);
  level.searched.assign(static_cast<std::size_t>(level.grid.nodes()), 0);
  for (int j = 1; j <= level.grid.ny; ++j)
    for (int i = 1; i <= level.grid.nx; ++i)
      level.searched[static_cast<std::size_t>(level.grid.id(i, j))] = medium.is_blocked(level.grid, i, j) ? 0 : 1;
  fill_level(medium, level, look);
  return level;
}

}  // namespace leastcost::bracket
