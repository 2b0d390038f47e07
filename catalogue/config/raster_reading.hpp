// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "catalogue/config/loaded_config.hpp"

namespace leastcost {

/// In R^d without obstacles, where a path can be refracted at the sides of cells.
bool is_free(const RunConfig& config);

/// Whether the cost is a map that is constant in each cell of its raster.
bool reads_cells(const RunConfig& config);

/// A raster is read as it is where that can be solved: decides what `interpolation: auto` means.
void choose_interpolation(RunConfig& config);

/// How the raster of a cost map is read, and why, where the configuration does not say it; else nothing.
std::string word_on_interpolation(const LoadedConfig& loaded);

}  // namespace leastcost
