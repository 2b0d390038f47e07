// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>

namespace leastcost {

/// What a mesh is the obstacle of. closed: solid where it is closed, else its surface.
enum class MeshInside { closed, solid, surface };
Words<MeshInside> words(MeshInside);

/// A triangle mesh in space: first scaled, then turned, then moved.
struct MeshObstacleOptions {
  std::string file = {};
  bool weld = false;  ///< whether vertices at equal places become one
  MeshInside inside = MeshInside::closed;
  double radius = 0;  ///< thickness around it, length units
  double scale = 1;
  Eigen::VectorXd rotation = {};     ///< axis times angle, radians; empty: none
  Eigen::VectorXd translation = {};  ///< length units; empty: none
  double weld_within = 0;            ///< length units of the file; 0: what `weld` says
  void fields(FieldVisitor& visit);
};

/// A mesh as it is, with distances that are exact to rounding. A solid one has an inside where its winding number is
/// not 0, faces that disagree with their neighbours turned first; a path there is in it. Throws InputError where it is
/// to be solid and has borders, edges with more than two faces, or one side only. `name`: for messages; empty: by its
/// file.
std::shared_ptr<const Obstacle> make_mesh_obstacle(const TriangleMesh& mesh, MeshInside inside, double radius,
                                                   const std::string& name = {});

/// Reads (relative to `folder`) and places it. Throws OptionError, InputError.
std::shared_ptr<const Obstacle> make_mesh_obstacle(const MeshObstacleOptions& options,
                                                   const std::filesystem::path& folder, const std::string& name = {});

}  // namespace leastcost
