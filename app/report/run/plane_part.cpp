// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The plane, drawn to scale: cost as bands, box, obstacles, the domain where it is a curve, first path, path, points
// and ends.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "app/report/run/cost_bands.hpp"
#include "app/report/run/plane_frame.hpp"
#include "app/report/run/run_parts.hpp"

namespace leastcost::app {
namespace {

PlaneFrame frame_of(const RunFiles& files, const Look& look) {
  const Scene& scene = files.scene;
  if (scene.cost) return {scene.cost->lower, scene.cost->upper, look};
  if (scene.relief) return {scene.relief->lower, scene.relief->upper, look};
  Eigen::AlignedBox2d box(Eigen::Vector2d(files.points.col(0)));
  const auto grow = [&](const Points& x) {
    for (const auto p : x.colwise())
      if (p.allFinite()) box.extend(Eigen::Vector2d(p));
  };
  grow(files.points);
  grow(scene.lines.path);
  grow(scene.lines.first);
  for (const auto* lines : {&scene.curves, &scene.obstacles, &scene.margins, &scene.free})
    for (const Points& line : *lines) grow(line);
  const double longest = std::max(box.sizes().maxCoeff(), 1e-12);
  const Eigen::Vector2d missing = ((0.35 * longest - box.sizes().array()) / 2).max(0.0) + 0.06 * longest;
  return {box.min() - missing, box.max() + missing, look};
}

PlaneFrame frame_above_bar(const RunFiles& files, Look look) {
  if (files.scene.cost && look.shading) look.height -= cost_bar_height();
  return frame_of(files, look);
}

std::string drawn(const std::vector<Points>& lines, const PlaneFrame& frame, const char* name) {
  std::string out;
  for (const Points& line : lines) out += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", name, frame.line(line));
  return out;
}

std::vector<std::string> closed(const std::vector<Points>& lines, const PlaneFrame& frame) {
  std::vector<std::string> paths;
  paths.reserve(lines.size());
  for (const Points& line : lines) paths.push_back(frame.line(line) + "Z");
  return paths;
}

/// What no path may enter: outside the free part, and obstacles with the margin around them.
std::string obstacles_of(const Scene& scene, const PlaneFrame& frame) {
  std::string blocked;
  for (const std::string& outline : closed(scene.free, frame)) blocked += outline;
  return (blocked.empty() ? "" : areas({frame.border() + blocked}, "obstacle")) +
         areas(closed(scene.margins, frame), "margin") + areas(closed(scene.obstacles, frame), "obstacle");
}

/// Whether a side of the box lies within the frame.
bool shows_walls(const Scene& scene, const PlaneFrame& frame) {
  for (Index i = 0; i < scene.lower.size() && i < 2; ++i)
    if ((scene.lower[i] > frame.range(i).least) || (scene.upper[i] < frame.range(i).largest)) return true;
  return false;
}

/// The sides of the box that lie within the frame, and the forbidden side of each.
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

std::string path_marks(const RunFiles& files, const PlaneFrame& frame, const Look& look) {
  constexpr Index kMostPoints = 400, kMany = 120;
  std::string out;
  const auto circle = [&](Index i, const char* name, double radius) {
    out += fmt::format("<circle class=\"{}\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2g}\"/>\n", name,
                       frame.x(files.points(0, i)), frame.y(files.points(1, i)), radius);
  };
  const Index count = files.points.cols();
  if (look.points && (look.printed || count <= kMostPoints))
    for (Index i = 0; i < count; ++i) circle(i, "point", look.mark(count > kMany ? 1.5 : 2.4));
  if (!look.ends || files.result.flag("ring")) return out;
  for (const Index end : {Index(0), count - 1}) circle(end, "end", look.mark(5.5));
  return out;
}

std::string clip_and_hatch(const PlaneFrame& frame) {
  return fmt::format(
      "<defs><clipPath id=\"inside\"><path d=\"{}\"/></clipPath><pattern id=\"hatch\" width=\"7\" height=\"7\" "
      "patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><path class=\"hatch\" d=\"M0 "
      "0v7\"/></pattern></defs>\n",
      frame.border());
}

}  // namespace

bool shows_walls(const RunFiles& files) { return shows_walls(files.scene, frame_of(files, {})); }

PlaneMap plane_map(const RunFiles& files, const Look& look) {
  const PlaneFrame frame = frame_above_bar(files, look);
  return {frame.left(),
          frame.top(),
          frame.width(),
          frame.height(),
          frame.width() / (frame.range(0).largest - frame.range(0).least),
          frame.range(0).least,
          frame.range(1).largest};
}

Sketch plane_sketch(const RunFiles& files, const Look& look) {
  const Scene& scene = files.scene;
  const bool bar = scene.cost && look.shading;
  const PlaneFrame frame = frame_above_bar(files, look);
  std::string inside;
  if (scene.cost && look.shading) inside += cost_bands(*scene.cost, frame);
  if (scene.relief && look.shading) inside += hillshade(*scene.relief, frame);
  if (scene.potential && look.shading) inside += potential_lines(*scene.potential, frame);
  if (look.obstacles) inside += obstacles_of(scene, frame) + box_sides(scene, frame);
  inside += drawn(scene.curves, frame, "domain");
  if (look.first) inside += drawn({scene.lines.first}, frame, "first");
  if (look.others) inside += drawn(scene.lines.others, frame, "other");
  if (look.path) inside += drawn({scene.lines.path}, frame, "path");
  std::string out = clip_and_hatch(frame);
  out += fmt::format("<g clip-path=\"url(#inside)\">\n{}</g>\n", inside);
  out += frame.axes(look.axis(files.coordinates[0]), look.axis(files.coordinates[1]));
  out += path_marks(files, frame, look);
  double height = frame.total_height();
  if (bar) {
    const std::string unit = files.result.text("cost.unit");
    out += cost_bar(*scene.cost, frame, height + 4,
                    unit == "length" || unit == "cost" ? "cost per unit of length"
                    : look.unit.empty()                ? "cost per unit of length (" + unit + ")"
                                                       : "cost per length (" + unit + "/" + look.unit + ")");
    height += cost_bar_height();
  }
  return {"The path in the plane", "The path, its points, its ends and the first path, drawn to scale",
          frame.total_width(), height, out};
}

}  // namespace leastcost::app
