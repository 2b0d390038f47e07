// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/raster/has_voids.hpp>
#include "catalogue/config/run_config.hpp"

namespace leastcost {

/// How the note on them begins.
inline constexpr const char* kVoidsNote = "places without data are obstacles; ";

/// The places without data of rasters, as obstacles.
struct Voids {
  FreeSpace::Obstacles obstacles;
  double cell = 0;  ///< smaller side of the smallest cell, length units; 0 where there are none

  /// Adds those of `raster`; null, and one without a void, adds none.
  void add(const HasVoids* raster);
  bool any() const { return cell > 0; }
  /// The distance to keep from them: `asked`, or a part of a cell where that is 0.
  double clearance(double asked) const;
};

/// Whether the voids of a domain, and of its cost map, become obstacles by themselves: unless a raster of obstacles
/// says which are, or a proof over the cells of the raster goes round them anyway.
bool takes_voids(const RunConfig& config, const ConstraintManifold& domain);

/// Whether the cost may be a raster, with places without data and on the Earth.
bool may_be_map(const PluginChoice& cost);

/// Whether the straight line between the ends of a plane leaves the free space.
bool straight_is_blocked(const Problem& problem);

}  // namespace leastcost
