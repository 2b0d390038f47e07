// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>

namespace leastcost {

/// What is known about a function of one variable on [0, length].
struct LineBounds {
  double lipschitz = 1;  ///< of the function
  double curvature = 0;  ///< its second derivative is at most this where its values are at least `from`; 0: not known
  double from = 0;
};

/// The least value of a function, and where.
struct LeastValue {
  double lower = 0;  ///< a bound for all of them; NaN where a value is NaN
  double upper = 0;  ///< attained
  double at = 0;
};

/// When lower and upper are near enough: at most max(accuracy, share |upper|) apart.
struct LeastPrecision {
  double accuracy = 0;
  double share = 0.5;
  double enough = std::numeric_limits<double>::infinity();  ///< a lower bound that will do
  bool polished = true;                                     ///< follow the attained value to its local minimum
};

/// Least value on [0, length], by bisection of what may hold it (Piyavskii 1972), with 20,000 values at most.
LeastValue least_along(const std::function<double(double)>& f, double length, const LineBounds& bounds,
                       const LeastPrecision& precision);

}  // namespace leastcost
