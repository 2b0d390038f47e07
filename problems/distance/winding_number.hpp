// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// The generalised winding number of a triangle mesh (Jacobson, Kavan, Sorkine-Hornung 2013): how often it surrounds a
/// point, an integer off a closed mesh, -1 inside one that is inside out, broken numbers near an opening. Triangles by
/// their exact solid angle (van Oosterom, Strackee 1983), far groups of them by the dipole of their area (Barill et al.
/// 2018, first term): off by one or two hundredths.
class WindingNumber {
 public:
  /// `turned` says which faces count with the opposite orientation; empty: none.
  explicit WindingNumber(const TriangleMesh& mesh, const std::vector<char>& turned = {});
  double at(const Eigen::Vector3d& x) const;

 private:
  struct Node {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(), dipole = Eigen::Vector3d::Zero();
    double radius = 0;
    std::int32_t first = 0, count = 0;  // triangles; an inner node's children are the node after it and `second`
    std::int32_t second = -1;           // -1: a leaf
  };
  struct Triangle {
    std::array<Eigen::Vector3d, 3> corner;
  };
  std::int32_t build(std::int32_t first, std::int32_t count);

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace leastcost
