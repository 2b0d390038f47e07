// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/plane/tube.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leastcost::bracket {
namespace {

/// Bernstein coefficients on one of `parts` equal parts of [0, 1], a power of two, by halving.
std::array<double, 3> on_part(std::array<double, 3> c, int part, int parts) {
  for (; parts > 1; parts /= 2) {
    const double l = 0.5 * (c[0] + c[1]), r = 0.5 * (c[1] + c[2]), m = 0.5 * (l + r);
    const bool right = part >= parts / 2;
    c = right ? std::array<double, 3>{m, r, c[2]} : std::array<double, 3>{c[0], l, m};
    if (right) part -= parts / 2;
  }
  return c;
}

Net on_part(const Net& net, int px, int py, int parts) {
  Net out;
  for (std::size_t q = 0; q < 3; ++q) out[q] = on_part(net[q], px, parts);
  for (std::size_t p = 0; p < 3; ++p) {
    const std::array<double, 3> column = on_part({out[0][p], out[1][p], out[2][p]}, py, parts);
    for (std::size_t q = 0; q < 3; ++q) out[q][p] = column[q];
  }
  return out;
}

double least_of(const Net& net) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& row : net)
    for (const double value : row) least = value < least || value != value ? value : least;
  return least;
}

/// The sum of both bounds on a cell outside the regions of the ends, as a net that is nowhere above it.
Net sum_net(const CellGrid& grid, const DistanceBound& a, const DistanceBound& b, int node) {
  const auto at = static_cast<std::size_t>(node);
  const Net va = value_net(a.u, grid.stride(), at), vb = value_net(b.u, grid.stride(), at);
  Net sum;
  for (std::size_t q = 0; q < 3; ++q)
    for (std::size_t p = 0; p < 3; ++p) {
      const double x = std::min(va[q][p], a.cap) / a.ratio, y = std::min(vb[q][p], b.cap) / b.ratio;
      const double size = std::abs(x) + std::abs(y) + std::abs(a.offset) + std::abs(b.offset);
      sum[q][p] = x + y + a.offset + b.offset - 64 * kEps * size;
    }
  return sum;
}

/// The same, but where nothing is known, in the region of an end.
Net sum_net_or_nothing(const Level& level, const DistanceBound& from_s, const DistanceBound& from_t, int node) {
  const int i = level.grid.column(node), j = level.grid.row(node);
  if (!from_s.region.holds(i, j) && !from_t.region.holds(i, j)) return sum_net(level.grid, from_s, from_t, node);
  Net nothing;
  for (auto& row : nothing) row.fill(-kInfinity);
  return nothing;
}

}  // namespace

long reached_cells(const Level& level, const DistanceBound& from_s, const DistanceBound& from_t, double upper) {
  return std::ranges::count_if(
      level.cells, [&](int node) { return !(least_of(sum_net_or_nothing(level, from_s, from_t, node)) > upper); });
}

Level tube_level(const Medium& medium, const Level& coarse, const DistanceBound& from_s, const DistanceBound& from_t,
                 double upper, int parts, const StopLook& look) {
  const CellGrid& old = coarse.grid;
  Level level;
  level.grid = old.refined(parts);
  level.searched.assign(static_cast<std::size_t>(level.grid.nodes()), 0);
  for (const int node : coarse.cells) {
    const int i = old.column(node), j = old.row(node);
    const Net sum = sum_net_or_nothing(coarse, from_s, from_t, node);
    if (least_of(sum) > upper) continue;
    for (int py = 0; py < parts; ++py)
      for (int px = 0; px < parts; ++px) {
        if (least_of(on_part(sum, px, py, parts)) > upper) continue;
        const int a = (i - 1) * parts + 1 + px, b = (j - 1) * parts + 1 + py;
        if (level.grid.cell(a, b).isEmpty() || medium.is_blocked(level.grid, a, b)) continue;
        level.searched[static_cast<std::size_t>(level.grid.id(a, b))] = 1;
      }
  }
  fill_level(medium, level, look);
  return level;
}

}  // namespace leastcost::bracket
