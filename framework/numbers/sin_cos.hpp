// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <leastcost/framework/numbers/dual.hpp>

namespace leastcost {

/// Sine and cosine of one angle.
template <class S>
struct SinCos {
  S sin, cos;  ///< of the same angle
};

/// Both at the price of one, with the values of sin() and cos(): each is the derivative of the other.
template <class S>
SinCos<S> sin_cos(const S& x) {
  using std::cos, std::sin;
  return {sin(x), cos(x)};
}
template <class S, int N>
SinCos<Dual<S, N>> sin_cos(const Dual<S, N>& x) {
  const SinCos<S> at = sin_cos(x.value);
  return {compose(x, at.sin, at.cos), compose(x, at.cos, S(-at.sin))};
}

}  // namespace leastcost
