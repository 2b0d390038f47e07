// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "problems/exact/double_double.hpp"

/// What the sources of Propagation share.
namespace leastcost::exact {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kEpsilon = kRoundingOf<double>;

inline double length_in_plane(double x, double y) { return std::sqrt(x * x + y * y); }

template <class Real>
double value(const Real& x) {
  return static_cast<double>(x);
}

}  // namespace leastcost::exact
