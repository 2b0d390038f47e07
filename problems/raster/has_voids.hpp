// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/raster/raster.hpp>

namespace leastcost {

class RasterPatches;

/// Ability of a domain or a cost that was made from a raster: where it has no value for want of data.
class HasVoids {
 public:
  virtual ~HasVoids() = default;
  /// Which patches of the raster are known.
  virtual const RasterPatches& known_patches() const = 0;
};

}  // namespace leastcost
