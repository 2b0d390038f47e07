// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/plot/scale.hpp"
#include "app/report/run/plane_frame.hpp"
#include "catalogue/scene/raster.hpp"

namespace leastcost::app {

/// Of the bands of a drawing: grey for costs per unit of length, warm for costs of ways.
enum class BandColour { grey, warm };

/// Levels between bands of costs per unit of length: evenly in the logarithm, where the middle 96 % of the values are.
std::vector<Tick> cost_levels(const Raster& raster);

/// Costs as bands between levels, the stronger the dearer. SVG.
std::string cost_bands(const Raster& raster, const std::vector<Tick>& levels, const PlaneFrame& frame,
                       BandColour colour);
/// What the bands mean: the levels between them under a bar with a title. SVG, 0 to cost_bar_height() below `top`.
std::string cost_bar(const std::vector<Tick>& levels, const PlaneFrame& frame, BandColour colour, double top,
                     const std::string& title);
double cost_bar_height();

/// Ground in the sun and in the shade, in steps. SVG.
std::string hillshade(const Raster& raster, const PlaneFrame& frame);

/// Lines at levels. SVG.
std::string level_lines(const Raster& raster, const std::vector<Tick>& levels, const PlaneFrame& frame);
/// Level lines of a potential in the part of the plane where it was needed. SVG.
std::string potential_lines(const Raster& raster, const PlaneFrame& frame);

}  // namespace leastcost::app
