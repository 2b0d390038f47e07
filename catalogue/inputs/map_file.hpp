// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <leastcost/problems/occupancy/occupancy_options.hpp>

namespace leastcost {

/// Reads a map: Moving AI (.map), PNG, PGM, or a map_server YAML (image, resolution, origin, negate, occupied_thresh,
/// free_thresh, mode trinary) with the image that it names. `folder`: of the configuration. Throws InputError with file
/// and line or byte.
OccupancyGrid read_map(const OccupancyOptions& options, const std::filesystem::path& folder);

}  // namespace leastcost
