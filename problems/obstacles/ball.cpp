// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/ball.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"
#include "problems/obstacles/triangle_foot.hpp"

namespace leastcost {
namespace {

class Ball final : public Obstacle, public MeetsTriangles, public HasCoreBox {
 public:
  Ball(const BallOptions& options, std::string name)
      : name_(std::move(name)), center_(options.center), radius_(options.radius) {}

  std::string name() const override { return name_; }
  Box core_bounds() const override { return {center_, center_}; }
  double radius() const override { return radius_; }
  bool convex() const override { return true; }
  Eigen::MatrixXd corners() const override { return center_; }

  double distance(const Vector& x, Eigen::Ref<Vector> away) const override {
    away = x - center_;
    const double distance = away.norm();
    if (distance > 0)
      away /= distance;
    else
      away = Vector::Unit(x.size(), 0);  // the centre: any way out is as short
    return distance;
  }

  double distance_of_segment(const Vector& a, const Vector& b, double& t) const override {
    const double square = (b - a).squaredNorm();
    t = square > 0 ? std::clamp((center_ - a).dot(b - a) / square, 0.0, 1.0) : 0;
    return (a + t * (b - a) - center_).norm();
  }

  double distance_of_triangle(const std::array<Eigen::Vector3d, 3>& corners, Eigen::Vector3d& nearest) const override {
    nearest = foot_on_triangle(corners, Eigen::Vector3d(center_));
    return (nearest - Eigen::Vector3d(center_)).norm();
  }

  OrientedBox core_box() const override {
    OrientedBox box;
    box.center.head(center_.size()) = center_;
    return box;
  }

 private:
  bool has_core_box() const override { return center_.size() <= 3; }
  bool measures_triangles() const override { return center_.size() == 3; }

  std::string name_;
  Vector center_;
  double radius_;
};

}  // namespace

void BallOptions::fields(FieldVisitor& visit) {
  visit.field("center", center, {.help = "Coordinates of the centre.", .unit = "length", .required = true});
  visit.field("radius", radius,
              {.help = "Radius.", .unit = "length", .minimum = 0, .exclusive_minimum = true, .required = true});
}

std::shared_ptr<const Obstacle> make_ball(const BallOptions& options, const std::string& name) {
  if (options.center.size() == 0 || !options.center.allFinite())
    throw OptionError("center", "must be a point, with finite coordinates");
  if (!(options.radius > 0) || !std::isfinite(options.radius))
    throw OptionError("radius", "must be a number greater than 0");
  return std::make_shared<Ball>(options, name.empty() ? "the ball at " + point_text(options.center) : name);
}

}  // namespace leastcost
