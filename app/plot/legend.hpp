// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/plot/sketch.hpp"

namespace leastcost::app {

/// One thing that a drawing shows.
struct LegendEntry {
  std::string sample;      ///< SVG, 30 x 12 px
  std::string name;        ///< plain text
  std::string layer = {};  ///< of the 3D view of a report, where it can be switched off
};

/// Areas that may overlap, seen as one: their edges, then what is within. `paths`: SVG path data, `name`: class.
std::string areas(const std::vector<std::string>& paths, const std::string& name);

/// As elements of a page; `layers`: with boxes to switch the layers of the 3D view.
std::string legend_html(const std::vector<LegendEntry>& entries, bool layers);

/// As a drawing: as many columns as fit.
Sketch legend_sketch(const std::vector<LegendEntry>& entries, double width);

/// One below the other; the first one's title is that of all.
Sketch below(Sketch upper, const Sketch& lower);

}  // namespace leastcost::app
