// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <leastcost/problems/raster/raster_options.hpp>
#include "problems/raster/turned_raster.hpp"

namespace leastcost {

/// The raster of a file, by its ending: ESRI ASCII grid (.asc), table of numbers (.csv, .txt), all else by GDAL where
/// the build has it. The file is relative to `folder`; one that is rotated is turned, which `note` is told. Throws
/// OptionError, InputError.
RasterGrid read_raster(const RasterOptions& options, const std::filesystem::path& folder,
                       Resampling resampling = Resampling::nearest, const std::function<void(std::string)>& note = {});

}  // namespace leastcost
