// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace leastcost {

/// By how much the better end of a piece may exceed the least value on it, of the distance from a point that is as far
/// as `gap` from the ends of pieces: a convex function, whose second derivative is 1 over the distance at most, and
/// whose slope is 1 at most. Length units, as all below.
double sag(double gap, double piece);

/// Points of a curve that paths cross, with a bound of what is left from each, and from between it and its neighbours.
/// In floats: who asks takes the rounding off.
class Front {
 public:
  /// What is left of a path from a place over the curve, at least; how far the nearest of the points is.
  struct Least {
    double bound, gap;
  };
  /// Balls around points, by number.
  using Balls = std::vector<std::uint32_t>;

  /// No two neighbours on the curve will be farther apart than `piece`.
  void begin(double piece);
  void add(const Eigen::Vector3d& place, double at_least);
  /// To be asked only then; at least one point.
  void finish();
  bool empty() const { return x_.empty(); }
  double piece() const { return piece_; }

  Least through(const Eigen::Vector3d& place);
  /// The balls that places no farther than `reach` from this one have to look at; `least` is the one of this place.
  void gather(const Eigen::Vector3d& place, const Least& least, double reach, Balls& balls) const;
  /// The same as the other, for such a place.
  Least through(const Eigen::Vector3d& place, const Balls& balls) const;

 private:
  /// Around points that follow each other and are looked at together, with the least bound at one.
  struct Ball {
    float x, y, z, radius, bound;
  };
  struct Seen {
    float least, nearest;
  };
  Seen look(const Eigen::Vector3f& place, std::size_t ball) const;
  Least less_sag(const Seen& seen) const;

  std::vector<float> x_, y_, z_, bound_;
  std::vector<Ball> balls_;
  std::size_t last_ = 0;  // the ball with the least for the place asked before: the next place is often near
  double piece_ = 0;
};

}  // namespace leastcost
