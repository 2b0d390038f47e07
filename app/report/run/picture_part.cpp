// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plot/text.hpp"
#include "app/report/page/page.hpp"
#include "app/report/page/viewer_script.hpp"
#include "app/report/run/run_parts.hpp"
#include "app/report/run/space_view.hpp"
#include "problems/drawing/thinned.hpp"

namespace leastcost::app {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kDrawnTriangles = 3600;  ///< of the still picture
constexpr std::size_t kLookTriangles = 1200;   ///< enough to choose a side from which to look

Points ends_of(const RunFiles& files) {
  if (files.result.flag("ring") || files.points.cols() == 0) return Points(files.points.rows(), 0);
  Points ends(files.points.rows(), 2);
  ends << files.points.leftCols(1), files.points.rightCols(1);
  return ends;
}

/// One entry of a legend: a sample of what is drawn, its name; with a layer of the 3D view a box to switch it.
std::string entry(const std::string& sample, const std::string& name, const char* layer) {
  const std::string drawn =
      fmt::format("<svg class=\"plot\" width=\"30\" height=\"12\" aria-hidden=\"true\">{}</svg>", sample);
  if (layer == nullptr) return fmt::format("<span>{} {}</span>\n", drawn, name);
  return fmt::format("<label><input type=\"checkbox\" data-layer=\"{}\" checked>{} {}</label>\n", layer, drawn, name);
}

std::string legend_of(const RunFiles& files, bool layers) {
  const auto line = [](const char* name) { return fmt::format("<path class=\"{}\" d=\"M1 6h28\"/>", name); };
  std::string out = "<div class=\"legend\">\n" + entry(line("path"), "path", nullptr);
  out += entry("<circle class=\"point\" cx=\"15\" cy=\"6\" r=\"3\"/>", "its points, equally spaced in cost",
               layers ? "points" : nullptr);
  out += entry(line("first"), "first path", layers ? "first" : nullptr);
  if (!files.scene.lines.others.empty())
    out += entry(line("other"), "other paths of the family", layers ? "others" : nullptr);
  if (!files.result.flag("ring")) out += entry("<circle class=\"end\" cx=\"15\" cy=\"6\" r=\"4.5\"/>", "ends", nullptr);
  return out + "</div>\n";
}

std::string caption_of(const RunFiles& files, const std::string& before) {
  std::string text = before;
  for (const std::string& note : files.scene.notes) text += (text.empty() ? "" : " ") + ("Note: " + note + ".");
  return text.empty() ? "" : fmt::format("<figcaption>{}</figcaption>\n", escaped(text));
}

Json flat(const Points& x) { return std::vector<double>(x.data(), x.data() + x.size()); }

/// What the 3D view gets: the scene as it is in its file, and what only the report knows.
std::string viewer_data(const RunFiles& files, const SpaceView& view) {
  const Scene& scene = files.scene;
  Json extra = {{"markers", flat(files.points)},
                {"ends", flat(ends_of(files))},
                {"view",
                 {{"direction", {view.axes(2, 0), view.axes(2, 1), view.axes(2, 2)}},
                  {"up", {scene.up[0], scene.up[1], scene.up[2]}}}}};
  std::string text = scene_json(scene);
  const std::string more = extra.dump();
  text.replace(text.rfind('}'), 1, "," + more.substr(1));
  // A script element ends at the first "</script" whatever it holds.
  std::string safe;
  for (const char c : text) c == '<' ? safe += "\\u003c" : safe += c;
  return safe;
}

/// For choosing a side from which to look at a cloud, a thousand points are enough.
TriangleSoup few_squares(const Surfels& surfels) {
  const std::size_t step = surfels.positions.size() / 1000 + 1;
  Surfels few;
  for (std::size_t i = 0; i < surfels.positions.size(); i += step) {
    few.positions.push_back(surfels.positions[i]);
    few.normals.push_back(surfels.normals[i]);
  }
  few.spacing = surfels.spacing * std::sqrt(static_cast<double>(step));
  return squares(few);
}

Picture space_picture(const RunFiles& files) {
  const Scene& scene = files.scene;
  const TriangleSoup coarse = thinned(scene.surface, Points(3, 0), kDrawnTriangles);
  const SpaceView view =
      choose_view(coarse.triangles.empty() ? few_squares(scene.surfels) : thinned(coarse, Points(3, 0), kLookTriangles),
                  scene.lines.path, scene.up);
  const std::string still = space_svg(scene, coarse, files.points, ends_of(files), view);
  const bool viewer = !viewer_script().empty();
  std::string part = "<figure>\n<div class=\"stage\" id=\"stage\">" + still + "</div>\n";
  part += legend_of(files, viewer);
  if (viewer)
    part += "<p class=\"soft\" id=\"no-webgl\" hidden>This browser has no WebGL: the picture is static.</p>\n";
  part += caption_of(
      files,
      viewer ? "Drag to turn; click, then scroll or pinch to zoom; double-click to reset; keys: arrows, +, −, 0."
             : "This leastcost was built without npm, so it has no 3D view; open path.vtp or path.obj in a viewer.");
  part += "</figure>\n";
  if (!viewer) return {part, ""};
  return {part, "<script type=\"application/json\" id=\"scene\">" + viewer_data(files, view) + "</script>\n<script>" +
                    std::string(viewer_script()) + "</script>\n"};
}

bool holds_infinity(const Raster& raster) {
  return std::any_of(raster.values.begin(), raster.values.end(), [](double value) { return std::isinf(value); });
}

/// What the level lines of a bracket are; empty where there are none.
std::string about_potential(const RunFiles& files) {
  if (!files.scene.potential) return "";
  return " Thin lines: levels of the potential, which is a lower bound on cost, where the last grid still allowed a "
         "cheaper path; the rest had been ruled out.";
}

/// The robot in its workspace, where there is one.
std::string strip_part(const RunFiles& files) {
  const std::string svg = strip_svg(files.scene.strip);
  if (svg.empty()) return "";
  return "<figure>\n" + svg +
         "<figcaption>The robot along its path among the obstacles, later poses in stronger "
         "colours.</figcaption>\n</figure>\n";
}

/// The path on the map, over its ground in the sun, where there is one.
std::string map_part(const RunFiles& files) {
  if (!files.scene.relief) return "";
  std::string caption = "On the map: the ground, lit from the north-west at 45 degrees.";
  if (holds_infinity(*files.scene.relief)) caption += " Hatched: no data.";
  caption += about_potential(files);
  return "<figure>\n" + plane_svg(files) + "<figcaption>" + caption + "</figcaption>\n</figure>\n";
}

Picture space_of_path(const RunFiles& files) {
  if (files.scene.dimension == 3 && files.scene.lines.path.cols() > 0) {
    Picture picture = space_picture(files);
    picture.part += map_part(files);
    return picture;
  }
  if (files.scene.dimension == 2 && files.scene.lines.path.cols() > 0) {
    std::string bands;
    if (files.scene.cost)
      bands =
          "Shading: cost per unit of length, averaged over the possible directions, on a logarithmic scale; stronger "
          "means more expensive.";
    if (files.scene.cost && holds_infinity(*files.scene.cost)) bands += " Hatched: not reachable.";
    bands += about_potential(files);
    return {"<figure>\n" + plane_svg(files) + legend_of(files, false) + caption_of(files, bands) + "</figure>\n", ""};
  }
  return {figures({coordinates_svg(files)},
                  "A space of this dimension cannot be drawn; instead, the coordinates along the path are shown."),
          ""};
}

}  // namespace

Picture picture_of(const RunFiles& files) {
  Picture picture = space_of_path(files);
  picture.part = strip_part(files) + picture.part;
  return picture;
}

}  // namespace leastcost::app
