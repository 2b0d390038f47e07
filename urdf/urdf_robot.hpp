// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include <leastcost/problems/robots/robot.hpp>
#include <leastcost/urdf/urdf_options.hpp>

namespace leastcost {

/// The robot of a URDF file: coordinates are the joints that move, in the order of the tree. Joints without motion are
/// merged away: links that stand still against each other are one, named by the one that moves first. Shapes are the
/// collision shapes, covered by capsules. Parts of links are kept apart that move against each other and whose pair the
/// SRDF does not disable; without an SRDF, those that no more than one link with a shape lies between.
/// Files are relative to `folder`. `note` is told, with file and line, of pairs of the SRDF whose links the URDF does
/// not have, and of joints that others mimic and whose limits are cut to theirs. Throws InputError("file:line: ...")
/// for files that are wrong, OptionError for options that do not fit them.
std::shared_ptr<const Robot> make_urdf_robot(const UrdfRobotOptions& options, const std::filesystem::path& folder,
                                             const std::function<void(std::string)>& note = {});

/// "9.0.0".
std::string tinyxml2_version();

}  // namespace leastcost
