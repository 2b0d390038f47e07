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
#include "app/report/run/plane_surroundings.hpp"
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
  if (scene.cost && look.shading) inside += cost_bands(*scene.cost, cost_levels(*scene.cost), frame, BandColour::grey);
  if (scene.relief && look.shading) inside += hillshade(*scene.relief, frame);
  if (scene.potential && look.shading) inside += potential_lines(*scene.potential, frame);
  if (look.obstacles) inside += obstacles_in(scene, frame) + box_sides(scene, frame);
  inside += polylines(scene.curves, frame, "domain");
  if (look.first) inside += polylines({scene.lines.first}, frame, "first");
  if (look.others) inside += polylines(scene.lines.others, frame, "other");
  if (look.path) inside += polylines({scene.lines.path}, frame, "path");
  std::string out = clip_and_hatch(frame);
  out += fmt::format("<g clip-path=\"url(#inside)\">\n{}</g>\n", inside);
  out += frame.axes(look.axis(files.coordinates[0]), look.axis(files.coordinates[1]));
  out += path_marks(files, frame, look);
  double height = frame.total_height();
  if (bar) {
    const std::string unit = files.result.text("cost.unit");
    out += cost_bar(cost_levels(*scene.cost), frame, BandColour::grey, height + 4,
                    unit == "length" || unit == "cost" ? "cost per unit of length"
                    : look.unit.empty()                ? "cost per unit of length (" + unit + ")"
                                                       : "cost per length (" + unit + "/" + look.unit + ")");
    height += cost_bar_height();
  }
  return {"The path in the plane", "The path, its points, its ends and the first path, drawn to scale",
          frame.total_width(), height, out};
}

}  // namespace leastcost::app
