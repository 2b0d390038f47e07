// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/problems/distance/grid_shape.hpp>

namespace leastcost {

/// Distances at the nodes of a grid, in the order of GridShape::index, negative inside.
struct GridSamples {
  GridShape shape;
  std::vector<double> values;
};

/// The text format of SDFGen: a line "nx ny nz", a line with the position of the first node, a line with the cell size,
/// then nx ny nz values, x fastest, on any number of lines; '#' starts a comment. Throws InputError("file:line: ...")
/// for anything else: too few or too many values, values that are not finite, a grid beyond `memory` (bytes,
/// kBytesPerNode per node).
GridSamples read_sdf(const std::filesystem::path& file, double memory);
GridSamples read_sdf(std::string_view content, const std::string& file, double memory);

}  // namespace leastcost
