// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include <leastcost/problems/mesh/closest_point.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// Ability: the domain is a triangle mesh, so paths can be traced and straightened. Sites are its faces.
class HasMesh {
 public:
  static constexpr std::string_view kAbility = "mesh";
  virtual ~HasMesh() = default;
  virtual const TriangleMesh& mesh() const = 0;      ///< the surface
  virtual const ClosestPointTree& tree() const = 0;  ///< for closest points
};

}  // namespace leastcost
