// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/problems/raster/raster_options.hpp>

namespace leastcost {

/// How a cell takes its value from a raster that lies askew.
enum class Resampling {
  nearest,  ///< that of the cell of the file in which its middle lies: costs may be classes, which have no means
  bilinear  ///< between the four middles around its own: heights, whose slopes count
};

/// placed() for a file whose sides are not along the axes (RasterFile::turned): the same values on cells along the axes
/// of its CRS, small enough that every cell of the file has one of them (0.7 to 1 of its sides), and no data outside of
/// the file's own outline. `cell` and `origin` together replace the georeference, rotation included. `note` is told
/// what was done, if anything. Throws what placed() and, for bilinear values, check_heights() throw.
RasterGrid placed_upright(RasterFile file, const RasterOptions& options, Resampling resampling, std::string& note);

}  // namespace leastcost
