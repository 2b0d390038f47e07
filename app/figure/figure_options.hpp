// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/plot/sketch.hpp"
#include "app/report/space/look.hpp"

namespace leastcost::app {

// What the options of `leastcost figure` say. All throw InputError in one sentence for what is none.

enum class FigureFormat { svg, pdf, png, vtp, ply };
/// By the ending of a file name.
FigureFormat figure_format(const std::string& file);

/// "84mm", "8.4cm", "3.3in", "238pt", in mm.
double paper_width(const std::string& text);
/// "8" or "8pt", in pt.
double font_size(const std::string& text);
/// Both, which must leave room for some letters.
PrintSize print_size(const std::string& width, const std::string& font);
/// "30,20": azimuth and elevation, degrees.
Angles view_angles(const std::string& text);

/// What --what can name.
const std::vector<std::string>& figure_parts();
/// "path,points,legend"; empty: everything.
struct FigureParts {
  Look look;
  bool legend = true;
};
FigureParts parts_shown(const std::string& text);

enum class FigurePicture { best, space, map, poses, coordinates, convergence };
FigurePicture picture_named(const std::string& text);

}  // namespace leastcost::app
