// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

// The parts of the report on a run, each made from its files. All return HTML or SVG.
#include <string>
#include <vector>

#include "app/report/run/run_files.hpp"

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

/// The plane, or a map of the ground, with path, first path, box and cost. SVG.
std::string plane_svg(const RunFiles& files);
/// A robot on its way, the later the stronger, and its obstacles; empty without one. SVG.
std::string strip_svg(const PoseStrip& strip);
/// Every coordinate against the cumulative cost, for spaces that cannot be drawn. SVG.
std::string coordinates_svg(const RunFiles& files);

}  // namespace leastcost::app
