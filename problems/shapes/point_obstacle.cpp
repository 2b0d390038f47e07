// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/shapes/point_obstacle.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/mesh/median_tree.hpp>
#include <leastcost/problems/readers/point_cloud_reader.hpp>
#include "problems/obstacles/triangle_foot.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr std::ptrdiff_t kPointsOfLeaf = 8;
constexpr double kBallOutwards = 1 + 1e-12;

struct Cluster {
  Vector3d centre = Vector3d::Zero();
  double radius = 0;  ///< of a ball that holds its points
};

Cluster ball_around(std::span<const Vector3d> points) {
  Vector3d low = points[0], high = low;
  for (const Vector3d& p : points) low = low.cwiseMin(p).eval(), high = high.cwiseMax(p).eval();
  Cluster ball{(low + high) / 2};
  for (const Vector3d& p : points) ball.radius = std::max(ball.radius, (p - ball.centre).norm() * kBallOutwards);
  return ball;
}

class PointObstacle final : public Obstacle, public MeetsTriangles {
 public:
  PointObstacle(std::vector<Vector3d> points, double radius, std::string name)
      : name_(std::move(name)),
        radius_(radius),
        box_(3),
        tree_(
            std::move(points), kPointsOfLeaf, [](const Vector3d& p) { return std::array{p}; }, ball_around) {
    for (const Vector3d& p : tree_.items()) box_.extend(Vector(p));
  }

  std::string name() const override { return name_; }
  Box core_bounds() const override { return box_; }
  double radius() const override { return radius_; }
  bool convex() const override { return tree_.items().size() == 1; }
  Eigen::MatrixXd corners() const override { return {}; }

  double distance(const Vector& x, Eigen::Ref<Vector> away) const override {
    const Vector3d place = x;
    const Vector3d point = nearest([&](const Vector3d&) -> const Vector3d& { return place; });
    away = place - point;
    const double distance = away.norm();
    if (distance > 0)
      away /= distance;
    else
      away = Vector3d::UnitX();  // on it: any way out is as short
    return distance;
  }

  double distance_of_segment(const Vector& a, const Vector& b, double& t) const override {
    const Vector3d from = a, way = b - a;
    const double square = way.squaredNorm();
    const auto share = [&](const Vector3d& p) {
      return square > 0 ? std::clamp((p - from).dot(way) / square, 0.0, 1.0) : 0;
    };
    const Vector3d point = nearest([&](const Vector3d& p) -> Vector3d { return from + share(p) * way; });
    t = share(point);
    return (from + t * way - point).norm();
  }

  double distance_of_triangle(const std::array<Vector3d, 3>& corners, Vector3d& nearest) const override {
    const auto foot = [&](const Vector3d& p) { return foot_on_triangle(corners, p); };
    const Vector3d point = this->nearest(foot);
    nearest = foot(point);
    return (nearest - point).norm();
  }

 private:
  /// Of the cloud, to something that tells its nearest place to a point.
  template <class Foot>
  Vector3d nearest(const Foot& foot) const {
    double least = std::numeric_limits<double>::infinity();
    Vector3d found = tree_.items()[0];
    tree_.visit_nearest(
        [&](const Cluster& ball) {
          return std::max(0.0, (foot(ball.centre) - ball.centre).norm() / kBallOutwards - ball.radius);
        },
        [&](const Vector3d& p) {
          const double distance = (foot(p) - p).norm();
          if (distance < least) least = distance, found = p;
        },
        [&] { return least; });
    return found;
  }

  std::string name_;
  double radius_;
  Box box_;
  MedianTree<Vector3d, Cluster> tree_;
};

}  // namespace

void PointObstacleOptions::fields(FieldVisitor& visit) {
  visit.file("file", file, {.help = "Point cloud file: PLY, XYZ, TXT, CSV or ASC.", .required = true});
  visit.field("radius", radius,
              {.help = "Radius of a ball around each point.",
               .unit = "length",
               .minimum = 0,
               .exclusive_minimum = true,
               .required = true});
  visit_pose(visit, pose);
}

std::shared_ptr<const Obstacle> make_point_obstacle(std::vector<Vector3d> points, double radius,
                                                    const std::string& name) {
  if (!(radius > 0) || !std::isfinite(radius)) throw OptionError("radius", "must be a number greater than 0");
  return std::make_shared<PointObstacle>(std::move(points), radius, name);
}

std::shared_ptr<const Obstacle> make_point_obstacle(const PointObstacleOptions& options,
                                                    const std::filesystem::path& folder) {
  const Eigen::Isometry3d pose = pose_of(options.pose, 3);
  std::vector<Vector3d> points = read_point_cloud(folder / options.file).positions;
  for (Vector3d& p : points) p = pose * p;
  const std::string name = "the points of " + std::filesystem::path(options.file).filename().string();
  return make_point_obstacle(std::move(points), options.radius, name);
}

}  // namespace leastcost
