// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/shapes/cone.hpp>

#include <leastcost/problems/shapes/cylinder.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"
#include "problems/shapes/posed_obstacle.hpp"
#include "problems/shapes/round_core.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A frustum; a cylinder and a cone are two of them. Through the z axis and a place there is a half plane (off the
/// axis, along it) in which it is a quadrilateral, and its nearest point.
class Frustum final : public RoundCore {
 public:
  Frustum(double radius, double top, double height)
      : radius_(radius), top_(top), half_(height / 2), length_(std::hypot(height, radius - top)) {}

  std::string name() const override { return "the frustum"; }
  Eigen::MatrixXd corners() const override {
    constexpr int kCorners = 48;
    Eigen::MatrixXd all(3, 2 * kCorners);
    for (int k = 0; k < kCorners; ++k) {
      const double at = 2 * std::numbers::pi * k / kCorners;
      all.col(2 * k) << radius_ * std::cos(at), radius_ * std::sin(at), -half_;
      all.col(2 * k + 1) << top_ * std::cos(at), top_ * std::sin(at), half_;
    }
    return all;
  }

  double reach(const Vector3d& direction) const override {
    const double off = direction.head<2>().norm(), up = direction[2] * half_;
    return std::max(radius_ * off - up, top_ * off + up);
  }

 private:
  double distance_of(const Vector3d& x, Vector3d& normal) const override {
    const double off = std::sqrt(x[0] * x[0] + x[1] * x[1]);
    const Vector2d outward = off > 0 ? Vector2d(x.head<2>() / off) : Vector2d::UnitX();
    Vector2d across;  // off the axis, along it
    const double distance = distance_in_half_plane(off, x[2], across);
    normal << across[0] * outward, across[1];
    return distance;
  }

  double distance_in_half_plane(double off, double z, Vector2d& across) const {
    const Vector2d side(2 * half_ / length_, (radius_ - top_) / length_);  // its normal
    const double from_top = z - half_, from_base = -half_ - z;
    const double from_side = side[0] * (off - radius_) + side[1] * (z + half_);
    if (std::max({from_top, from_base, from_side}) <= 0) {
      if (from_side >= from_top && from_side >= from_base) return across = side, from_side;
      if (from_top >= from_base) return across = Vector2d::UnitY(), from_top;
      return across = -Vector2d::UnitY(), from_base;
    }
    if (from_top > 0 && off <= top_) return across = Vector2d::UnitY(), from_top;
    if (from_base > 0 && off <= radius_) return across = -Vector2d::UnitY(), from_base;
    // From the edge of the base, 0, up the side to that of the top, length_.
    const double up = side[0] * (z + half_) - side[1] * (off - radius_);
    if (up > 0 && up < length_) return across = side, from_side;
    across = up <= 0 ? Vector2d(off - radius_, z + half_) : Vector2d(off - top_, z - half_);
    const double distance = across.norm();
    if (distance > 0)
      across /= distance;
    else
      across = side;
    return distance;
  }

  double radius_, top_, half_, length_;
};

double positive(const char* key, double value) {
  if (!(value > 0) || !std::isfinite(value)) throw OptionError(key, "must be a number greater than 0");
  return value;
}

std::shared_ptr<const Obstacle> placed(const Frustum& core, const ShapePose& options, const char* kind,
                                       const std::string& name) {
  const Eigen::Isometry3d pose = pose_of(options, 3);
  const std::string by_place = "the " + std::string(kind) + " at " + point_text(pose.translation());
  return std::make_shared<PosedObstacle>(
      std::make_shared<Frustum>(core), [&](const Vector3d& direction) { return core.reach(direction); }, pose,
      name.empty() ? by_place : name);
}

void visit_sizes(FieldVisitor& visit, double& radius, double& height, const char* of_radius) {
  visit.field("radius", radius,
              {.help = of_radius, .unit = "length", .minimum = 0, .exclusive_minimum = true, .required = true});
  visit.field("height", height,
              {.help = "Height, along the z axis of its frame; the origin is at half the height.",
               .unit = "length",
               .minimum = 0,
               .exclusive_minimum = true,
               .required = true});
}

}  // namespace

void CylinderOptions::fields(FieldVisitor& visit) {
  visit_sizes(visit, radius, height, "Radius.");
  visit_pose(visit, pose);
}

void ConeOptions::fields(FieldVisitor& visit) {
  visit_sizes(visit, radius, height, "Radius of the base, at the lower end.");
  visit.field("top_radius", top_radius, {.help = "Radius at the upper end; 0: a tip.", .unit = "length", .minimum = 0});
  visit_pose(visit, pose);
}

std::shared_ptr<const Obstacle> make_cylinder(const CylinderOptions& options, const std::string& name) {
  const double radius = positive("radius", options.radius), height = positive("height", options.height);
  return placed(Frustum(radius, radius, height), options.pose, "cylinder", name);
}

std::shared_ptr<const Obstacle> make_cone(const ConeOptions& options, const std::string& name) {
  const double radius = positive("radius", options.radius), height = positive("height", options.height);
  if (!(options.top_radius >= 0) || !std::isfinite(options.top_radius))
    throw OptionError("top_radius", "must be a number, at least 0");
  return placed(Frustum(radius, options.top_radius, height), options.pose, "cone", name);
}

}  // namespace leastcost
