// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <leastcost/problems/occupancy/occupancy_options.hpp>
#include "problems/occupancy/grey_image.hpp"

namespace leastcost {

/// The text of a Moving AI map (type octile): '.', 'G' and 'S' are free, '@', 'O', 'T' and 'W' blocked. Row and column
/// are those of the file. `file` is for messages. Throws InputError("file:line: ...").
OccupancyGrid read_moving_ai(std::string_view text, const std::string& file, const OccupancyOptions& options);

/// A portable grey map, P2 (text) or P5 (binary, one or two bytes). Throws InputError with line or byte.
GreyImage read_pgm(std::string_view bytes, const std::string& file);

/// Checks the size of a map before memory is taken for it: 1 to OccupancyGrid::kMostCells cells. Throws
/// InputError("place: ...").
void check_map_size(std::int64_t rows, std::int64_t columns, const std::string& place);

}  // namespace leastcost
