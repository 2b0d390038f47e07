// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <leastcost/framework/numbers/interval.hpp>

namespace leastcost {

/// Differences of neighbours.
template <std::size_t N>
std::array<Interval, N - 1> differences(const std::array<Interval, N>& terms) {
  std::array<Interval, N - 1> out;
  for (std::size_t k = 0; k + 1 < N; ++k) out[k] = terms[k + 1] - terms[k];
  return out;
}

/// Weights of the P + 1 coefficients of a uniform B-spline of degree P in its polar form: the weights of the spline at
/// u with u, u^2, u^3 replaced by the means of the arguments, of their products in pairs and of all of them.
inline std::array<Interval, 2> polar_weights(const std::array<Interval, 1>& u) { return {Interval(1) - u[0], u[0]}; }
inline std::array<Interval, 3> polar_weights(const std::array<Interval, 2>& u) {
  const Interval half(0.5), sum = u[0] + u[1], product = u[0] * u[1];
  return {half * (Interval(1) - sum + product), half * (Interval(1) + sum) - product, half * product};
}
inline std::array<Interval, 4> polar_weights(const std::array<Interval, 3>& u) {
  const Interval one(1), three(3), sixth = one / Interval(6);
  const Interval sum = u[0] + u[1] + u[2], pairs = u[0] * u[1] + (u[0] + u[1]) * u[2], all = u[0] * u[1] * u[2];
  return {sixth * (one - sum + pairs - all), sixth * (Interval(4) - Interval(2) * pairs + three * all),
          sixth * (one + sum + pairs - three * all), sixth * all};
}

/// A uniform B-spline of degree P from one knot to the next, or its polynomial beside them, on [from, to] in units of
/// the way between both: its Bernstein coefficients there, between which it lies. The k-th is the polar form with k
/// arguments `to` and the others `from` (Ramshaw, "Blossoms are polar forms", 1989). In contrast to weights that are
/// ranges themselves, the bounds meet the polynomial as the part shrinks. Both ends are numbers, up to rounding.
template <std::size_t P>
class SplinePart {
 public:
  using Coefficients = std::array<Interval, P + 1>;

  SplinePart(const Interval& from, const Interval& to) {
    for (std::size_t k = 0; k <= P; ++k) {
      std::array<Interval, P> arguments;
      for (std::size_t i = 0; i < P; ++i) arguments[i] = i < k ? to : from;
      weights_[k] = polar_weights(arguments);
    }
  }

  /// From the P + 1 coefficients of the B-spline around.
  Coefficients bernstein(const Coefficients& around) const {
    Coefficients out;
    for (std::size_t k = 0; k <= P; ++k) {
      out[k] = weights_[k][0] * around[0];
      for (std::size_t i = 1; i <= P; ++i) out[k] += weights_[k][i] * around[i];
    }
    return out;
  }
  /// All values on the part.
  Interval range(const Coefficients& around) const {
    const Coefficients all = bernstein(around);
    Interval out = all[0];
    for (std::size_t k = 1; k <= P; ++k) out = hull(out, all[k]);
    return out;
  }

 private:
  std::array<Coefficients, P + 1> weights_;
};

}  // namespace leastcost
