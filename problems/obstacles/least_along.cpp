// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/obstacles/least_along.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

namespace leastcost {
namespace {

constexpr int kMostValues = 20000;
constexpr int kPolished = 60;                    ///< golden sections
constexpr double kGolden = 0.38196601125010515;  ///< (3 - sqrt 5) / 2

struct Piece {
  double from, to, at_from, at_to, lower;
  bool operator<(const Piece& other) const { return lower > other.lower; }  // the least first
};

double bound(const Piece& p, const LineBounds& known) {
  const double length = p.to - p.from;
  const double cone = (p.at_from + p.at_to - known.lipschitz * length) / 2;
  if (!(known.curvature > 0) || !(cone >= known.from)) return cone;
  return std::max(cone, std::min(p.at_from, p.at_to) - known.curvature * length * length / 8);
}

/// The least value between two places, were it the only one there.
void polish(const std::function<double(double)>& f, double from, double to, LeastValue& least) {
  double left = from + kGolden * (to - from), right = to - kGolden * (to - from);
  double at_left = f(left), at_right = f(right);
  for (int k = 0; k < kPolished && left < right; ++k) {
    if (at_left < least.upper) least.upper = at_left, least.at = left;
    if (at_right < least.upper) least.upper = at_right, least.at = right;
    if (at_left < at_right) {
      to = right, right = left, at_right = at_left;
      at_left = f(left = from + kGolden * (to - from));
    } else {
      from = left, left = right, at_left = at_right;
      at_right = f(right = to - kGolden * (to - from));
    }
  }
}

}  // namespace

LeastValue least_along(const std::function<double(double)>& f, double length, const LineBounds& bounds,
                       const LeastPrecision& precision) {
  LeastValue least;
  double spacing = length;
  least.upper = std::numeric_limits<double>::infinity();
  const auto value = [&](double t) {
    const double v = f(t);
    if (v < least.upper) least.upper = v, least.at = t;
    return v;
  };
  Piece whole{0, length, value(0), length > 0 ? value(length) : least.upper, 0};
  whole.lower = bound(whole, bounds);
  std::priority_queue<Piece> open;
  open.push(whole);
  for (int values = 2; length > 0 && values < kMostValues; ++values) {
    const Piece p = open.top();
    if (p.lower >= precision.enough) break;
    if (std::isnan(p.lower) ||
        p.lower >= least.upper - std::max(precision.accuracy, precision.share * std::abs(least.upper)))
      break;
    open.pop();
    const double middle = (p.from + p.to) / 2, at_middle = value(middle);
    spacing = std::min(spacing, middle - p.from);
    for (Piece half : {Piece{p.from, middle, p.at_from, at_middle, 0}, Piece{middle, p.to, at_middle, p.at_to, 0}}) {
      half.lower = std::isnan(at_middle) ? at_middle : std::max(p.lower, bound(half, bounds));
      if (std::isnan(at_middle)) return {at_middle, least.upper, middle};
      open.push(half);
    }
  }
  least.lower = std::isnan(open.top().lower) ? open.top().lower : std::min(open.top().lower, least.upper);
  if (precision.polished && length > 0 && spacing < length)
    polish(f, std::max(0.0, least.at - spacing), std::min(length, least.at + spacing), least);
  return least;
}

}  // namespace leastcost
