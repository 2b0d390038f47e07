// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/plot/legend.hpp"
#include "app/report/run/plane_frame.hpp"
#include "app/report/space/look.hpp"
#include "catalogue/scene/scene.hpp"

namespace leastcost::app {

// What surrounds the paths in a drawing of the plane. All but the legend return SVG.

/// Polylines of a class of the style.
std::string polylines(const std::vector<Points>& lines, const PlaneFrame& frame, const char* name);

/// What no path may enter: outside the free part, and obstacles with the margin around them.
std::string obstacles_in(const Scene& scene, const PlaneFrame& frame);

/// Whether a side of the box lies within the frame.
bool shows_walls(const Scene& scene, const PlaneFrame& frame);
/// The sides of the box that lie within the frame, and the forbidden side of each.
std::string box_sides(const Scene& scene, const PlaneFrame& frame);

/// The definitions of a clip path `inside`, the frame, and of a pattern `hatch`.
std::string clip_and_hatch(const PlaneFrame& frame);

/// Entries of a legend: a line, an area or a mark of a class of the style.
LegendEntry line_entry(const char* name, std::string words);
LegendEntry area_entry(const char* name, std::string words);
LegendEntry mark_entry(const char* name, double radius, std::string words);

/// What of obstacles and of the box is drawn. `walls`: shows_walls().
void add_surroundings(const Scene& scene, bool walls, const Look& look, std::vector<LegendEntry>& out);

}  // namespace leastcost::app
