// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/search/density_medium.hpp"

#include <cmath>

namespace leastcost::bracket {

template <>
double DensityMedium<2>::cost_near(const End& end, const Grid<2>& grid, const Eigen::Vector2d& x, double) const {
  const Eigen::Vector2d d = x - end.place, middle = grid.in_box(end.place + d / 2), there = grid.in_box(x);
  const double n0 = cost_.density(end.place), r = d.norm();
  const double across = r > 0 ? (end.cone.gx * d[1] - end.cone.gy * d[0]) / r : 0;
  return r * (n0 + 4 * cost_.density(middle) + cost_.density(there)) / 6 - r * r * r * across * across / (24 * n0);
}

template <>
double DensityMedium<3>::cost_near(const End& end, const Grid<3>& grid, const Eigen::Vector3d& x,
                                   double density_there) const {
  const Eigen::Vector3d there = grid.in_box(x), middle = grid.in_box(0.5 * (end.place + x)), d = there - end.place;
  const double n0 = cost_.density(end.place), r = d.norm();
  const double across = end.slope.cross(d).squaredNorm();  // |g across d|^2 r^2
  const double within = r * (n0 + 4 * cost_.density(middle) + cost_.density(there)) / 6 - r * across / (24 * n0);
  return within + (x - there).norm() * density_there;
}

}  // namespace leastcost::bracket
