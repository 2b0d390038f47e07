// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "catalogue/config/loaded_config.hpp"

namespace leastcost {

/// Why a name cannot be that of a folder; empty when it can.
std::string name_fault(const std::string& name);

/// Gives a kernel, initializer or solver the type that is the default, where an override names one of its options and
/// nothing its type: `--set solver.max_iterations=50`.
void complete_types(ConfigNode& tree);

/// Whether the run proves that its path is the shortest of all, or tries to: an open path on a mesh, or
/// among obstacles in the plane, under the Euclidean cost, whose first path states no class, unless the configuration
/// says otherwise.
bool proves_shortest(const RunConfig& config);

/// Whether the run puts a bracket around the globally least cost: in a box, where a budget for it is
/// given.
bool brackets(const RunConfig& config);

/// Whether the path begins with the straight line and nothing looks at other ways, under a cost that may have several.
bool sees_one_way(const RunConfig& config);

/// How the raster of a cost map is read, and why, where the configuration does not say it; else nothing.
std::string word_on_interpolation(const LoadedConfig& loaded);

/// Fills in the plug-ins that the configuration leaves out and checks what no single option can: that the parts fit
/// each other.
void check_and_complete(LoadedConfig& loaded);

}  // namespace leastcost
