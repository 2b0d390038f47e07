// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include <leastcost/eigen_alignment.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include "problems/fields/closed_lattice.hpp"
#include "problems/fields/isotropic_march.hpp"
#include "problems/fields/lattice_box.hpp"

namespace leastcost {

/// Where the values of a raster of costs are.
struct RasterPlaces {
  Eigen::Vector2d first, cell, last;  ///< the lowest value, between values, the highest
  Eigen::Vector2d lower, upper;       ///< of what is known
};

/// Of a raster of costs; nothing for another cost.
std::optional<RasterPlaces> raster_places_of(const SegmentCost& cost);

/// The box of the domain, within that of the raster if there is one; without both, what the chart says, and else one
/// around the ends. Throws InputError where there is none.
LatticeBox field_box(const Problem& problem, const std::optional<RasterPlaces>& raster, const ChartBox& chart = {});

/// Along each side of the box: a lattice of every second node, for the error, then has two.
inline constexpr double kFewestCells = 4;

/// Throws InputError for a box without extent, and for one whose squares overflow.
void check_extent(const LatticeBox& box);
/// Throws OptionError ("resolution") for one that is no length, or too long for a box of this size.
void check_resolution(const std::optional<double>& resolution, const Eigen::VectorXd& size);

/// So many steps cover a side to its end; the step becomes as much shorter as it must.
double cells_to_edge(double side, double& step);

/// On the values of a raster inside the box; with a resolution, or without a raster, from the lower corner of it to the
/// upper one. `equal_steps`: see CostFieldOptions. Throws InputError, OptionError ("resolution").
IsotropicMarch::Lattice field_lattice(const LatticeBox& box, const std::optional<RasterPlaces>& raster,
                                      const std::optional<double>& resolution, bool equal_steps);

}  // namespace leastcost
