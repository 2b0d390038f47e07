// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace leastcost {

/// A place of the plane, in z = 0, or of space.
inline Eigen::Vector3d in_space(const Eigen::VectorXd& x) {
  Eigen::Vector3d out = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < x.size(); ++i) out[i] = x[i];
  return out;
}

}  // namespace leastcost
