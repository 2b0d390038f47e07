// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/framework/family/family.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/framework/result/result.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/drawing/draws_poses.hpp>
#include "catalogue/scene/raster.hpp"

namespace leastcost {

/// Polylines on the domain, d x m each; a closed one ends where it begins.
struct SceneLines {
  Points path, first;
  std::vector<Points> others;  ///< of the family of the path
};

/// A path and what surrounds it, ready to be drawn: the domain, if it draws itself. Above three dimensions nothing is
/// drawn but the robot, where points are configurations of one, and everything else but the dimension is empty.
struct Scene : Drawing {
  int dimension = 0;  ///< of the ambient space
  SceneLines lines;
  PoseStrip strip;  ///< of a robot; empty without one
  std::optional<Raster>
      cost;  ///< of the plane: cost per unit of length, the mean over the directions that are possible
  std::optional<Raster> relief;     ///< of a map: how light the ground is seen from above, 0 to 1
  std::optional<Raster> potential;  ///< that bounds the least cost of all paths, where they were searched
};

/// Draws the domain of a problem around its result. `others`: more paths of its family. Takes some tens of
/// milliseconds.
Scene make_scene(const Problem& problem, const Result& result, std::span<const FamilyMember> others = {});

/// Version of the layout of scene.json.
inline constexpr int kSceneVersion = 1;

/// scene.json: coordinates rounded to seven digits of the extent of the scene.
std::string scene_json(const Scene& scene);
/// The inverse. `name`: of the file, for messages. Throws InputError.
Scene read_scene(std::string_view text, const std::string& name);

}  // namespace leastcost
