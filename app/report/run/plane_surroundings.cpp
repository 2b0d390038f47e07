// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/run/plane_surroundings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace leastcost::app {
namespace {

std::vector<std::string> closed(const std::vector<Points>& lines, const PlaneFrame& frame) {
  std::vector<std::string> paths;
  paths.reserve(lines.size());
  for (const Points& line : lines) paths.push_back(frame.line(line) + "Z");
  return paths;
}

}  // namespace

std::string polylines(const std::vector<Points>& lines, const PlaneFrame& frame, const char* name) {
  std::string out;
  for (const Points& line : lines) out += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", name, frame.line(line));
  return out;
}

std::string obstacles_in(const Scene& scene, const PlaneFrame& frame) {
  std::string blocked;
  for (const std::string& outline : closed(scene.free, frame)) blocked += outline;
  return (blocked.empty() ? "" : areas({frame.border() + blocked}, "obstacle")) +
         areas(closed(scene.margins, frame), "margin") + areas(closed(scene.obstacles, frame), "obstacle");
}

bool shows_walls(const Scene& scene, const PlaneFrame& frame) {
  for (Index i = 0; i < scene.lower.size() && i < 2; ++i)
    if ((scene.lower[i] > frame.range(i).least) || (scene.upper[i] < frame.range(i).largest)) return true;
  return false;
}

std::string box_sides(const Scene& scene, const PlaneFrame& frame) {
  if (scene.lower.size() == 0) return "";
  const auto within = [&](Index i) {
    const Range range = frame.range(i);
    return Range{std::clamp(scene.lower[i], range.least, range.largest),
                 std::clamp(scene.upper[i], range.least, range.largest)};
  };
  const Range x = within(0), y = within(1);
  std::string d;
  for (const double side : {scene.lower[0], scene.upper[0]})
    if (side >= frame.range(0).least && side <= frame.range(0).largest)
      d += fmt::format("M{:.1f} {:.1f}V{:.1f}", frame.x(side), frame.y(y.least), frame.y(y.largest));
  for (const double side : {scene.lower[1], scene.upper[1]})
    if (side >= frame.range(1).least && side <= frame.range(1).largest)
      d += fmt::format("M{:.1f} {:.1f}H{:.1f}", frame.x(x.least), frame.y(side), frame.x(x.largest));
  std::string out;
  if (shows_walls(scene, frame))
    out = fmt::format("<path class=\"out\" fill-rule=\"evenodd\" d=\"{}M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}Z\"/>\n",
                      frame.border(), frame.x(x.least), frame.y(y.least), frame.x(x.largest), frame.y(y.largest),
                      frame.x(x.least));
  return d.empty() ? out : out + fmt::format("<path class=\"wall\" d=\"{}\"/>\n", d);
}

std::string clip_and_hatch(const PlaneFrame& frame) {
  return fmt::format(
      "<defs><clipPath id=\"inside\"><path d=\"{}\"/></clipPath><pattern id=\"hatch\" width=\"7\" height=\"7\" "
      "patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><path class=\"hatch\" d=\"M0 "
      "0v7\"/></pattern></defs>\n",
      frame.border());
}

LegendEntry line_entry(const char* name, std::string words) {
  return {fmt::format("<path class=\"{}\" d=\"M1 6h28\"/>", name), std::move(words)};
}

LegendEntry area_entry(const char* name, std::string words) {
  return {fmt::format("<path class=\"{}\" d=\"M3 1h24v10h-24Z\"/>", name), std::move(words)};
}

LegendEntry mark_entry(const char* name, double radius, std::string words) {
  return {fmt::format("<circle class=\"{}\" cx=\"15\" cy=\"6\" r=\"{:.2g}\"/>", name, radius), std::move(words)};
}

void add_surroundings(const Scene& scene, bool walls, const Look& look, std::vector<LegendEntry>& out) {
  if (!look.obstacles) return;
  if (!scene.obstacles.empty()) out.push_back({areas({"M3 1h24v10h-24Z"}, "obstacle"), "obstacles"});
  if (!scene.free.empty()) out.push_back({areas({"M3 1h24v10h-24Z"}, "obstacle"), "blocked"});
  if (!scene.margins.empty()) out.push_back({areas({"M3 1h24v10h-24Z"}, "margin"), "clearance"});
  if (!walls) return;
  out.push_back(area_entry("out", "outside the box"));
  out.back().sample += "<path class=\"wall\" d=\"M3 1v10\"/>";
}

}  // namespace leastcost::app
