// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace leastcost {

/// normal . x[vertex] >= offset.
struct HalfSpace {
  Eigen::Index vertex = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double offset = 0;
};

/// The string of springs in space that is least stretched while each of its vertices stays within its half-spaces:
/// minimises sum |x[i+1] - x[i]|^2 / (2 rest[i]) - sum pull[i] . x[i] with the first and the last vertex fixed, a
/// convex quadratic program. By an interior point method (Nocedal and Wright 2006, Sec. 16.6) whose linear systems are
/// block tridiagonal: linear in the number of vertices. `x`: 3 x m, m >= 2, within all half-spaces but for rounding,
/// lengths of about one in all; `rest`: m - 1, greater than 0, the lengths at which springs pull alike; `pull`: 3 x m,
/// or empty. Returns a string that is within all half-spaces but for rounding, or `x` where that fails.
Eigen::Matrix3Xd least_stretched(const Eigen::Matrix3Xd& x, const Eigen::VectorXd& rest,
                                 const std::vector<HalfSpace>& half_spaces, const Eigen::Matrix3Xd& pull = {});

}  // namespace leastcost
