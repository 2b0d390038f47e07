// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/shapes/shape_pose.hpp>

namespace leastcost {

/// The occupied space of an OctoMap. What the map does not know counts as free.
struct OctomapOptions {
  std::string file = {};  ///< .bt, or .ot of an OcTree
  ShapePose pose = {};    ///< of the frame of the map
  void fields(FieldVisitor& visit);
};

/// Boxes whose union are the occupied leaves, neighbours merged into larger ones. Their corners are sharp: they ask for
/// a clearance. Relative to `folder`. Throws OptionError for a pose that does not fit, InputError for files that are
/// none, for other trees than occupancy trees, for maps without an occupied leaf and with more than 200000 boxes.
std::vector<std::shared_ptr<const Obstacle>> read_octomap(const OctomapOptions& options,
                                                          const std::filesystem::path& folder);

/// "1.9.7".
std::string octomap_version();

}  // namespace leastcost
