// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "app/report/space/space_image.hpp"
#include "app/report/space/workspace_view.hpp"
#include "problems/drawing/solids.hpp"

namespace leastcost::app {
namespace {

using Eigen::Vector3d;

constexpr Rgb kFirst = {112, 190, 236}, kLast = {0, 114, 178};  ///< Okabe-Ito, the first paler
constexpr Rgb kStill = {168, 170, 172}, kGround = {252, 251, 249};
constexpr double kBetween = 0.3;    ///< how opaque poses between are
constexpr int kReportPixels = 430;  ///< along the width of a report, whose pictures take the time of the run

Rgb between(double part) {
  Rgb out = kFirst;
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] += static_cast<int>(part * static_cast<double>(kLast[i] - kFirst[i]));
  return out;
}

std::string hex(const Rgb& colour) { return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]); }

std::vector<ImageLayer> layers_of(const Workspace& workspace, const Look& look) {
  std::vector<ImageLayer> layers;
  const auto add = [&](TriangleSoup surface, const Rgb& colour, double opacity) -> ImageLayer& {
    layers.push_back({std::move(surface), colour, opacity, false, true, opacity == 1});
    return layers.back();
  };
  if (look.obstacles) {
    ImageLayer& ground = add(workspace.ground, kGround, 1);
    ground.one_sided = true;
    ground.has_outline = ground.casts = false;
    add(workspace.obstacles, kSurfaceColour, 1);
  }
  constexpr int kSmooth = 36, kCoarse = 20;
  const int around = look.image_width > 0 ? kSmooth : kCoarse;
  const std::vector<bool> still = still_links(workspace);
  const std::vector<std::size_t> drawn = poses_drawn(workspace);
  add(robot_surface(
          workspace, 0, [&](std::size_t link) { return still[link]; }, around),
      kStill, 1);
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const bool end = k == 0 || k + 1 == drawn.size();
    if (end ? !look.ends : !look.others) continue;
    const double part = static_cast<double>(drawn[k]) / static_cast<double>(std::max<std::size_t>(1, drawn.back()));
    add(robot_surface(
            workspace, drawn[k], [&](std::size_t link) { return !still[link]; }, around),
        between(part), end ? 1 : kBetween);
  }
  return layers;
}

std::string sample(const Rgb& colour, double opacity) {
  return fmt::format(
      "<path fill=\"{}\" fill-opacity=\"{:.2g}\" stroke=\"{}\" stroke-width=\".7\" d=\"M3 1h24v10h-24Z\"/>",
      hex(colour), opacity, hex(colour_of_light(0, colour)));
}

/// What is drawn of the box, and its axes.
Eigen::AlignedBox2d area_of(const std::vector<ImageLayer>& layers, const Eigen::AlignedBox3d& box,
                            const SpaceView& view) {
  Eigen::AlignedBox2d all, area;
  for (int k = 0; k < 8; ++k)
    all.extend(Eigen::Vector2d((view.axes * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k))).head<2>()));
  for (const Vector3d& x : ends_of_axes(box, view)) area.extend(Eigen::Vector2d((view.axes * x).head<2>()));
  for (const ImageLayer& layer : layers)
    for (const Vector3d& x : layer.surface.vertices) area.extend(Eigen::Vector2d((view.axes * x).head<2>()));
  return area.intersection(all);
}

/// Axes need more room the longer their numbers are, which depends on the scale of the drawing.
Projector with_room_for_axes(const Eigen::AlignedBox3d& box, const Eigen::AlignedBox2d& area, const SpaceView& view,
                             const Look& look) {
  constexpr double kLeast = 6, kRim = 4;
  constexpr int kPasses = 5;
  Margins margins = {36, 22, 17, 30};
  for (int pass = 0; pass < kPasses; ++pass) {
    const Projector projector(area, view, look.width, look.height, margins);
    const Eigen::AlignedBox2d room = axes_in_space(box, view, projector, look).room;
    if (room.isEmpty()) break;
    margins.left = std::max(kLeast, margins.left - room.min()[0] + kRim);
    margins.top = std::max(kLeast, margins.top - room.min()[1] + kRim);
    margins.right = std::max(kLeast, margins.right + room.max()[0] - projector.width() + kRim);
    margins.bottom = std::max(kLeast, margins.bottom + room.max()[1] - projector.height() + kRim);
  }
  return {area, view, look.width, look.height, margins};
}

}  // namespace

Sketch workspace_sketch(const PoseStrip& strip, const SpaceView& view, const Look& look) {
  const int depth_pixels = look.image_width > 0 ? 800 : 400;
  const Workspace& workspace = strip.workspace;
  const Eigen::AlignedBox3d box(workspace.lower, workspace.upper);
  const std::vector<ImageLayer> layers = layers_of(workspace, look);
  const Eigen::AlignedBox2d area = area_of(layers, box, view);
  const Projector projector = with_room_for_axes(box, area, view, look);
  std::string out;
  if (look.shading) {
    const double whole = look.image_width > 0 ? look.image_width : kReportPixels;
    const double pixels =
        std::clamp(whole * projector.scale() * area.sizes().maxCoeff() / look.width, 2.0, kMostPixels);
    out += image_element(shaded_image(layers, view, area, static_cast<int>(pixels)), projector);
  }
  out += axes_in_space(box, view, projector, look).svg;
  if (look.path) {
    TriangleSoup before;
    for (const ImageLayer& layer : layers)
      if (layer.casts) append(before, layer.surface);
    out += line_in_space(strip.hand_in_space, "hand", projector, DepthMap(before, view, depth_pixels));
  }
  return {"The robot along its path",
          "Obstacles, the robot at the start and the target, some poses between, and the path of its hand",
          projector.width(), projector.height(), out};
}

std::vector<LegendEntry> legend_of_workspace(const PoseStrip& strip, const Look& look) {
  std::vector<LegendEntry> out;
  if (look.shading && look.ends) out.push_back({sample(kFirst, 1), "start", "start"});
  if (look.shading && look.ends) out.push_back({sample(kLast, 1), "target", "target"});
  if (look.shading && look.others) out.push_back({sample(between(0.5), kBetween), "between", "between"});
  if (look.path && strip.hand_in_space.cols() > 0)
    out.push_back({"<path class=\"hand\" d=\"M1 6h28\"/>", "path of the hand", "path"});
  if (look.shading && look.obstacles && !strip.workspace.obstacles.triangles.empty())
    out.push_back({sample(kSurfaceColour, 1), "obstacles", "obstacles"});
  return out;
}

}  // namespace leastcost::app
