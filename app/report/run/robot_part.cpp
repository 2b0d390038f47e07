// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/plot/text.hpp"
#include "app/report/run/viewer_part.hpp"
#include "app/report/space/workspace_view.hpp"
#include "catalogue/scene/workspace_json.hpp"

namespace leastcost::app {

Picture robot_picture(const RunFiles& files) {
  const PoseStrip& strip = files.scene.strip;
  if (strip.workspace.empty()) return {};
  const SpaceView view = choose_view(strip);
  Look look;
  look.unit = strip.workspace.unit;
  std::string caption = "The robot along its path. " + about_viewer();
  for (const std::string& note : strip.workspace.notes) caption += " Note: " + note + ".";
  const Points& hand = strip.hand_in_space;
  const nlohmann::json way = std::vector<double>(hand.data(), hand.data() + hand.size());
  StageContent content;
  content.still = svg(workspace_sketch(strip, view, look));
  content.legend = legend_of_workspace(strip, look);
  content.controls = fmt::format(
      "<p id=\"pose-row\" hidden><label>Start <input type=\"range\" id=\"pose\" min=\"0\" max=\"{0}\" value=\"{1}\" "
      "aria-label=\"Place on the path\"> target</label></p>\n",
      strip.workspace.poses.size() - 1, (strip.workspace.poses.size() - 1) / 2);
  content.caption = "<figcaption>" + escaped(caption) + "</figcaption>\n";
  content.data = fmt::format(R"({{"workspace":{},"hand":{},"view":{}}})", workspace_json(strip.workspace), way.dump(),
                             view_json(view, Eigen::Vector3d::UnitZ()));
  return staged(content);
}

}  // namespace leastcost::app
