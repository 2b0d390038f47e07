// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "problems/occupancy/grey_image.hpp"

namespace leastcost {

/// A PNG as grey values, each the mean of all of its channels, transparency included, as map_server takes it in its
/// mode trinary. Throws InputError with what libpng says.
GreyImage read_png(std::string_view bytes, const std::string& file);

/// The bytes of a PNG. `rgb`: red, green and blue of each pixel, row by row from above.
std::string png_of_rgb(const std::vector<std::uint8_t>& rgb, int width, int height);

}  // namespace leastcost
