// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/shapes/capsule_obstacle.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"
#include "problems/obstacles/segment_tree.hpp"
#include "problems/shapes/in_space.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

class CapsuleObstacle final : public Obstacle, public MeetsTriangles, public HasCoreBox {
 public:
  CapsuleObstacle(const CapsuleObstacleOptions& options, std::string name)
      : name_(std::move(name)),
        from_(options.from),
        to_(options.to),
        radius_(options.radius),
        axis_({{in_space(from_), in_space(to_), in_space(to_)}}) {}

  std::string name() const override { return name_; }
  Box core_bounds() const override { return {from_.cwiseMin(to_), from_.cwiseMax(to_)}; }
  double radius() const override { return radius_; }
  bool convex() const override { return true; }
  Eigen::MatrixXd corners() const override {
    if (from_ == to_) return from_;
    Eigen::MatrixXd ends(from_.size(), 2);
    ends << from_, to_;
    return ends;
  }

  double distance(const Vector& x, Eigen::Ref<Vector> away) const override {
    const double square = (to_ - from_).squaredNorm();
    const double t = square > 0 ? std::clamp((x - from_).dot(to_ - from_) / square, 0.0, 1.0) : 0;
    away = x - from_ - t * (to_ - from_);
    const double distance = away.norm();
    if (distance > 0)
      away /= distance;
    else
      away = across();  // on the axis: any way at a right angle to it is as short
    return distance;
  }

  double distance_of_segment(const Vector& a, const Vector& b, double& t) const override {
    return axis_.distance(in_space(a), in_space(b), t);
  }

  double distance_of_triangle(const std::array<Vector3d, 3>& corners, Vector3d& nearest) const override {
    return axis_.distance(corners, nearest);
  }

  OrientedBox core_box() const override {
    const Vector3d from = in_space(from_), to = in_space(to_);
    OrientedBox box{.center = (from + to) / 2};
    box.axes = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitX(), to - from).toRotationMatrix();
    box.half[0] = (to - from).norm() / 2;
    return box;
  }

 private:
  bool measures_triangles() const override { return from_.size() == 3; }

  Vector across() const {
    const Vector3d way = in_space(to_ - from_);
    Vector3d out = from_.size() == 2 ? Vector3d(-way[1], way[0], 0) : Vector3d(way.unitOrthogonal());
    if (!(out.norm() > 0)) out = Vector3d::UnitX();
    return out.normalized().head(from_.size());
  }

  std::string name_;
  Vector from_, to_;
  double radius_;
  SegmentTree axis_;
};

}  // namespace

void CapsuleObstacleOptions::fields(FieldVisitor& visit) {
  visit.field("from", from, {.help = "One end of its axis.", .unit = "length", .required = true});
  visit.field("to", to, {.help = "The other end.", .unit = "length", .required = true});
  visit.field("radius", radius,
              {.help = "Distance of its surface from the axis.",
               .unit = "length",
               .minimum = 0,
               .exclusive_minimum = true,
               .required = true});
}

std::shared_ptr<const Obstacle> make_capsule(const CapsuleObstacleOptions& options, const std::string& name) {
  const Eigen::Index d = options.from.size();
  if ((d != 2 && d != 3) || !options.from.allFinite())
    throw OptionError("from", "must be a point of the plane or of space, with finite coordinates");
  if (options.to.size() != d || !options.to.allFinite())
    throw OptionError("to", "must have as many coordinates as from (" + std::to_string(d) + "), all of them finite");
  if (!(options.radius > 0) || !std::isfinite(options.radius))
    throw OptionError("radius", "must be a number greater than 0");
  const std::string by_place = "the capsule from " + point_text(options.from) + " to " + point_text(options.to);
  return std::make_shared<CapsuleObstacle>(options, name.empty() ? by_place : name);
}

}  // namespace leastcost
