// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "problems/bracket/space/cube_check.hpp"
#include "problems/bracket/space/end_ball.hpp"
#include "problems/bracket/space/space_marching.hpp"

namespace leastcost::bracket {

/// What paths in space run through: a density, and obstacles that no path enters. `depth` of a place is at most its
/// distance from all places outside them, positive inside; none: there are no obstacles.
struct SpaceMedium {
  const SpaceDensity& density;
  const std::function<double(const Eigen::Vector3d&)>& depth;

  /// Whether a cell lies within the obstacles, so that nothing need be proved in it.
  bool is_blocked(const SpaceGrid& grid, const Place& cell) const {
    constexpr double kHalfDiagonal = 0.8660255 * (1 + 1e-9), kRounding = 16;
    return depth && depth(grid.node(cell)) > kHalfDiagonal * grid.h + kRounding * grid.slack();
  }
  /// The density that fronts are marched with: within obstacles it grows, from where no cell is searched any more, so
  /// that potentials go on smoothly a little way.
  double marched(const SpaceGrid& grid, const Place& cell) const;
};

/// One grid, of which the nodes in and around the part are there in which a cheaper path may run. Vectors by node.
struct SpaceLevel {
  SpaceGrid grid;
  NodeSet nodes;
  std::vector<double> density;          ///< n; infinite where fronts do not go
  std::vector<unsigned char> searched;  ///< its cell may hold a cheaper path, the inequality is checked in it
  std::vector<int> cells;               ///< those nodes
  std::vector<int> floor_of;            ///< per cell: which of the floors is its own
  std::vector<SpaceFloor> floors;
};

/// The whole box. Throws Stopped.
SpaceLevel whole_space_level(const SpaceMedium& medium, const Eigen::AlignedBox3d& box, int cells,
                             const StopLook& look);

/// The density at the nodes. Throws Stopped.
void fill_density(const SpaceMedium& medium, SpaceLevel& level, const StopLook& look);

/// What a potential is marched from: values at seeds, and the density, which corrections change. `sign`: per node;
/// empty: all 1. `order`: of the nodes in the first march, which the others follow.
struct SpaceFront {
  std::vector<int> seeds;
  std::vector<double> values;  ///< at the seeds, infinite elsewhere
  std::vector<double> density;
  std::vector<signed char> sign;
  std::vector<int> order;
};

/// From an end: the cost of the straight move, less what the least cost is below it, near it.
SpaceFront front_around(const SpaceMedium& medium, const SpaceLevel& level, const EndBall& ball);

/// Marches, `corrections` times with a density for which the central differences of the outcome have the length of n:
/// second order instead of first.
std::vector<double> march(const SpaceLevel& level, SpaceFront& front, int corrections, SpaceMarching& marching);

/// Proved ratios of |grad u| to n in the searched cells outside the balls; returns the largest, at least 1.
double check(const SpaceLevel& level, const std::vector<double>& u, const EndBall& s, const EndBall& t,
             std::vector<double>& ratios, const StopLook& look);

/// Lowers the density where the ratio exceeds 1, so that the next march has less of an excess there.
void deflate(const SpaceLevel& level, const std::vector<double>& ratios, SpaceFront& front);

/// The cost from an end to the nodes, nearly, of second order: nothing is proved.
struct SpaceDistance {
  EndBall ball;
  std::vector<double> u;
  SpaceFront front;  ///< with the density that it was marched with
};
SpaceDistance distance_field(const SpaceMedium& medium, const SpaceLevel& level, const EndBall& ball,
                             SpaceMarching& marching);

/// A proved lower bound of the cost from an end to any place: u / ratio + offset outside the ball of the end, its cone
/// within.
struct SpaceDistanceBound {
  EndBall ball;
  std::vector<double> u;
  double ratio = kInfinity, offset = 0;
};
/// The one of some that is highest at the other end, nearly.
SpaceDistanceBound distance_bound(const SpaceLevel& level, SpaceDistance field, const Eigen::Vector3d& other,
                                  SpaceMarching& marching);

}  // namespace leastcost::bracket
