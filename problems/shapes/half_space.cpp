// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/shapes/half_space.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

class HalfSpace final : public Obstacle, public MeetsTriangles {
 public:
  HalfSpace(Vector normal, double offset, std::string name)
      : name_(std::move(name)), normal_(std::move(normal)), offset_(offset) {}

  std::string name() const override { return name_; }
  Box core_bounds() const override {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {Vector::Constant(normal_.size(), -kInfinity), Vector::Constant(normal_.size(), kInfinity)};
  }
  double radius() const override { return 0; }
  bool convex() const override { return true; }
  Eigen::MatrixXd corners() const override { return {}; }

  double distance(const Vector& x, Eigen::Ref<Vector> away) const override {
    away = normal_;
    return height(x);
  }

  double distance_of_segment(const Vector& a, const Vector& b, double& t) const override {
    const double from = height(a), to = height(b);
    t = from <= to || from <= 0 ? 0 : to > 0 ? 1 : from / (from - to);
    return std::max(0.0, std::min(from, to));
  }

  double distance_of_triangle(const std::array<Eigen::Vector3d, 3>& corners, Eigen::Vector3d& nearest) const override {
    const auto lower = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return height(a) < height(b); };
    nearest = *std::min_element(corners.begin(), corners.end(), lower);
    return std::max(0.0, height(nearest));
  }

 private:
  bool measures_triangles() const override { return normal_.size() == 3; }
  template <class Place>
  double height(const Place& x) const {
    return normal_.dot(x) - offset_;
  }

  std::string name_;
  Vector normal_;
  double offset_;
};

}  // namespace

void HalfSpaceOptions::fields(FieldVisitor& visit) {
  visit.field("normal", normal, {.help = "Direction out of the obstacle, of any length.", .required = true});
  visit.field("offset", offset, {.help = "Distance of its plane from the origin, along the normal.", .unit = "length"});
}

std::shared_ptr<const Obstacle> make_half_space(const HalfSpaceOptions& options, const std::string& name) {
  const double length = options.normal.size() > 0 ? options.normal.stableNorm() : 0;
  if (!(length > 0) || !std::isfinite(length))
    throw OptionError("normal", "must be a direction: finite numbers that are not all 0");
  if (!std::isfinite(options.offset)) throw OptionError("offset", "must be a finite number");
  const Eigen::VectorXd normal = options.normal / length;
  const std::string by_normal = "the half-space with the normal " + point_text(normal);
  return std::make_shared<HalfSpace>(normal, options.offset, name.empty() ? by_normal : name);
}

}  // namespace leastcost
