// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <leastcost/problems/occupancy/occupancy_options.hpp>

namespace leastcost {

/// Brightness of the pixels of an image, row by row from its top.
struct GreyImage {
  int rows = 0, columns = 0;
  int maximum = 255;                  ///< white
  std::vector<std::uint16_t> values;  ///< rows x columns
  std::string source;
};

/// A pixel's occupancy is p = 1 - brightness, or brightness where `negate`: above `occupied_thresh` it is blocked,
/// below `free_thresh` free, between them unknown (map_server, mode trinary). The last row of the image is row 0.
OccupancyGrid occupancy_of(const GreyImage& image, const OccupancyOptions& options);

}  // namespace leastcost
