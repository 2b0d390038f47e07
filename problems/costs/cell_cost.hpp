// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/problems/raster/raster.hpp>

namespace leastcost {

/// Length times a value that is constant in each cell of a raster; along a side the lower of both. Values must be above
/// 0. Throws OptionError("interpolation") outside the plane.
std::shared_ptr<const SegmentCost> make_cell_cost(const RasterGrid& values, int dim);

}  // namespace leastcost
