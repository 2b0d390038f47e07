// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/raster/raster.hpp>

namespace leastcost {

/// Ability of a domain or a cost that was made from a raster: points have its coordinates.
class HasRaster {
 public:
  virtual ~HasRaster() = default;
  bool present() const { return has_raster(); }
  /// Where it lies, and its CRS; the values may be gone.
  virtual const RasterGrid& raster() const = 0;

 private:
  virtual bool has_raster() const { return true; }
};

}  // namespace leastcost
