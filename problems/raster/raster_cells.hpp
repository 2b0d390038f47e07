// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <leastcost/problems/raster/raster.hpp>

namespace leastcost {

/// Ability of a cost: it was made from the cells of a raster, between whose values it interpolates.
class HasRasterCells {
 public:
  virtual ~HasRasterCells() = default;
  /// What a polyline costs where each cell has its value up to its sides, as raster programs read it. `curve`: a point
  /// in each column, map coordinates first; lengths are those between its columns. +infinity where it enters a cell
  /// without data or leaves the raster.
  virtual double cost_over_cells(const Eigen::Ref<const Eigen::MatrixXd>& curve) const = 0;
};

/// The same of given values. Along the side between two cells the cheaper one counts.
double cost_over_cells(const RasterGrid& values, const Eigen::Ref<const Eigen::MatrixXd>& curve);

}  // namespace leastcost
