// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// A user's own signed distance: what keeps a place out where it is less than `clearance`. Its functions are called
/// from several threads at once where paths are.
///
/// Clearances of moves are proved from values along them: with `lipschitz` alone, and where `curvature` is known as
/// well with far fewer calls. So that a move that runs along a wall can be proved, points keep `tolerance` more than
/// the clearance, the ends of a path too; a proof beside a wall of radius r takes about 4 sqrt(r / tolerance) values.
struct DistanceChecker {
  using Vector = Eigen::VectorXd;

  /// Length units; NaN: not known, hence not clear.
  std::function<double(const Vector& place)> distance = {};
  /// |distance(x) - distance(y)| <= lipschitz |x - y| for any two places; 1 for a true distance.
  double lipschitz = 1;
  /// No straight line bends the distance upwards by more than this (1 / length) where it is at least `curvature_from`:
  /// its second derivative is at most that. 0: not known. A true distance from any set is bent by at most 1 / distance,
  /// so that 2 / clearance holds from clearance / 2 on.
  double curvature = 0;
  double curvature_from = 0;  ///< length units, less than the clearance
  /// The derivative of the distance; else central differences.
  std::function<Vector(const Vector& place)> gradient = {};
  double clearance = 0;  ///< length units
  /// How deep (distance < -depth) everything is that a chain must not be drawn through to another side. With the
  /// clearance it says how far a segment may move at once; where both are 0 that is not watched.
  double depth = 0;
  double size = 1;                          ///< largest length of the scene: what rounding and steps are measured by
  std::optional<double> tolerance = {};     ///< length units; else 1e-4 sizes, with a curvature 1e-9
  std::string name = "the user's checker";  ///< for messages
};

/// Throws OptionError(<member>) for what is missing or no number.
std::shared_ptr<const Walls> make_checker_walls(Eigen::Index dimension, DistanceChecker checker);

/// A user's own answer to whether a place is free, without a distance. Moves are asked at places no farther apart than
/// `resolution`; what lies between is taken to be free, and no clearance is proved (MoveClearance::proved). Points do
/// not step into what is not free, nor segments, as far as the domain can keep them; but nothing comes to rest on walls
/// that nobody can measure, so that a path that they hold ends uncertified.
struct FreeChecker {
  using Vector = Eigen::VectorXd;

  std::function<bool(const Vector& place)> is_free = {};  ///< whether a place is free; called from several threads
  double resolution = 0;                                  ///< length units, greater than 0
  double size = 1;                                        ///< as above
  std::string name = "the user's checker";                ///< for messages
};

/// Throws OptionError(<member>) for what is missing or no number.
std::shared_ptr<const Walls> make_checker_walls(Eigen::Index dimension, FreeChecker checker);

}  // namespace leastcost
