// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/path/path.hpp>
#include <leastcost/problems/obstacles/walls.hpp>
#include "problems/taut/polyline_length.hpp"

namespace leastcost {

/// A polyline in space that is clear of convex obstacles, and stays so while it is pulled. Its sides are kept out of
/// the obstacles beside them by planes between the two.
class PulledString {
 public:
  /// `start`: 3 x m, m >= 2, of some length. `walls` and `monitor` outlive it.
  PulledString(const Walls& walls, Points start, const Monitor& monitor);

  const Points& polyline() const { return x_; }
  double length() const { return polyline_length(x_); }
  bool failed() const { return failed_; }  ///< an obstacle is not known to be convex
  bool clear() const;
  void take(const PulledString& other) { x_ = other.x_; }

  /// Leaves out vertices that a straight move can do without, and splits what is left into sides of equal length.
  void straighten();

  /// One solution between the planes of where it is now, with forces on its vertices: 3 x m in tensions, or empty.
  void pull(const Eigen::Matrix3Xd& forces = {});

  /// Until what pulls can still gain, as their gains go down, is less than `least`, of its length, twice. A string that
  /// rolls off something round does so in ever so many small steps in one direction: it is then sent ahead.
  void pull_tight(double least);

  /// The polygon outside the obstacles is longer by this than the one through the places where it touches them.
  double excess() const;

  /// Stretches between touches whose excess is above this share of the mean are cut short: their vertices slide along
  /// their sides to where these touch, as far as the way between is clear. Pulls alone do not do that: a plane does not
  /// let its side turn. From one obstacle to another there are then vertices that are near to neither, so that each
  /// side has the planes of one: those of two would hold it between them.
  void cut_short(double share);

 private:
  struct Touch;
  struct Stretch;

  bool is_clear(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double depth) const;
  bool leap(const Points& step, double times);
  std::vector<Stretch> stretches() const;
  std::optional<Touch> touches(Index side) const;
  void slide(Eigen::Vector3d& u, Eigen::Vector3d& v, const Stretch& stretch, bool one_corner) const;
  void drop_short_sides();

  const Walls& walls_;
  const HasSupportPlanes* convex_;  ///< of them
  const Monitor& monitor_;
  Points x_;
  double unit_;  ///< the length that it began with
  bool failed_ = false;
};

}  // namespace leastcost
