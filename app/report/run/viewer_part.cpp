// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/run/viewer_part.hpp"

#include <fmt/format.h>

#include "app/report/page/viewer_script.hpp"

namespace leastcost::app {
namespace {

/// A script element ends at the first "</script" whatever it holds.
std::string safe(const std::string& json) {
  std::string out;
  for (const char c : json) c == '<' ? out += "\\u003c" : out += c;
  return out;
}

}  // namespace

Picture staged(const StageContent& content) {
  const bool viewer = !viewer_script().empty();
  std::string part = "<figure>\n<div class=\"stage\" id=\"stage\">" + content.still + "</div>\n";
  if (viewer) part += content.controls;
  part += legend_html(content.legend, viewer);
  if (viewer)
    part += "<p class=\"soft\" id=\"no-webgl\" hidden>This browser has no WebGL: the picture is static.</p>\n";
  part += content.caption + "</figure>\n";
  if (!viewer) return {part, ""};
  return {part, "<script type=\"application/json\" id=\"scene\">" + safe(content.data) + "</script>\n<script>" +
                    std::string(viewer_script()) + "</script>\n"};
}

std::string about_viewer() {
  return viewer_script().empty()
             ? "This leastcost was built without npm, so it has no 3D view; open path.vtp or path.obj in a viewer."
             : "Drag to turn; click, then scroll or pinch to zoom; double-click to reset; keys: arrows, +, −, 0.";
}

std::string view_json(const SpaceView& view, const Eigen::Vector3d& up) {
  const Eigen::Vector3d d = view.direction();
  return fmt::format(R"({{"direction":[{},{},{}],"up":[{},{},{}]}})", d[0], d[1], d[2], up[0], up[1], up[2]);
}

}  // namespace leastcost::app
