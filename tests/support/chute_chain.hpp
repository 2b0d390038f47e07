// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

namespace leastcost::test {

/// Least time of N straight chutes from rest, X across and Y down: T_N of docs/oracles.md D4. The speeds are C sin(i
/// Phi / N), and Phi solves X / Y = (2 N sin(Phi / N) - sin 2 Phi) / (2 sin^2 Phi).
inline double chute_chain_time(double x, double y, double gravity, int segments) {
  const double n = segments;
  double low = 1e-9, high = std::numbers::pi - 1e-9;
  for (int i = 0; i < 200; ++i) {
    const double phi = 0.5 * (low + high), s = std::sin(phi);
    ((2 * n * std::sin(phi / n) - std::sin(2 * phi)) / (2 * s * s) < x / y ? low : high) = phi;
  }
  const double c = std::sqrt(2 * gravity * y) / std::sin(low);
  return 2 * n * c / gravity * std::sin(low / (2 * n));
}

}  // namespace leastcost::test
