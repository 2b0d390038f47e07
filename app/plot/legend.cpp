// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/plot/legend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plot/text.hpp"

namespace leastcost::app {

std::string areas(const std::vector<std::string>& paths, const std::string& name) {
  std::string out;
  for (const std::string& d : paths) out += fmt::format("<path class=\"{}-edge\" d=\"{}\"/>\n", name, d);
  for (const std::string& d : paths)
    out += fmt::format("<path class=\"{}\" fill-rule=\"evenodd\" d=\"{}\"/>\n", name, d);
  return out;
}

std::string legend_html(const std::vector<LegendEntry>& entries, bool layers) {
  std::string out = "<div class=\"legend\">\n";
  for (const LegendEntry& entry : entries) {
    const std::string drawn =
        fmt::format("<svg class=\"plot\" width=\"30\" height=\"12\" aria-hidden=\"true\">{}</svg> {}", entry.sample,
                    escaped(entry.name));
    out +=
        layers && !entry.layer.empty()
            ? fmt::format("<label><input type=\"checkbox\" data-layer=\"{}\" checked>{}</label>\n", entry.layer, drawn)
            : fmt::format("<span>{}</span>\n", drawn);
  }
  return out + "</div>\n";
}

Sketch legend_sketch(const std::vector<LegendEntry>& entries, double width) {
  constexpr double kSample = 30, kGap = 5, kBetween = 12, kRow = 15, kBaseline = 9.8;
  if (entries.empty()) return {};
  std::vector<double> widths;
  widths.reserve(entries.size());
  for (const LegendEntry& entry : entries)
    widths.push_back(kSample + kGap + kDrawnFont * text_width(entry.name) + kBetween);
  // The most columns whose widest entries fit side by side.
  std::vector<double> columns;
  for (std::size_t count = entries.size(); count >= 1; --count) {
    columns.assign(count, 0);
    for (std::size_t k = 0; k < widths.size(); ++k) columns[k % count] = std::max(columns[k % count], widths[k]);
    double sum = -kBetween;
    for (const double column : columns) sum += column;
    if (sum <= width) break;
  }
  Sketch sketch{"Legend", "What is drawn how", 0, 0, ""};
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const std::size_t column = k % columns.size(), row = k / columns.size();
    double x = 0;
    for (std::size_t c = 0; c < column; ++c) x += columns[c];
    const double y = kRow * static_cast<double>(row);
    sketch.content += fmt::format("<g transform=\"translate({:.1f} {:.1f})\">{}<text x=\"{}\" y=\"{}\">{}</text></g>\n",
                                  x, y, entries[k].sample, kSample + kGap, kBaseline, escaped(entries[k].name));
    sketch.width = std::max(sketch.width, x + widths[k] - kBetween);
    sketch.height = y + kRow;
  }
  return sketch;
}

Sketch below(Sketch upper, const Sketch& lower) {
  constexpr double kGap = 8;
  if (lower.empty()) return upper;
  if (upper.empty()) return lower;
  const double width = std::max(upper.width, lower.width);
  const auto moved = [&](const Sketch& sketch, double y) {
    return fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n{}</g>\n", (width - sketch.width) / 2, y,
                       sketch.content);
  };
  upper.content = moved(upper, 0) + moved(lower, upper.height + kGap);
  upper.height += kGap + lower.height;
  upper.width = width;
  return upper;
}

}  // namespace leastcost::app
