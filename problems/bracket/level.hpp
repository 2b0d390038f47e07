// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "problems/bracket/end_region.hpp"
#include "problems/bracket/fast_marching.hpp"
#include "problems/bracket/spline_check.hpp"

namespace leastcost::bracket {

/// What paths run through: a density, and obstacles that no path enters. `depth` of a place is at most its distance
/// from all places outside them, positive inside; none: there are no obstacles.
struct Medium {
  const CostDensity& density;
  const std::function<double(const Eigen::Vector2d&)>& depth;

  /// Whether a cell lies within the obstacles, so that nothing need be proved in it.
  bool is_blocked(const CellGrid& grid, int i, int j) const {
    constexpr double kHalfDiagonal = 0.70711 * (1 + 1e-9);
    return depth && depth(grid.node(i, j)) > kHalfDiagonal * grid.h;
  }
  /// The density that fronts are marched with: within obstacles it grows, from where no cell is searched any more, so
  /// that potentials go on smoothly a little way.
  double marched(const CellGrid& grid, int i, int j) const;
};

/// One grid, and the part of it in which a cheaper path may run.
struct Level {
  CellGrid grid;
  std::vector<double> density;          ///< n at the nodes; infinite where fronts do not go
  std::vector<unsigned char> searched;  ///< per node: its cell may hold a cheaper path, the inequality is checked in it
  std::vector<int> cells;               ///< those nodes
  std::vector<Net> floors;              ///< per cell: what is below n
};

/// The whole box. These throw Stopped.
Level whole_level(const Medium& medium, const Eigen::AlignedBox2d& box, int cells, const StopLook& look);

/// Fills the density in and around the searched cells.
void fill_density(const Medium& medium, Level& level, const StopLook& look);

/// The same, and the bounds of the searched cells.
void fill_level(const Medium& medium, Level& level, const StopLook& look);

/// What a potential is marched from: values at seeds, and the density, which corrections change. `sign`: per node;
/// empty: all 1.
struct Front {
  std::vector<int> seeds;
  std::vector<double> values;  ///< at the seeds, infinite elsewhere
  std::vector<double> density;
  std::vector<signed char> sign;
};

/// From an end: the cost of the straight move, less what the least cost is below it, near it.
Front front_around(const CostDensity& density, const Level& level, const EndRegion& region);

/// Marches, `corrections` times with a density for which the central differences of the outcome have the length of n:
/// second order instead of first.
std::vector<double> march(const Level& level, Front& front, int corrections, FastMarching& marching);

/// Proved ratios of |grad u| to n in the searched cells outside the regions; returns the largest, at least 1.
double check(const Level& level, const std::vector<double>& u, const EndRegion& s, const EndRegion& t,
             std::vector<double>& ratios);

/// Lowers the density where the ratio exceeds 1, so that the next march has less of an excess there.
void deflate(const Level& level, const std::vector<double>& ratios, Front& front);

/// The cost from an end to the nodes, nearly, of second order: nothing is proved.
struct DistanceField {
  EndRegion region;
  std::vector<double> u;
  Front front;  ///< with the density that it was marched with
};
DistanceField distance_field(const CostDensity& density, const Level& level, const EndRegion& region,
                             FastMarching& marching);

/// A proved lower bound of the cost from an end to any place: u / ratio + offset outside the region of the end, its
/// cone within.
struct DistanceBound {
  EndRegion region;
  std::vector<double> u;
  double ratio = 1, offset = 0;
};
DistanceBound distance_bound(const Level& level, DistanceField field, FastMarching& marching);

}  // namespace leastcost::bracket
