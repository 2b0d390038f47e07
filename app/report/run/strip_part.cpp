// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <string>

#include "app/plot/chart.hpp"
#include "app/report/run/run_parts.hpp"

namespace leastcost::app {
namespace {

constexpr double kStripWidth = 860, kStripHeight = 560, kStripMargin = 14;
constexpr double kPalest = 0.12, kStrongest = 0.9;  ///< how opaque the first and the last pose are

}  // namespace

std::string strip_svg(const PoseStrip& strip) {
  if (strip.poses.empty()) return "";
  Eigen::AlignedBox2d box;
  const auto grow = [&](const Points& line) {
    for (const auto p : line.colwise())
      if (p.allFinite()) box.extend(Eigen::Vector2d(p));
  };
  for (const auto& pose : strip.poses)
    for (const Points& part : pose) grow(part);
  Eigen::AlignedBox2d shown = box;  // of obstacles what is not far off
  const double near = box.isEmpty() ? 0 : 0.5 * box.diagonal().norm();
  for (const Points& obstacle : strip.obstacles)
    for (const auto p : obstacle.colwise())
      if (p.allFinite() && box.exteriorDistance(Eigen::Vector2d(p)) < near) shown.extend(Eigen::Vector2d(p));
  if (shown.isEmpty()) return "";
  const Eigen::Vector2d extent = shown.sizes().cwiseMax(1e-12);
  const double scale =
      std::min((kStripWidth - 2 * kStripMargin) / extent[0], (kStripHeight - 2 * kStripMargin) / extent[1]);
  const auto outline = [&](const Points& line) {
    std::string d;
    for (const auto p : line.colwise())
      if (p.allFinite())
        fmt::format_to(std::back_inserter(d), "{}{:.1f} {:.1f}", d.empty() ? "M" : "L",
                       kStripMargin + scale * (p[0] - shown.min()[0]), kStripMargin + scale * (shown.max()[1] - p[1]));
    return d + "Z";
  };
  std::string out;
  for (const Points& obstacle : strip.obstacles)
    out += fmt::format("<path class=\"obstacle\" d=\"{}\"/>\n", outline(obstacle));
  for (std::size_t k = 0; k < strip.poses.size(); ++k) {
    const double part =
        strip.poses.size() > 1 ? static_cast<double>(k) / static_cast<double>(strip.poses.size() - 1) : 1;
    out += fmt::format("<g class=\"pose\" opacity=\"{:.2f}\">\n", kPalest + (kStrongest - kPalest) * part);
    for (const Points& one : strip.poses[k]) out += fmt::format("<path d=\"{}\"/>\n", outline(one));
    out += "</g>\n";
  }
  return svg_element("The robot along its path", "Some poses among the obstacles, later ones in stronger colours",
                     scale * extent[0] + 2 * kStripMargin, scale * extent[1] + 2 * kStripMargin, out, false);
}

}  // namespace leastcost::app
