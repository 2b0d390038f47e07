// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace leastcost::app {

/// From where space is looked at, degrees: above the x axis turned towards y, and above the horizon.
struct Angles {
  double azimuth = 0, elevation = 0;
};

/// How large a drawing of a run is, and what it shows. The drawings of a report and of a figure differ by this alone.
struct Look {
  double width = 860, height = 560;  ///< at most, px
  bool path = true, first = true, others = true, points = true, ends = true, obstacles = true, shading = true;
  bool printed = false;   ///< on paper: marks a third smaller, a bar of length beside surfaces
  std::string unit = {};  ///< of the coordinates; empty: not known
  int image_width = 0;    ///< pixels of `width`, for surfaces as an image; 0: as triangles

  double mark(double radius) const { return printed ? radius * 2 / 3 : radius; }
  /// "x (m)".
  std::string axis(const std::string& name) const { return unit.empty() ? name : name + " (" + unit + ")"; }
};

}  // namespace leastcost::app
