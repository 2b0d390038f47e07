// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/exact/double_double.hpp"

/// What the sources of Propagation share.
namespace leastcost::exact {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kEpsilon = kRoundingOf<double>;

inline double length_in_plane(double x, double y) { return std::sqrt(x * x + y * y); }

/// In the plane of a face that a window enters, where the edge entered runs along y = 0.
struct PlanePoint {
  double x, y;
};

/// A path straight to (on_edge, 0) and straight on to `to` is at most this much longer than the straight line from an
/// image that may be off by `error`. Length units. What rounding does to the arguments and to the face is included.
inline double detour(const PlanePoint& image, double error, double on_edge, const PlanePoint& to) {
  const double before = length_in_plane(on_edge - image.x, image.y), behind = length_in_plane(to.x - on_edge, to.y);
  const double straight = length_in_plane(to.x - image.x, to.y - image.y);
  return std::max(0.0, before + behind - straight) + 40 * kEpsilon * (std::abs(on_edge) + before + behind) + 2 * error;
}

template <class Real>
double value(const Real& x) {
  return static_cast<double>(x);
}

}  // namespace leastcost::exact
