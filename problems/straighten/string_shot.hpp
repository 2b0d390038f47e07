// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "problems/straighten/plane_vectors.hpp"
#include "problems/straighten/strip.hpp"

namespace leastcost {

/// Finds the strip under a straight line between two points of a strip, as they lie when the strip is laid out: the
/// line leaves the strip where it must and goes on over whatever surface is there. Where no curvature lies between,
/// it arrives at the other point, however far the strip was from straight; near it, it is connected by a walk. Strips
/// are trimmed.
class StringShot {
 public:
  explicit StringShot(Unfolding unfolding) : unfolding_(std::move(unfolding)) {}

  /// Lays out the strip that the shots from now on go over. It must stay as it is until the last of them.
  void aim(const StripEnd& from, const Strip& strip, const StripEnd& to);
  /// From end to end. False: a border, or a miss by more than kWorstMiss of the distance.
  bool shoot(Strip& out);
  /// Cuts the corner that the string from -> vertex -> to makes at a vertex of the strip: between the points at
  /// `fraction` of the way from the vertex to either end. False also where such a point is too near to an end.
  bool cut_corner(std::int32_t vertex, double fraction, Strip& out);

 private:
  void begin(Strip& out);
  bool leave_strip(std::size_t first, std::size_t last);
  bool leave_first_face(bool left);
  bool turn_around_start(bool left);
  bool fly();
  std::int32_t connect(const SurfacePoint& goal);
  bool return_to(std::size_t door);
  SurfacePoint landing() const;
  UnfoldedDoor beyond(const Door& door) const { return Unfolding::next_door(door_, door); }
  Door exit(std::int32_t rim) const;
  bool go_through(const Door& door, const UnfoldedDoor& unfolded);
  /// Positive: left of the line.
  double side_of(const Eigen::Vector2d& p) const { return cross(goal_ - origin_, p - origin_); }

  Unfolding unfolding_;
  StripEnd from_, to_;
  const Strip* strip_ = nullptr;
  Strip* out_ = nullptr;
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero(), goal_ = Eigen::Vector2d::Zero();
  UnfoldedDoor door_;        // the last one gone through
  std::int32_t entry_ = -1;  // its halfedge in the face behind it
  std::size_t limit_ = 0;    // of doors
};

}  // namespace leastcost
