// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace leastcost::bracket {

struct CubicMinimum {
  double at, value;
};

/// The least on [from, to] of the cubic through four values at 0, 1, 2, 3, where its slope changes its sign once there.
inline CubicMinimum cubic_minimum(const std::array<double, 4>& f, double from, double to) {
  // Newton's form, in t - 1 for its middle: f = a + b s + c s^2 + d s^3, s = t - 1.
  const double a = f[1], c = 0.5 * (f[0] + f[2]) - f[1], d = (f[3] - 3 * f[2] + 3 * f[1] - f[0]) / 6,
               b = 0.5 * (f[2] - f[0]) - d;
  const auto value = [&](double t) { return a + (t - 1) * (b + (t - 1) * (c + (t - 1) * d)); };
  const double radicand = c * c - 3 * b * d;
  if (c + std::sqrt(std::max(radicand, 0.0)) > 0 && radicand >= 0) {
    const double t = std::clamp(1 - b / (c + std::sqrt(radicand)), from, to);
    return {t, value(t)};
  }
  return f[static_cast<std::size_t>(std::lround(from))] < f[static_cast<std::size_t>(std::lround(to))]
             ? CubicMinimum{from, value(from)}
             : CubicMinimum{to, value(to)};
}

}  // namespace leastcost::bracket
