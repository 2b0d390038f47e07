// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/space/space_tube.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace leastcost::bracket {
namespace {

double least_of(const CubeNet& net) {
  double least = kInfinity;
  for (const double value : net) least = value < least || value != value ? value : least;
  return least;
}

/// The sum of both bounds on a cell outside the balls of the ends, as a net that is nowhere above it.
CubeNet sum_net(const NodeSet& nodes, const SpaceDistanceBound& a, const SpaceDistanceBound& b, int node) {
  const CubeNet ca = around(nodes, a.u, node), cb = around(nodes, b.u, node);
  const CubeNet va = value_net(ca), vb = value_net(cb);
  // Three averages, the sum, and as many averages as parts of parts take.
  const double size = largest_of(ca) / a.ratio + largest_of(cb) / b.ratio + std::abs(a.offset) + std::abs(b.offset);
  CubeNet sum;
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] = va[k] / a.ratio + vb[k] / b.ratio + a.offset + b.offset - 64 * kEps * size;
  return sum;
}

/// Calls f with the places of those of parts^3 equal parts of a cell on which the net is somewhere at most `upper`, the
/// eight of a cube after each other. `first`: the place of the first part.
template <class F>
void for_parts_below(const CubeNet& net, double upper, const Place& first, int parts, const F& f) {
  if (least_of(net) > upper) return;
  if (parts == 1) return f(first);
  const int half = parts / 2;
  for (const int z : {0, 1}) {
    const CubeNet layer = half_of(net, 2, z == 1);
    for (const int y : {0, 1}) {
      const CubeNet column = half_of(layer, 1, y == 1);
      for (const int x : {0, 1})
        for_parts_below(half_of(column, 0, x == 1), upper,
                        {first[0] + x * half, first[1] + y * half, first[2] + z * half}, half, f);
    }
  }
}

/// Flags of the places of a grid and of the layer around it.
class PlaceFlags {
 public:
  explicit PlaceFlags(const Place& cells)
      : size_{cells[0] + 2, cells[1] + 2, cells[2] + 2},
        flags_(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
               static_cast<std::size_t>(size_[2])) {}
  unsigned char& at(const Place& p) {
    return flags_[(static_cast<std::size_t>(p[2]) * static_cast<std::size_t>(size_[1]) +
                   static_cast<std::size_t>(p[1])) *
                      static_cast<std::size_t>(size_[0]) +
                  static_cast<std::size_t>(p[0])];
  }
  /// Sets those within `reach` of a flag along each axis.
  void spread(int reach) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      PlaceFlags out = *this;
      Place p;
      for (p[2] = 0; p[2] < size_[2]; ++p[2])
        for (p[1] = 0; p[1] < size_[1]; ++p[1])
          for (p[0] = 0; p[0] < size_[0]; ++p[0]) {
            if (!at(p)) continue;
            Place q = p;
            const int begin = std::max(0, p[axis] - reach), end = std::min(size_[axis] - 1, p[axis] + reach);
            for (q[axis] = begin; q[axis] <= end; ++q[axis]) out.at(q) = 1;
          }
      flags_ = std::move(out.flags_);
    }
  }

 private:
  Place size_;
  std::vector<unsigned char> flags_;
};

/// The cell of the coarse grid that holds a cell of the fine one; the layers around them correspond.
int coarse_index(int fine, int parts) { return (fine + parts - 1) / parts; }

/// All nodes of the fine grid in coarse cells around those that hold one of `cells`: at the rim of its nodes a march is
/// wrong, and that spreads with the number of cells it goes.
NodeSet nodes_around(const SpaceGrid& coarse, const SpaceGrid& fine, const std::vector<Place>& cells, int parts) {
  constexpr int kMargin = 8;  // fine cells; 12 and 6 give the same bounds
  PlaceFlags flags(coarse.cells);
  for (const Place& p : cells)
    flags.at({coarse_index(p[0], parts), coarse_index(p[1], parts), coarse_index(p[2], parts)}) = 1;
  flags.spread((kMargin + parts - 1) / parts);
  std::vector<Place> places;
  for (int k = 0; k <= fine.cells[2] + 1; ++k)
    for (int j = 0; j <= fine.cells[1] + 1; ++j)
      for (int i = 0; i <= coarse.cells[0] + 1; ++i) {
        if (!flags.at({i, coarse_index(j, parts), coarse_index(k, parts)})) continue;
        if (i == 0) places.push_back({0, j, k});
        if (i > coarse.cells[0]) places.push_back({fine.cells[0] + 1, j, k});
        if (i == 0 || i > coarse.cells[0]) continue;
        for (int p = 1; p <= parts; ++p) places.push_back({(i - 1) * parts + p, j, k});
      }
  return NodeSet(std::move(places), fine.cells);
}

}  // namespace

std::vector<Place> reached_cells(const SpaceMedium& medium, const SpaceLevel& coarse, const SpaceDistanceBound& from_s,
                                 const SpaceDistanceBound& from_t, double upper, int parts, const StopLook& look) {
  const SpaceGrid fine = coarse.grid.refined(parts);
  std::vector<Place> out;
  for (const int node : coarse.cells) {
    look.now_and_then();
    const Place& p = coarse.nodes.place(node);
    const bool at_end = from_s.ball.holds(p) || from_t.ball.holds(p);
    CubeNet sum;
    sum.fill(-kInfinity);
    if (!at_end) sum = sum_net(coarse.nodes, from_s, from_t, node);
    for_parts_below(sum, upper, {(p[0] - 1) * parts + 1, (p[1] - 1) * parts + 1, (p[2] - 1) * parts + 1}, parts,
                    [&](const Place& part) {
                      if (!fine.cell(part).isEmpty() && !medium.is_blocked(fine, part)) out.push_back(part);
                    });
  }
  return out;
}

SpaceLevel tube_level(const SpaceMedium& medium, const SpaceGrid& coarse, const std::vector<Place>& cells, int parts,
                      const StopLook& look) {
  SpaceLevel level;
  level.grid = coarse.refined(parts);
  level.nodes = nodes_around(coarse, level.grid, cells, parts);
  look();
  level.searched.assign(level.nodes.size() + 1, 0);
  Place last = {-1, -1, -1};
  for (const Place& p : cells) {
    look.now_and_then();
    const int node = level.nodes.find(p);
    level.searched[static_cast<std::size_t>(node)] = 1;
    level.cells.push_back(node);
    const Place cube = {(p[0] - 1) / 2, (p[1] - 1) / 2, (p[2] - 1) / 2};
    if (cube != last) {
      const Eigen::Vector3d middle(2 * cube[0] + 1.5, 2 * cube[1] + 1.5, 2 * cube[2] + 1.5);
      level.floors.push_back(space_floor(medium.density, level.grid.cube(middle, 1)));
    }
    last = cube;
    level.floor_of.push_back(static_cast<int>(level.floors.size()) - 1);
  }
  fill_density(medium, level, look);
  return level;
}

}  // namespace leastcost::bracket
