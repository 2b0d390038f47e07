// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/raster/raster_options.hpp>

namespace leastcost {

/// What lies between the values of a cost map. automatic: cells for a path between two ends in the plane without
/// obstacles, unless a configuration asks for a solver, a post-processor or a clearance; smooth elsewhere.
enum class CostMapInterpolation { automatic, smooth, bilinear, cells };
Words<CostMapInterpolation> words(CostMapInterpolation);

struct CostMapOptions {
  RasterOptions raster = {};  ///< cost per length at every place
  CostMapInterpolation interpolation = CostMapInterpolation::automatic;
  void fields(FieldVisitor& visit);
};

/// Length times what a unit of it costs there, n(x, y) > 0 from a raster: c(a, b) = |b - a| int_0^1 n(a + t (b - a))
/// dt, exact to rounding, in the plane or, over a map, in space (|b - a| in space, n of the first two coordinates).
/// bilinear: n as GIS programs interpolate it; its gradient jumps where patches meet. smooth: the bicubic spline that
/// has the values as its coefficients, twice differentiable, between the values around and a little smoother than they
/// are. cells: n is constant in each cell, along a side the lower of both, in the plane only; the cost has the ability
/// HasCostCells and jumps at the sides, which the post-processor refract_cells knows. automatic: smooth, as nothing is
/// known of the path. +infinity beyond the outermost values and beside cells without data; the cost says where. It has
/// the abilities HasCellIndex and, in the plane, CostDensity, but for cells. Throws OptionError("file" or
/// "value_scale") for a value that is not above 0, InputError.
std::shared_ptr<const SegmentCost> make_cost_map(const RasterGrid& values, CostMapInterpolation interpolation, int dim);

/// Why a cost map is none of this domain, empty where it is one: over points that fill space it would be the same at
/// every height. Null: a domain that waits for its files, which is a surface.
std::string why_no_map_of(const ConstraintManifold* domain);

}  // namespace leastcost
