// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/run/cost_bands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/plot/contour.hpp"
#include "app/plot/sketch.hpp"
#include "app/plot/text.hpp"

namespace leastcost::app {
namespace {

constexpr int kBands = 8;
constexpr double kBarHeight = 9, kBarTotal = 42;  // px

const char* class_of(BandColour colour) { return colour == BandColour::warm ? "warm" : "band"; }

/// From nodes of a raster to the drawing.
ToDrawing columns_of(const Raster& raster, const PlaneFrame& frame) {
  return [&](double i) {
    return frame.x(raster.lower[0] + (raster.upper[0] - raster.lower[0]) * i / (raster.columns - 1));
  };
}
ToDrawing rows_of(const Raster& raster, const PlaneFrame& frame) {
  return
      [&](double j) { return frame.y(raster.lower[1] + (raster.upper[1] - raster.lower[1]) * j / (raster.rows - 1)); };
}

std::string ground(const char* name, const Raster& raster, const PlaneFrame& frame) {
  return fmt::format("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", name,
                     frame.x(raster.lower[0]), frame.y(raster.upper[1]), frame.width(), frame.height());
}

}  // namespace

std::vector<Tick> cost_levels(const Raster& raster) {
  std::vector<double> finite;
  for (const double value : raster.values)
    if (std::isfinite(value) && value > 0) finite.push_back(value);
  if (finite.empty()) return {};
  std::sort(finite.begin(), finite.end());
  const double low = finite[finite.size() / 50], high = finite[finite.size() - 1 - finite.size() / 50];
  std::vector<Tick> levels;
  levels.reserve(kBands);
  for (int k = 0; k < kBands; ++k) {
    const double level = low * std::pow(high / low, (k + 0.5) / kBands);
    levels.push_back({level, number_text(level, 2)});
  }
  return levels;
}

std::string cost_bands(const Raster& raster, const std::vector<Tick>& levels, const PlaneFrame& frame,
                       BandColour colour) {
  const Grid grid{raster.columns, raster.rows, raster.values};
  const ToDrawing x = columns_of(raster, frame), y = rows_of(raster, frame);
  std::string out = ground("band0", raster, frame);
  for (const Tick& level : levels)
    out += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", class_of(colour), region_above(grid, level.at, x, y));
  const std::string none = region_infinite(grid, x, y);
  // What has no cost is not dear: the bands below it are covered.
  return none.empty() ? out
                      : out + fmt::format("<path class=\"band0\" d=\"{0}\"/><path class=\"out\" d=\"{0}\"/>\n", none);
}

std::string cost_bar(const std::vector<Tick>& levels, const PlaneFrame& frame, BandColour colour, double top,
                     const std::string& title) {
  const double width = frame.width(), band = width / static_cast<double>(levels.size() + 1);
  const auto rectangle = [&](const char* name, double from) {
    return fmt::format("<rect class=\"{}\" x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{}\"/>\n", name,
                       frame.left() + from, top, width - from, kBarHeight);
  };
  std::string out = rectangle("band0", 0);
  double end = -kDrawnFont;  // of the label before
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const double at = band * static_cast<double>(k + 1);
    const std::string& label = levels[k].label;
    const double half = kDrawnFont * text_width(label) / 2;
    out += rectangle(class_of(colour), at);
    if (at - half < end + 4) continue;
    end = at + half;
    out += fmt::format(
        "<path class=\"axis\" d=\"M{0:.2f} {1:.1f}v3\"/><text x=\"{0:.2f}\" y=\"{2:.1f}\" "
        "text-anchor=\"middle\">{3}</text>\n",
        frame.left() + at, top + kBarHeight, top + kBarHeight + 14, label);
  }
  out += fmt::format("<rect class=\"axis\" x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{}\"/>\n", frame.left(),
                     top, width, kBarHeight);
  return out + fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                           frame.left() + width / 2, top + kBarHeight + 28, escaped(title));
}

double cost_bar_height() { return kBarTotal; }

std::string hillshade(const Raster& raster, const PlaneFrame& frame) {
  constexpr int kShades = 14;
  double darkest = 1, lightest = 0;
  for (const double value : raster.values)
    if (std::isfinite(value)) darkest = std::min(darkest, value), lightest = std::max(lightest, value);
  const Grid grid{raster.columns, raster.rows, raster.values};
  const ToDrawing x = columns_of(raster, frame), y = rows_of(raster, frame);
  std::string out = ground("shade0", raster, frame);
  for (int k = 1; k < kShades; ++k)
    out += fmt::format("<path class=\"shade\" d=\"{}\"/>\n",
                       region_above(grid, darkest + (lightest - darkest) * k / kShades, x, y));
  return out + fmt::format("<path class=\"out\" d=\"{}\"/>\n", region_infinite(grid, x, y));
}

std::string level_lines(const Raster& raster, const std::vector<Tick>& levels, const PlaneFrame& frame) {
  const Grid grid{raster.columns, raster.rows, raster.values};
  const ToDrawing x = columns_of(raster, frame), y = rows_of(raster, frame);
  std::string out;
  for (const Tick& level : levels)
    out += fmt::format("<path class=\"level\" d=\"{}\"/>\n", line_at(grid, level.at, x, y));
  return out;
}

std::string potential_lines(const Raster& raster, const PlaneFrame& frame) {
  constexpr int kLines = 20;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : raster.values)
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  if (!(low < high)) return "";
  std::vector<Tick> levels;
  levels.reserve(kLines);
  for (int k = 1; k < kLines; ++k) levels.push_back({low + (high - low) * k / kLines, ""});
  return level_lines(raster, levels, frame);
}

}  // namespace leastcost::app
