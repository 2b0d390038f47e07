// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/problems/bracket/cost_density.hpp>
#include "problems/raster/raster_function.hpp"

namespace leastcost {

/// Bounds of a function of a raster as a cost density. A bilinear one is compared, over the patches that a cell
/// touches, with the bilinear polynomial at its centre, which goes on beyond its patch; a spline has no kinks. Nothing
/// is known of a cell that touches a patch without data, or reaches beyond the values by more than
/// RasterPatches::inside allows.
DensityEnclosure enclose_over(const RasterFunction& n, const Eigen::AlignedBox2d& cell);

}  // namespace leastcost
