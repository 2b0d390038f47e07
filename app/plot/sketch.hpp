// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace leastcost::app {

/// A drawing that is not yet on a page nor in a file, in px.
struct Sketch {
  std::string title, description;  ///< for screen readers
  double width = 0, height = 0;
  std::string content;  ///< SVG; colours by class
  bool empty() const { return content.empty(); }
};

/// As an element of a page, which has plot_style().
std::string svg(const Sketch& sketch);

/// The font size of all texts of a drawing, px.
inline constexpr double kDrawnFont = 11;

/// A figure on paper.
struct PrintSize {
  double width = 84;     ///< mm
  double font_size = 8;  ///< pt
  double dpi = 300;      ///< of what is drawn as pixels
  /// Width of a sketch that fills it, px.
  double sketch_width() const;
  /// Pixels for so much of a sketch.
  int pixels(double sketch_length) const;
};

/// As a file of its own: literal colours, a size in mm, on white, with lines as thin as on paper. The sketch stands in
/// the middle; no wider than size.sketch_width().
std::string printed_svg(const Sketch& sketch, const PrintSize& size);

}  // namespace leastcost::app
