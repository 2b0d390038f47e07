// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "app/figure/figure_options.hpp"

namespace leastcost::app {

/// The surface of a run with its path, for 3D programs. VTP: polygons and lines, told apart by the cell array `part` (1
/// the path, 2 other paths of the family, 3 the surface); PLY: faces and edges. Points have the cumulative cost, -1 off
/// the path, and in the plane the cost per unit of length. Of a robot the way of its hand. `format`: vtp or ply.
/// Throws InputError.
std::string surface_file(const std::filesystem::path& folder, FigureFormat format);

}  // namespace leastcost::app
