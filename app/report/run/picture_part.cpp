// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plot/text.hpp"
#include "app/report/page/page.hpp"
#include "app/report/page/viewer_script.hpp"
#include "app/report/run/clicks_part.hpp"
#include "app/report/run/run_parts.hpp"
#include "app/report/run/viewer_part.hpp"
#include "app/report/space/space_view.hpp"

namespace leastcost::app {
namespace {

using Json = nlohmann::json;

std::string caption_of(const RunFiles& files, const std::string& before) {
  std::string text = before;
  for (const std::string& note : files.scene.notes) {
    // The view has the whole mesh.
    if (!viewer_script().empty() && has_clicked_mesh(files) && note.starts_with("drawn with ")) continue;
    text += (text.empty() ? "" : " ") + ("Note: " + note + ".");
  }
  return text.empty() ? "" : fmt::format("<figcaption>{}</figcaption>\n", escaped(text));
}

Json flat(const Points& x) { return std::vector<double>(x.data(), x.data() + x.size()); }

/// What the 3D view gets: the scene as it is in its file, and what only the report knows.
std::string viewer_data(const RunFiles& files, const SpaceView& view) {
  Scene scene = files.scene;
  if (has_clicked_mesh(files)) scene.surface = {};  // what answers clicks has all of it
  const Json extra = {{"markers", flat(files.points)},
                      {"ends", flat(ends_of(files))},
                      {"view", Json::parse(view_json(view, scene.up))}};
  std::string text = scene_json(scene);
  const std::string more = extra.dump();
  return text.replace(text.rfind('}'), 1, "," + more.substr(1));
}

Picture space_picture(const RunFiles& files) {
  const SpaceView view = choose_view(files.scene);
  const std::string still = svg(space_sketch(files, view, {}));
  if (!files.scene.strip.workspace.empty())  // which has the 3D view
    return {"<figure>\n" + still + legend_html(legend_of(files, {}), false) + caption_of(files, "") + "</figure>\n",
            ""};
  return staged({.still = still,
                 .legend = legend_of(files, {}),
                 .caption = caption_of(files, about_viewer()),
                 .data = viewer_data(files, view)});
}

/// What the level lines of a bracket are; empty where there are none.
std::string about_potential(const RunFiles& files) {
  if (!files.scene.potential) return "";
  return " Thin lines: levels of the potential, which is a lower bound on cost, where the last grid still allowed a "
         "cheaper path; the rest had been ruled out.";
}

/// The robot in its workspace, where there is one.
std::string strip_part(const RunFiles& files) {
  const Sketch strip = strip_sketch(files.scene.strip, {});
  if (strip.empty()) return "";
  return "<figure>\n" + svg(strip) + legend_html(legend_of(files.scene.strip, {}), false) +
         "<figcaption>The robot along its path. " + strip.description + ".</figcaption>\n</figure>\n";
}

/// The path on the map, over its ground in the sun, where there is one.
std::string map_part(const RunFiles& files) {
  if (!files.scene.relief) return "";
  const std::string caption = "On the map: the ground, lit from the north-west at 45 degrees." + about_potential(files);
  return "<figure>\n" + svg(plane_sketch(files, {})) + legend_html(legend_of(files, {}, true), false) + "<figcaption>" +
         caption + "</figcaption>\n</figure>\n";
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
    bands += about_potential(files);
    return {"<figure id=\"plane\">\n" + svg(plane_sketch(files, {})) + legend_html(legend_of(files, {}), false) +
                caption_of(files, bands) + "</figure>\n",
            ""};
  }
  return {figures({svg(coordinates_sketch(files, {}))},
                  "A space of this dimension cannot be drawn; instead, the coordinates along the path are shown."),
          ""};
}

}  // namespace

Picture picture_of(const RunFiles& files) {
  Picture picture = space_of_path(files);
  const Picture robot = robot_picture(files);
  picture.part = (robot.part.empty() ? strip_part(files) : robot.part) + picture.part + clicks_panel(files);
  picture.script = clicks_scripts(files) + robot.script + picture.script;  // the view draws what it unpacks
  return picture;
}

}  // namespace leastcost::app
