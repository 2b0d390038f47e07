// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>

namespace leastcost {

/// Of a point from the box from -half to half; 0 within.
inline double distance_to_box(const Eigen::Vector3d& x, const Eigen::Vector3d& half) {
  return (x.cwiseAbs() - half).cwiseMax(0).norm();
}

/// Of the segment from a to a + way from that box. The square of the distance is convex along it and a parabola between
/// the places where it meets the planes of the sides: its slope is followed to where it changes its sign.
inline double distance_to_box(const Eigen::Vector3d& a, const Eigen::Vector3d& way, const Eigen::Vector3d& half) {
  const auto outside = [&](double t) -> Eigen::Vector3d {
    const Eigen::Vector3d x = a + t * way;
    return x - x.cwiseMax(-half).cwiseMin(half);
  };
  double left = outside(0).dot(way);
  if (left >= 0) return outside(0).norm();
  std::array<double, 7> bends;
  std::size_t count = 0;
  for (Eigen::Index i = 0; i < 3; ++i)
    for (const double side : {-half[i], half[i]}) {
      const double bend = (side - a[i]) / way[i];
      if (!(bend > 0 && bend < 1)) continue;
      std::size_t k = count++;  // of six at most: put in order as they come
      for (; k > 0 && bends[k - 1] > bend; --k) bends[k] = bends[k - 1];
      bends[k] = bend;
    }
  bends[count++] = 1;
  double before = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double right = outside(bends[k]).dot(way);
    if (right >= 0) return outside(before - left / (right - left) * (bends[k] - before)).norm();
    left = right;
    before = bends[k];
  }
  return outside(1).norm();
}

}  // namespace leastcost
