// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/plot/legend.hpp"
#include "app/report/space/look.hpp"
#include "app/report/space/space_marks.hpp"
#include "app/report/space/space_view.hpp"
#include "catalogue/scene/scene.hpp"

namespace leastcost::app {

/// The poses of a robot that a picture has, ascending by place on the path: the first and the last one, and some
/// between.
std::vector<std::size_t> poses_drawn(const Workspace& workspace);

/// Links that stand still on the whole path.
std::vector<bool> still_links(const Workspace& workspace);

/// The parts of a robot in one pose. `wanted`: the links whose parts are, by their number. `around`: corners of a
/// circle.
TriangleSoup robot_surface(const Workspace& workspace, std::size_t pose, const std::function<bool(std::size_t)>& wanted,
                           int around);

/// The side above the ground from which most of the robot and of the way of its hand is seen between the obstacles, and
/// the robot's first pose hides least of its last one.
SpaceView choose_view(const PoseStrip& strip);

/// The robot in space: obstacles and poses as shaded surfaces, the way of its hand with its hidden parts thin and
/// dashed, and axes.
Sketch workspace_sketch(const PoseStrip& strip, const SpaceView& view, const Look& look);
std::vector<LegendEntry> legend_of_workspace(const PoseStrip& strip, const Look& look);

/// Axes, and the room that their numbers and names need.
struct AxesInSpace {
  std::string svg;
  Eigen::AlignedBox2d room;  ///< px
};
/// The edges of a box that are outermost in the view, as axes with ticks and names.
AxesInSpace axes_in_space(const Eigen::AlignedBox3d& box, const SpaceView& view, const Projector& projector,
                          const Look& look);
/// Where these axes begin and end.
std::vector<Eigen::Vector3d> ends_of_axes(const Eigen::AlignedBox3d& box, const SpaceView& view);

}  // namespace leastcost::app
