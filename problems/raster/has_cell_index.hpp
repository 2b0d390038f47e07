// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "problems/raster/raster_function.hpp"

namespace leastcost {

/// Ability of a cost that is length times n(x, y) > 0 in the plane, n a polynomial on each patch of a raster: what a
/// proof over all paths needs of it. Where a patch is not known the cost is infinite.
class HasCellIndex {
 public:
  virtual ~HasCellIndex() = default;
  /// Which patches there are, where they are, and which are known.
  virtual const RasterPatches& patches() const = 0;
  /// n and its derivatives on a known patch, rounded outward.
  virtual PatchBounds bounds(const RasterPatch& patch) const = 0;
  /// n at a place, with its derivatives; not finite where it is not known.
  virtual PlaneJet index(double x, double y) const = 0;
  /// Where n is bilinear: its values at the corners (row, column), (row, column + 1), (row + 1, column), (row + 1,
  /// column + 1) of a known patch, of which it is the bilinear function.
  virtual std::optional<std::array<double, 4>> corners(const RasterPatch& patch) const = 0;
};

}  // namespace leastcost
