// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

// The parts of the report on a run, each made from its files. All return HTML or SVG.
#include <string>
#include <vector>

#include "app/plot/legend.hpp"
#include "app/report/run/run_files.hpp"
#include "app/report/space/look.hpp"
#include "app/report/space/space_view.hpp"

namespace leastcost::app {

/// Every test of the certificate in plain words, and the levels of its refinement.
std::string certificate_part(const JsonFile& result);

/// Energy excess and predicted cost error against iterations, evaluations and time.
std::string convergence_part(const RunFiles& files);
/// Cost of each segment, and how far it is from the mean.
std::string spacing_part(const RunFiles& files);
/// Distance off the domain along the delivered curve; empty where the question has no meaning.
std::string residual_part(const RunFiles& files);

/// The drawing of the path: 3D view, plane, or coordinates against cost; and what has to stand at the end of the page
/// for it.
struct Picture {
  std::string part;
  std::string script;  ///< after the body; may be empty
};
Picture picture_of(const RunFiles& files);

/// What the main drawing of a path shows, for its legend. `map`: of the ground, where there is one.
std::vector<LegendEntry> legend_of(const RunFiles& files, const Look& look, bool map = false);

/// The plane, or a map of the ground, with path, first path, obstacles, box and cost.
Sketch plane_sketch(const RunFiles& files, const Look& look);
/// Where that drawing has the plane, px: x is at left + scale (x - lower), y at top + scale (upper - y).
struct PlaneMap {
  double left = 0, top = 0, width = 0, height = 0, scale = 1, lower = 0, upper = 0;
};
PlaneMap plane_map(const RunFiles& files, const Look& look);
/// Whether a side of the box is in that drawing.
bool shows_walls(const RunFiles& files);
/// The scene without perspective: hidden parts of the path are thin.
Sketch space_sketch(const RunFiles& files, const SpaceView& view, const Look& look);
/// A robot on its way, the later the stronger, and its obstacles; empty without one.
Sketch strip_sketch(const PoseStrip& strip, const Look& look);
std::vector<LegendEntry> legend_of(const PoseStrip& strip, const Look& look);
/// Every coordinate against the cumulative cost, for spaces that cannot be drawn.
Sketch coordinates_sketch(const RunFiles& files, const Look& look);
/// Energy excess and predicted cost error against iterations.
Sketch convergence_sketch(const RunFiles& files, const Look& look);

}  // namespace leastcost::app
