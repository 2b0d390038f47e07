// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <leastcost/framework/cost/segment_cost.hpp>

namespace leastcost {

/// A line element F(v) = sqrt(v.Av) + b.v in space: a metric, b = 0, or the time in a wind that is weaker than the
/// speed (a Randers metric; Bao, Robles, Shen, Zermelo navigation on Riemannian manifolds, J. Differential Geom. 66,
/// 2004).
struct DriftMetric {
  std::array<double, 6> a = {};  ///< xx, yy, zz, xy, xz, yz; all 0: no move has a cost here
  std::array<double, 3> b = {};

  bool is_blocked() const { return !(a[0] > 0); }
  Eigen::Matrix3d matrix() const {
    Eigen::Matrix3d m;
    m << a[0], a[3], a[4], a[3], a[1], a[5], a[4], a[5], a[2];
    return m;
  }
  Eigen::Vector3d drift() const { return {b[0], b[1], b[2]}; }
  double operator()(const Eigen::Vector3d& v) const {
    const double squared = a[0] * v[0] * v[0] + a[1] * v[1] * v[1] + a[2] * v[2] * v[2] +
                           2 * (a[3] * v[0] * v[1] + a[4] * v[0] * v[2] + a[5] * v[1] * v[2]);
    return std::sqrt(std::max(squared, 0.0)) + b[0] * v[0] + b[1] * v[1] + b[2] * v[2];
  }
};

/// The line element of a cost at a place of space, from its values in 17 directions. Blocked where none of them has a
/// cost; nothing where they are those of no such element.
std::optional<DriftMetric> drift_metric_at(const SegmentCost& cost, const Eigen::Vector3d& x);

}  // namespace leastcost
