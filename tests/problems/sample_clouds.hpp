// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <utility>

#include <leastcost/problems/cloud/point_samples.hpp>

/// Clouds with a known surface behind them: quasi-random points (the additive sequence of the plastic number), uniform
/// by area.
namespace leastcost::test {

/// Point i of the sequence in the unit square.
inline std::pair<double, double> quasi_random(int i) {
  const double g = 1.32471795724474602596;  // g^3 = g + 1
  return {std::fmod(0.5 + (i + 1) / g, 1.0), std::fmod(0.5 + (i + 1) / (g * g), 1.0)};
}

/// The torus around the z axis with radii 2 scale and scale.
inline PointSamples torus_cloud(int count, double scale = 1) {
  PointSamples samples;
  for (int i = 0; i < count; ++i) {
    const auto [s, t] = quasi_random(i);
    const double u = 2 * std::numbers::pi * t, m = 2 * std::numbers::pi * s;
    double v = m;  // area up to v is in proportion to 2 v + sin v
    for (int k = 0; k < 30; ++k) v -= (2 * v + std::sin(v) - 2 * m) / (2 + std::cos(v));
    samples.positions.emplace_back(
        scale * Eigen::Vector3d((2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v)));
  }
  return samples;
}

/// The unit sphere, moved.
inline PointSamples sphere_cloud(int count, const Eigen::Vector3d& centre = Eigen::Vector3d::Zero()) {
  PointSamples samples;
  for (int i = 0; i < count; ++i) {
    const auto [s, t] = quasi_random(i);
    const double z = 2 * s - 1, r = std::sqrt(1 - z * z), u = 2 * std::numbers::pi * t;
    samples.positions.emplace_back(centre + Eigen::Vector3d(r * std::cos(u), r * std::sin(u), z));
  }
  return samples;
}

/// z = height(x, y) over the unit square.
template <class Height>
PointSamples sheet_cloud(int count, Height height) {
  PointSamples samples;
  for (int i = 0; i < count; ++i) {
    const auto [x, y] = quasi_random(i);
    samples.positions.emplace_back(x, y, height(x, y));
  }
  return samples;
}

/// Distance of x from the torus of torus_cloud(., 1).
inline double off_torus(const Eigen::Vector3d& x) { return std::abs(std::hypot(std::hypot(x[0], x[1]) - 2, x[2]) - 1); }

}  // namespace leastcost::test
