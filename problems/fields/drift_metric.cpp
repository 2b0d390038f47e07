// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/drift_metric.hpp"

#include <cstddef>

namespace leastcost {

using Eigen::Vector3d;

std::optional<DriftMetric> drift_metric_at(const SegmentCost& cost, const Vector3d& x) {
  constexpr double kRounding = 1e-6;
  const Eigen::VectorXd at = x;
  Eigen::VectorXd velocity(3);
  std::size_t asked = 0, possible = 0;
  const auto element = [&](const Vector3d& v) {
    velocity = v;
    const double c = cost.line_element(at, velocity);
    ++asked;
    if (c > 0 && std::isfinite(c)) ++possible;
    return c;
  };
  const auto even = [&](const Vector3d& v, double& odd) {
    const double there = element(v), back = element(-v);
    odd = (there - back) / 2;
    return (there + back) / 2;
  };
  std::array<double, 3> b{}, half{};
  for (std::size_t d = 0; d < 3; ++d) half[d] = even(Vector3d::Unit(static_cast<Eigen::Index>(d)), b[d]);
  DriftMetric found;
  const auto mixed = [&](std::size_t d, std::size_t e) {
    double odd = 0;
    const double both =
        even(Vector3d::Unit(static_cast<Eigen::Index>(d)) + Vector3d::Unit(static_cast<Eigen::Index>(e)), odd);
    return (both * both - half[d] * half[d] - half[e] * half[e]) / 2;
  };
  for (std::size_t d = 0; d < 3; ++d) {
    found.a[d] = half[d] * half[d];
    found.b[d] = b[d];
  }
  found.a[3] = mixed(0, 1), found.a[4] = mixed(0, 2), found.a[5] = mixed(1, 2);
  bool right = true;
  for (const Vector3d& v : {Vector3d(1, -1, 0.5), Vector3d(-0.3, 0.7, 1), Vector3d(0.6, -1, -0.8),
                            Vector3d(-1, -0.4, 0.3), Vector3d(0.2, 0.9, -0.7)}) {
    const double size = std::sqrt(v.dot(found.matrix() * v));
    right = std::abs(element(v) - found(v)) <= kRounding * size && right;
  }
  if (possible == 0) return DriftMetric{};
  if (possible < asked || !right) return std::nullopt;
  return found;
}

}  // namespace leastcost
