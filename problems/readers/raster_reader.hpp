// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <leastcost/problems/raster/raster_options.hpp>

namespace leastcost {

/// An ESRI ASCII grid: ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize (or dx and dy),
/// optionally NODATA_value, in any order and any case, then the values, the northernmost row first; those of
/// is_no_value() mean no data. `file` is for
/// messages. Throws InputError("file:line: ...").
RasterFile read_esri_grid(std::string_view text, const std::string& file);

/// A table of numbers, a row per line, the northernmost first, separated by commas, semicolons or blanks; an empty
/// field and the words of is_no_value() mean no data. Throws InputError("file:line: ...").
RasterFile read_csv_raster(std::string_view text, const std::string& file);

/// Whether a word stands for "no data" the way programs write it: nan, inf, NA, null, *, 1.#QNAN, with any sign.
bool is_no_value(std::string_view token);

/// Checks the size of a raster before memory is taken for it. Throws InputError("place: ...").
void check_raster_size(std::int64_t rows, std::int64_t columns, const std::string& place);

}  // namespace leastcost
