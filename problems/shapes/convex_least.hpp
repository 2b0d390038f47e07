// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace leastcost {

/// A value of a convex function of one number, and one of its slopes there: nowhere is it below this tangent.
struct Cut {
  double at = 0, value = 0, slope = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of the plane in space that it is the trace of
};

/// The least of a convex function over [0, 1], from below.
struct ConvexLeast {
  double lower = 0;      ///< nowhere in [0, 1] is the function less; 0 where it meets 0
  double at = 0;         ///< the lowest place that was looked at
  bool meets = false;    ///< a value of at most 0 was found, at `at`
  Cut left = {}, right;  ///< tangents on both sides of the least, whose crossing is `lower`; alike at an end
};

/// By tangents (Kelley 1960): next looks are at the crossing of the two nearest and, as that is slow where the function
/// is smooth, at the zero of the line through their slopes. It ends where the bound is `accuracy` below the lowest
/// value, and at the first value that is not positive.
template <class CutAt>
ConvexLeast convex_least(const CutAt& cut_at, double accuracy) {
  constexpr int kMost = 100;
  Cut left = cut_at(0.0);
  if (!(left.value > 0)) return {0, 0, true, left, left};
  if (left.slope >= 0) return {left.value, 0, false, left, left};
  Cut right = cut_at(1.0);
  if (!(right.value > 0)) return {0, 1, true, left, right};
  if (right.slope <= 0) return {right.value, 1, false, right, right};
  double lower = 0, width_before = 1;
  for (int k = 0; k < kMost; ++k) {
    const double width = right.at - left.at, change = right.slope - left.slope;
    const double best = std::min(left.value, right.value);
    const double crossing =
        std::clamp(left.at + (right.slope * width + left.value - right.value) / change, left.at, right.at);
    lower = std::clamp(left.value + left.slope * (crossing - left.at), 0.0, best);
    if (best - lower <= accuracy) break;
    double at = k % 2 == 0 ? left.at - left.slope * width / change : crossing;
    if (k % 3 == 2) {
      if (width > width_before / 2) at = left.at + width / 2;
      width_before = width;
    }
    if (!(at > left.at && at < right.at)) at = left.at + width / 2;
    if (!(at > left.at && at < right.at)) break;
    const Cut next = cut_at(at);
    if (!(next.value > 0)) return {0, at, true, left, next};
    (next.slope < 0 ? left : right) = next;
  }
  return {lower, left.value < right.value ? left.at : right.at, false, left, right};
}

/// Where a convex function that is positive at `left`, and not at `until` beyond it, comes to 0 first: tangents from
/// the left do not pass that place (Newton).
template <class CutAt>
double first_zero(const CutAt& cut_at, Cut left, double until, double accuracy) {
  constexpr int kMost = 100;
  for (int k = 0; k < kMost && left.value > accuracy && left.slope < 0; ++k) {
    const double at = left.at - left.value / left.slope;
    if (!(at > left.at)) break;
    if (!(at < until)) return until;
    left = cut_at(at);
  }
  return left.at;
}

}  // namespace leastcost
