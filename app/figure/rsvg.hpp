// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/figure/figure_options.hpp"

namespace leastcost::app {

/// An SVG as PDF or PNG, by the program rsvg-convert (Debian: librsvg2-bin). Throws HostError where it is not there or
/// fails, in words. `program`: another one in its place, for tests.
std::string converted_svg(const std::string& svg, FigureFormat format, double dpi,
                          const std::string& program = "rsvg-convert");

/// Throws HostError where a picture of this format needs that program and it is not there: to be asked before any work.
void require_converter(FigureFormat format, const std::string& program = "rsvg-convert");

}  // namespace leastcost::app
