// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/plot/legend.hpp"
#include "app/report/run/run_parts.hpp"
#include "app/report/space/space_view.hpp"

namespace leastcost::app {

/// A picture that the 3D view takes the place of, where the program has it and the browser can.
struct StageContent {
  std::string still;                ///< SVG
  std::vector<LegendEntry> legend;  ///< with layers of the view
  std::string controls = {};        ///< HTML below the picture, hidden until the view shows it
  std::string caption;              ///< HTML, of <figcaption>
  std::string data;                 ///< JSON for the view
};
/// There is one in a page at most.
Picture staged(const StageContent& content);

/// How to use the view, or why there is none.
std::string about_viewer();

/// What a view needs to begin: "view" of its data.
std::string view_json(const SpaceView& view, const Eigen::Vector3d& up);

/// The robot in space among its obstacles, with its poses; empty without one.
Picture robot_picture(const RunFiles& files);

}  // namespace leastcost::app
