// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/path/path.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// How far a delivered path stays from the obstacles: the least over all of its segments, not over its points, of the
/// distance minus what is required; length units.
struct Clearance {
  double lower = 0;       ///< a bound, rounding included
  double upper = 0;       ///< attained at `place`
  std::string obstacle;   ///< the nearest; empty: there is none
  Index segment = 0;      ///< on which it is nearest
  Eigen::VectorXd place;  ///< ambient
  bool proved = true;     ///< `lower` holds for every point of the curve; else for points along it only
};

/// Of a curve (ambient x points; `ring`: closed); nothing where the domain has no obstacles. Throws Interrupted.
std::optional<Clearance> measure_clearance(const ConstraintManifold& manifold, const Points& curve, bool ring,
                                           const Deadline& deadline);

/// Whether a straight move is known to touch nothing, but for the rounding of an end that is in contact.
bool goes_clear(const ChecksMoves& obstacles, const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// "is 0.1 too close to the ball at (0, 0)" of an end within the clearance of an obstacle, "lies 0.2 deep inside the
/// ball at (0, 0)" of one within an obstacle, beyond rounding; else nothing.
std::string why_in_clearance(const Problem& problem, const PathEnd& end);

/// How far a curve may seem to go into an obstacle that it touches: `allowed` of its size, and the last digits of its
/// coordinates, which far from the origin are more.
double contact_tolerance(const Points& x, double allowed);

/// By how much the straight moves of a chain touch what its points keep away from, units of the place; 0 where they do
/// not, by more than contact_tolerance(), or where the domain does not check moves. Throws Interrupted.
double depth_in_obstacles(const Problem& problem, const CoordinatePath& chain, double allowed,
                          const Deadline& deadline);

}  // namespace leastcost
