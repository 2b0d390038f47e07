// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "problems/straighten/strip.hpp"

namespace leastcost {

/// A vertex that the string bends around, or touches.
struct Touch {
  std::int32_t vertex;
  std::size_t door;  ///< one of the doors that end at it
  Eigen::Vector2d at;
};

/// Pulls a string through the doors of a strip laid out in the plane: the shortest path from the origin to `end` (Lee
/// and Preparata's funnel, linear time). Reusable: keeps its memory.
///
/// A vertex nearer to the string than `tolerance` (length units) counts as touched, even where the string could pass: a
/// path point that rounding puts onto a vertex is then always known to be at that vertex.
class Funnel {
 public:
  explicit Funnel(double tolerance) : squared_tolerance_(tolerance * tolerance) {}

  /// The vertices touched, in order. Valid until the next call.
  const std::vector<Touch>& pull(std::span<const UnfoldedDoor> doors, const Eigen::Vector2d& end);

 private:
  struct Chain {
    std::vector<Touch> points;  ///< beyond the apex
    std::size_t front = 0;      ///< points before this one lie behind the apex
    bool empty() const { return front == points.size(); }
    void clear() { points.clear(), front = 0; }
  };
  bool on_line(double cross, const Eigen::Vector2d& chord) const {
    return cross * cross <= squared_tolerance_ * chord.squaredNorm();
  }
  /// Adds a point to the chain on one side (+1 left, -1 right).
  void add(Chain& own, Chain& other, double side, const Touch& p);

  double squared_tolerance_;
  Chain left_, right_;
  Eigen::Vector2d apex_ = Eigen::Vector2d::Zero();
  std::vector<Touch> touched_;
};

}  // namespace leastcost
