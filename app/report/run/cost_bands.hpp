// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/report/run/plane_frame.hpp"
#include "catalogue/scene/raster.hpp"

namespace leastcost::app {

/// Cost per unit of length as bands, the stronger the dearer. SVG.
std::string cost_bands(const Raster& raster, const PlaneFrame& frame);
/// What the bands mean: the levels between them under a bar with a title. SVG, 0 to cost_bar_height() below `top`.
std::string cost_bar(const Raster& raster, const PlaneFrame& frame, double top, const std::string& title);
double cost_bar_height();

/// Ground in the sun and in the shade, in steps. SVG.
std::string hillshade(const Raster& raster, const PlaneFrame& frame);

/// Level lines of a potential in the part of the plane where it was needed. SVG.
std::string potential_lines(const Raster& raster, const PlaneFrame& frame);

}  // namespace leastcost::app
