// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/shapes/box.hpp>

#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include "framework/base/point_text.hpp"
#include "problems/shapes/in_space.hpp"
#include "problems/shapes/posed_obstacle.hpp"

namespace leastcost {
namespace {

/// In the frame of the box.
BoxObstacleOptions corners_of(const BoxShapeOptions& options) {
  const bool no_corners = options.lower.size() == 0 && options.upper.size() == 0;
  if (options.size.size() == 0 && no_corners)
    throw OptionError("lower", "is missing: a box has lower and upper, its corners, or size, its edges");
  if (options.size.size() == 0) return {options.lower, options.upper};
  if (!no_corners) throw OptionError("size", "goes without lower and upper: a box has either");
  if (!options.size.allFinite() || !(options.size.array() >= 0).all())
    throw OptionError("size", "must be finite numbers, at least 0");
  return {-options.size / 2, options.size / 2};
}

bool is_given(const ShapePose& pose) {
  return pose.position.size() > 0 || pose.rpy.size() > 0 || pose.quaternion.size() > 0 || pose.rotation.size() > 0 ||
         pose.angle;
}

}  // namespace

void BoxShapeOptions::fields(FieldVisitor& visit) {
  visit.field("lower", lower, {.help = "Corner with the smallest coordinates; requires upper.", .unit = "length"});
  visit.field("upper", upper, {.help = "Corner with the largest coordinates; requires lower.", .unit = "length"});
  visit.field("size", size,
              {.help = "Edge lengths of a box centred on the origin of its frame; replaces lower and upper.",
               .unit = "length"});
  visit_pose(visit, pose);
}

/// One that is only moved needs no frame of its own.
std::shared_ptr<const Obstacle> make_box(const BoxShapeOptions& options, const std::string& name) {
  BoxObstacleOptions corners = corners_of(options);
  const BoxLook look{.name = name.empty() ? "the box" : name, .with_place = name.empty()};
  if (!is_given(options.pose)) return make_box_obstacle(corners, look);
  const Eigen::Index d = corners.lower.size();
  if (d != 2 && d != 3) throw OptionError("pose", "is for boxes in the plane and in space");
  const Eigen::Isometry3d pose = pose_of(options.pose, d);
  std::shared_ptr<const Obstacle> own = make_box_obstacle(corners, look);  // what does not fit is refused
  if (pose.linear().isIdentity(0)) {
    corners.lower += pose.translation().head(d);
    corners.upper += pose.translation().head(d);
    return make_box_obstacle(corners, look);
  }
  const Eigen::Vector3d lower = in_space(corners.lower), upper = in_space(corners.upper);
  const std::string by_place = "the box of size " + point_text(corners.upper - corners.lower) + " at " +
                               point_text((pose * Eigen::Vector3d((lower + upper) / 2)).head(d));
  const auto support = [&](const Eigen::Vector3d& direction) {
    return lower.cwiseProduct(direction).cwiseMax(upper.cwiseProduct(direction)).sum();
  };
  return std::make_shared<PosedObstacle>(std::move(own), support, pose, name.empty() ? by_place : name);
}

}  // namespace leastcost
