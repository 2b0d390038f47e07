// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include <leastcost/problems/mesh/median_tree.hpp>
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
  using Triangle = std::array<Eigen::Vector3d, 3>;
  struct Dipole {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(), area = Eigen::Vector3d::Zero();
    double radius = 0;  ///< of a ball around all triangles
  };
  static std::vector<Triangle> turned_triangles(const TriangleMesh& mesh, const std::vector<char>& turned);
  static Dipole dipole(std::span<const Triangle> triangles);

  MedianTree<Triangle, Dipole> tree_;
};

}  // namespace leastcost
