// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <leastcost/problems/distance/distance_grid.hpp>
#include <leastcost/problems/distance/distance_source.hpp>

namespace leastcost {

/// Size and accuracy of a grid.
struct DistanceGridSettings {
  std::optional<double> cell = {};      ///< length units; else by the accuracy, or a 64th of the surface's longest side
  std::optional<double> accuracy = {};  ///< largest distance between the surface and that of the grid, length units
  double offset = 0;       ///< the surface at this distance of one without sides, length units; 0: the surface itself
  int margin = 8;          ///< cells around the surface
  double memory = 0x1p30;  ///< most that building may take, bytes
};

/// A grid and what is known about it.
struct SampledDistance {
  DistanceGrid grid;               ///< the samples
  double offset = 0;               ///< the surface is where the source is so far away, length units
  double worst = 0, mean = 0;      ///< distance of places on the surface from that of the grid, length units
  std::vector<std::string> notes;  ///< what the user should know
};

/// The values of a source on a given grid, as build_distance_grid() takes them.
std::vector<double> sample_distances(const DistanceSource& source, const GridShape& shape, double offset,
                                     const BuildProgress& progress = {});

/// Samples the source. How far the zeros of the spline are from the surface is measured at up to 5000 places of the
/// surface, the feet of cell centres near it. With `accuracy` the cell starts at a 32nd of the longest side and
/// shrinks, by what two such measurements say about the order, until the worst of them is small enough. Throws
/// InputError when the accuracy takes more memory than there may be, when a twentieth of the places are lost (parts
/// thinner than a cell), and what the source throws; OptionError("cell", "accuracy", "margin", "offset").
SampledDistance build_distance_grid(const DistanceSource& source, const DistanceGridSettings& settings,
                                    const BuildProgress& progress = {});

}  // namespace leastcost
