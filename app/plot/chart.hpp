// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/plot/scale.hpp"
#include "app/plot/sketch.hpp"

namespace leastcost::app {

/// How a series is told from others: an Okabe-Ito colour, a dash pattern and a marker, all given by one number. The
/// first seven differ in colour, so that a chart of few lines reads well; dashes and markers tell all of them apart in
/// greyscale.
struct LineStyle {
  int number = 0;
  bool line = true, markers = false;
  bool quiet = false;  ///< grey, thin and dashed, for references
};

struct Series {
  std::string name;  ///< in the legend; empty: not there
  std::vector<double> x, y;
  LineStyle style = {};
  std::vector<double> low = {}, high = {};  ///< of vertical bars; empty: none
  bool steps = false;                       ///< y holds from one x to the next
  std::size_t marks = 0;                    ///< with no markers in its style: so many of them, spread along the line
};

struct Axis {
  std::string title;
  ScaleKind kind = ScaleKind::linear;
  std::optional<double> least = {}, largest = {};  ///< instead of what the data asks for
  bool whole = false;                              ///< counts something: no ticks at fractions
};

/// A line chart.
struct Chart {
  std::string title;        ///< also what screen readers read out
  bool heading = true;      ///< the title above the chart
  std::string description;  ///< in one sentence, for screen readers
  Axis x, y;
  std::vector<Series> series;
  double width = 460, height = 300;  ///< of everything, in px
  bool legend = true;
};

/// The chart as an SVG element. Values that its scales cannot show are left out. `standalone`: a file of its own, with
/// its style in it.
std::string svg(const Chart& chart, bool standalone = false);
Sketch sketch(const Chart& chart);

/// What a legend beside the chart takes off its width, px; zero where the legend stands below.
double legend_width(const std::vector<Series>& series);

/// Charts side by side, with a title above, as a file of its own.
std::string panels_svg(const std::string& title, const std::string& description, const std::vector<Chart>& charts);

/// The style sheet that all drawings of this folder share; light and dark.
std::string plot_style();

/// SVG attributes of a style: class names of plot_style().
std::string stroke_of(const LineStyle& style);
/// A marker at a place, px.
std::string marker(const LineStyle& style, double x, double y, double radius = 3.2);

/// Title, description, view box. `content`: of the element.
std::string svg_element(const std::string& title, const std::string& description, double width, double height,
                        const std::string& content, bool standalone);

}  // namespace leastcost::app
