// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/domain/manifold.hpp>
#include "catalogue/scene/raster.hpp"

namespace leastcost {

/// Where points of a chart are places (x, y) on a map and the surface is (x, y, z(x, y)): how light the ground is,
/// seen from above, around the columns of `paths` (3 x m). A matt surface under a sun in the north-west, 45 degrees up
/// (Horn 1981); +infinity where there is no ground. Nothing where the chart is no map, or flat.
std::optional<Raster> relief_around(const ConstraintManifold& domain, const Points& paths);

}  // namespace leastcost
