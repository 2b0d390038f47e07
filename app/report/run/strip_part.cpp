// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <string>

#include "app/report/run/run_parts.hpp"

namespace leastcost::app {
namespace {

constexpr double kStripMargin = 8, kBetweenPanels = 5;
constexpr double kPalest = 0.12, kStrongest = 0.9;  ///< how opaque the first and the last pose are
constexpr double kCrowded = 0.2;                    ///< of what all poses cover, what one does on average
constexpr double kRim = 0.02;                       ///< around everything, of its size
constexpr std::size_t kPanelsPerRow = 4;

void extend(Eigen::AlignedBox2d& box, const std::vector<Points>& lines) {
  for (const Points& line : lines)
    for (const auto p : line.colwise())
      if (p.allFinite()) box.extend(Eigen::Vector2d(p));
}

Eigen::AlignedBox2d box_of_poses(const PoseStrip& strip) {
  Eigen::AlignedBox2d box;
  for (const auto& pose : strip.poses) extend(box, pose);
  return box;
}

/// An arm stays where it is: its poses lie upon each other, and each gets a panel of its own.
bool has_panels(const PoseStrip& strip) {
  const Eigen::AlignedBox2d all = box_of_poses(strip);
  double sum = 0;
  for (const auto& pose : strip.poses) {
    Eigen::AlignedBox2d box;
    extend(box, pose);
    if (!box.isEmpty()) sum += box.volume();
  }
  return !all.isEmpty() && sum > kCrowded * all.volume() * static_cast<double>(strip.poses.size());
}

/// The workspace, mapped to a panel.
class Panel {
 public:
  Panel(const PoseStrip& strip, double width, double height) {
    const Eigen::AlignedBox2d box = box_of_poses(strip);
    box_ = box;  // of obstacles what is not far off
    const double near = box.isEmpty() ? 0 : 0.5 * box.diagonal().norm();
    for (const Points& obstacle : strip.obstacles)
      for (const auto p : obstacle.colwise())
        if (p.allFinite() && box.exteriorDistance(Eigen::Vector2d(p)) < near) box_.extend(Eigen::Vector2d(p));
    if (box_.isEmpty()) return;
    const Eigen::Vector2d rim = Eigen::Vector2d::Constant(kRim * box_.sizes().maxCoeff());
    box_ = Eigen::AlignedBox2d(box_.min() - rim, box_.max() + rim);
    const Eigen::Vector2d extent = box_.sizes().cwiseMax(1e-12);
    scale_ = std::min(width / extent[0], height / extent[1]);
  }
  bool empty() const { return box_.isEmpty(); }
  double width() const { return scale_ * box_.sizes()[0]; }
  double height() const { return scale_ * box_.sizes()[1]; }

  /// SVG path data.
  std::string outline(const Points& line) const {
    std::string d;
    for (const auto p : line.colwise())
      if (p.allFinite())
        fmt::format_to(std::back_inserter(d), "{}{:.2f} {:.2f}", d.empty() ? "M" : "L", scale_ * (p[0] - box_.min()[0]),
                       scale_ * (box_.max()[1] - p[1]));
    return d;
  }
  std::string obstacles(const PoseStrip& strip) const {
    std::vector<std::string> paths;
    for (const Points& obstacle : strip.obstacles) paths.push_back(outline(obstacle) + "Z");
    return areas(paths, "obstacle");
  }
  std::string pose(const std::vector<Points>& parts, double opacity) const {
    std::string out = fmt::format("<g class=\"pose\" opacity=\"{:.2f}\">\n", opacity);
    for (const Points& one : parts) out += fmt::format("<path d=\"{}Z\"/>\n", outline(one));
    return out + "</g>\n";
  }
  std::string hand(const PoseStrip& strip) const {
    return strip.hand.cols() > 0 ? fmt::format("<path class=\"hand\" d=\"{}\"/>\n", outline(strip.hand)) : "";
  }

 private:
  Eigen::AlignedBox2d box_;
  double scale_ = 1;
};

std::string moved(double x, double y, const std::string& content) {
  return fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n{}</g>\n", x, y, content);
}

/// All poses in one workspace.
Sketch one_workspace(const PoseStrip& strip, const Look& look) {
  const Panel panel(strip, look.width - 2 * kStripMargin, look.height - 2 * kStripMargin);
  if (panel.empty()) return {};
  std::string out = look.obstacles ? panel.obstacles(strip) : "";
  for (std::size_t k = 0; k < strip.poses.size(); ++k) {
    const double part =
        strip.poses.size() > 1 ? static_cast<double>(k) / static_cast<double>(strip.poses.size() - 1) : 1;
    out += panel.pose(strip.poses[k], kPalest + (kStrongest - kPalest) * part);
  }
  if (look.path) out += panel.hand(strip);
  return {"The robot along its path", "Some poses among the obstacles, later ones in stronger colours",
          panel.width() + 2 * kStripMargin, panel.height() + 2 * kStripMargin, moved(kStripMargin, kStripMargin, out)};
}

/// One panel for each pose, in rows, with its number.
Sketch panels(const PoseStrip& strip, const Look& look) {
  const std::size_t columns = std::min(kPanelsPerRow, strip.poses.size()),
                    rows = (strip.poses.size() + columns - 1) / columns;
  const auto room = [](double all, std::size_t count) {
    return (all - kBetweenPanels * static_cast<double>(count - 1) - 2) / static_cast<double>(count);
  };
  const Panel panel(strip, room(look.width, columns), room(look.height, rows));
  if (panel.empty()) return {};
  const std::string clip =
      fmt::format("<defs><clipPath id=\"panel\"><rect width=\"{:.1f}\" height=\"{:.1f}\"/></clipPath></defs>\n",
                  panel.width(), panel.height());
  std::string out = clip;
  for (std::size_t k = 0; k < strip.poses.size(); ++k) {
    const std::size_t row = k / columns;
    std::string inside = look.obstacles ? panel.obstacles(strip) : "";
    inside += panel.pose(strip.poses[k], kStrongest);
    if (look.path) inside += panel.hand(strip);
    out += moved(1 + (panel.width() + kBetweenPanels) * static_cast<double>(k % columns),
                 1 + (panel.height() + kBetweenPanels) * static_cast<double>(row),
                 fmt::format("<g clip-path=\"url(#panel)\">\n{}</g><rect class=\"axis\" width=\"{:.1f}\" "
                             "height=\"{:.1f}\"/><text x=\"4\" y=\"12\">{}</text>\n",
                             inside, panel.width(), panel.height(), k + 1));
  }
  const auto total = [](double one, std::size_t count) {
    return 2 + one * static_cast<double>(count) + kBetweenPanels * static_cast<double>(count - 1);
  };
  return {"The robot along its path", "Some poses among the obstacles, one in each panel",
          total(panel.width(), columns), total(panel.height(), rows), out};
}

}  // namespace

Sketch strip_sketch(const PoseStrip& strip, const Look& look) {
  if (strip.poses.empty()) return {};
  return has_panels(strip) ? panels(strip, look) : one_workspace(strip, look);
}

std::vector<LegendEntry> legend_of(const PoseStrip& strip, const Look& look) {
  std::vector<LegendEntry> out;
  if (!has_panels(strip))
    out.push_back(
        {"<g class=\"pose\" opacity=\".2\"><path d=\"M1 1h8v10h-8Z\"/></g><g class=\"pose\" opacity=\".5\"><path "
         "d=\"M11 1h8v10h-8Z\"/></g><g class=\"pose\" opacity=\".9\"><path d=\"M21 1h8v10h-8Z\"/></g>",
         "poses, later ones stronger"});
  if (has_panels(strip)) out.push_back({"<g class=\"pose\"><path d=\"M3 1h24v10h-24Z\"/></g>", "robot"});
  if (look.path && strip.hand.cols() > 0) out.push_back({"<path class=\"hand\" d=\"M1 6h28\"/>", "path of the hand"});
  if (look.obstacles && !strip.obstacles.empty()) out.push_back({areas({"M3 1h24v10h-24Z"}, "obstacle"), "obstacles"});
  return out;
}

}  // namespace leastcost::app
