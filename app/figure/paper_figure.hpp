// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace leastcost {

/// How a figure looks, in the words of `leastcost figure` (docs/figures.md).
struct FigureOptions {
  std::string width = "84mm";    ///< in mm, cm, in or pt
  std::string font_size = "8";   ///< of all letters, pt
  std::string what = {};         ///< some of path, first, points, ..., separated by commas; empty: all that fits
  std::string picture = "best";  ///< space, map, poses, coordinates or convergence
  std::string view = {};         ///< of a picture in space: azimuth and elevation in degrees, like "30,20"
  std::string unit = {};         ///< of the coordinates, for the axes
  double dpi = 300;              ///< of a PNG, and of a shaded surface
};

/// What was drawn.
struct WrittenFigure {
  double width = 0, height = 0;                        ///< mm; 0 of a file for 3D programs
  std::optional<std::pair<double, double>> view = {};  ///< of a picture in space: azimuth and elevation, degrees
};

}  // namespace leastcost
