// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace leastcost {

/// A box in space that may be turned; a segment or a point where half edges are 0. In the plane z is 0.
struct OrientedBox {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< of its edges, one a column, of length one
  Eigen::Vector3d half = Eigen::Vector3d::Zero();      ///< edges
};

/// Ability of an obstacle whose core is such a box: its distances may be computed without asking it.
class HasCoreBox {
 public:
  virtual ~HasCoreBox() = default;
  bool present() const { return has_core_box(); }
  virtual OrientedBox core_box() const = 0;

 private:
  virtual bool has_core_box() const { return true; }
};

}  // namespace leastcost
