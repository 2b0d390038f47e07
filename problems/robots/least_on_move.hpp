// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <vector>

namespace leastcost {

/// The distance of something that moves, 0 <= t <= 1, from a closed set. Its points move at most so fast; what is asked
/// for is (distance - offset) / scale.
struct MovingDistance {
  double speed = 0;         ///< length units per t
  double acceleration = 0;  ///< length units per t^2
  double offset = 0;
  double scale = 1;

  double value(double distance) const { return (distance - offset) / scale; }
};

/// Several such distances along one move.
class DistancesOnMove {
 public:
  virtual ~DistancesOnMove() = default;
  /// Some of them at t, in place of what `distances` held.
  virtual void at(double t, const std::vector<int>& which, std::vector<double>& distances) = 0;
  /// A lower bound of one, which is `distance` at t, from t - half to t + half; minus infinity where none is known.
  virtual double least_around(double t, double half, int which, double distance) = 0;
};

/// When lower and upper are near enough: at most max(accuracy, share |upper|) apart.
struct MovePrecision {
  double accuracy = 0;
  double share = 0.5;
  double enough = std::numeric_limits<double>::infinity();    ///< a lower bound that will do
  double too_low = -std::numeric_limits<double>::infinity();  ///< below this no better bounds are wanted
};

/// The least of several such values over a move.
struct LeastOnMove {
  double lower = std::numeric_limits<double>::infinity();  ///< a bound for all of them, but for rounding
  double upper = std::numeric_limits<double>::infinity();  ///< attained
  double at = 0;
  int which = -1;
};

/// By bisection of the move, 8,000 pieces at most; then `lower` is what is known.
///
/// On a piece of length l the distance d is at least (d0 + d1 - speed l) / 2 = c. Where c > 0 its second derivative is
/// at most K = speed^2 / c + acceleration, kinks included, because it is the least of functions of which that is true:
/// the distances between one point of what moves and one of the set. So it is nowhere below its chord by more than K (t
/// - t0) (t1 - t) / 2. With the first bound alone a move in contact takes 1 / accuracy pieces (Schwarzer, Saha, Latombe
/// 2005), with the second 1 / sqrt(accuracy) at worst and, where contact is at a point, their logarithm. The worst is a
/// move that stays in contact; there least_around() helps.
LeastOnMove least_on_move(const std::vector<MovingDistance>& all, DistancesOnMove& distances,
                          const MovePrecision& precision);

/// The lower bound of the distance on a piece of length `length` with d0 and d1 at its ends.
double least_distance_on_piece(const MovingDistance& known, double length, double d0, double d1);

}  // namespace leastcost
