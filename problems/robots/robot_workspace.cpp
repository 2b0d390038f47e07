// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/robots/robot_workspace.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <leastcost/framework/base/ability.hpp>
#include "problems/drawing/draws_surface.hpp"
#include "problems/drawing/solids.hpp"
#include "problems/drawing/thinned.hpp"
#include "problems/robots/robot_pose.hpp"

namespace leastcost {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr int kPoses = 49;  ///< every quarter, sixth, eighth of the path is one
constexpr double kNear = 0.5;
constexpr std::size_t kMostObstacles = 500;     ///< obstacles
constexpr std::size_t kMostTriangles = 40'000;  ///< of all obstacles
constexpr std::size_t kManyBalls = 50;          ///< that need not be so smooth

Vector3d in_space(const Obstacle::Vector& x) { return x.head<3>(); }

/// The points of a hull with a thickness, as the hull of points around each.
std::vector<Vector3d> thick(const Eigen::MatrixXd& corners, double radius, int around) {
  std::vector<Vector3d> points;
  for (const auto corner : corners.colwise()) {
    if (radius > 0)
      for (const Vector3d& x : capsule_surface(Vector3d(corner), Vector3d(corner), radius, around).vertices)
        points.push_back(x);
    else
      points.emplace_back(corner);
  }
  return points;
}

/// `exact`: whether it looks like the obstacle, not like the box around it.
TriangleSoup surface_of(const Obstacle& obstacle, int around, bool& exact) {
  exact = true;
  if (const auto* known = find_ability<DrawsSurface>(obstacle)) return known->surface();
  const Eigen::MatrixXd corners = obstacle.corners();
  const double radius = obstacle.radius();
  if (corners.rows() == 3 && corners.cols() > 0 && corners.cols() <= 2 && radius > 0)
    return capsule_surface(corners.col(0), corners.col(corners.cols() - 1), radius, around);
  if (corners.rows() == 3 && corners.cols() > 0) return hull_surface(thick(corners, radius, around / 2));
  exact = false;
  const Obstacle::Box core = obstacle.core_bounds();
  std::vector<Vector3d> box;
  for (unsigned k = 0; k < 8; ++k)
    box.emplace_back(((k & 1U) != 0 ? core.max()[0] + radius : core.min()[0] - radius),
                     ((k & 2U) != 0 ? core.max()[1] + radius : core.min()[1] - radius),
                     ((k & 4U) != 0 ? core.max()[2] + radius : core.min()[2] - radius));
  return hull_surface(std::move(box));
}

bool is_half_space(const Obstacle& obstacle) { return !std::isfinite(obstacle.core_bounds().diagonal().norm()); }

/// What the robot fills on its way.
AlignedBox3d swept(const Robot& robot, const Points& configurations) {
  AlignedBox3d box;
  RobotPose pose;
  for (int k = 0; k < kPoses; ++k) {
    pose.place(robot, along_path(configurations, static_cast<double>(k) / (kPoses - 1)));
    const auto grow = [&](const Vector3d& x, double radius) {
      box.extend(Vector3d(x.array() - radius));
      box.extend(Vector3d(x.array() + radius));
    };
    for (std::size_t i = 0; i < pose.axes.size(); ++i) {
      grow(pose.axes[i].from, robot.capsules[i].radius);
      grow(pose.axes[i].to, robot.capsules[i].radius);
    }
    for (std::size_t i = 0; i < pose.plates.size(); ++i)
      for (const Vector3d& corner : pose.plates[i]) grow(corner, robot.plates[i].radius);
  }
  return box;
}

void add_obstacles(const std::vector<std::shared_ptr<const Obstacle>>& obstacles, const AlignedBox3d& robot,
                   Workspace& out) {
  const double near = kNear * robot.diagonal().norm();
  const AlignedBox3d reach(robot.min().array() - near, robot.max().array() + near);
  AlignedBox3d shown = robot;
  std::vector<const Obstacle*> finite;
  std::size_t left_out = 0;
  Obstacle::Vector away(3);
  const auto foot = [&](const Obstacle& half_space) -> Vector3d {
    const double height = half_space.distance(shown.center(), away);
    return shown.center() - height * in_space(away);
  };
  for (const auto& obstacle : obstacles) {
    if (is_half_space(*obstacle)) {
      const Vector3d at = foot(*obstacle);
      if (reach.contains(at)) shown.extend(at);
      continue;
    }
    const Obstacle::Box core = obstacle->core_bounds();
    const AlignedBox3d box(in_space(core.min()).array() - obstacle->radius(),
                           in_space(core.max()).array() + obstacle->radius());
    if (!reach.intersects(box) || finite.size() >= kMostObstacles) {
      ++left_out;
      continue;
    }
    shown.extend(reach.intersection(box));
    finite.push_back(obstacle.get());
  }
  constexpr int kSmooth = 32, kCoarse = 12;
  for (const Obstacle* obstacle : finite) {
    bool exact = true;
    append(out.obstacles, surface_of(*obstacle, finite.size() > kManyBalls ? kCoarse : kSmooth, exact));
    if (!exact) out.notes.push_back(obstacle->name() + " is drawn as the box around it");
  }
  out.obstacles = thinned(std::move(out.obstacles), Points(3, 0), kMostTriangles);
  if (left_out > 0) out.notes.push_back("obstacles that are far off are not drawn: " + std::to_string(left_out));
  constexpr double kRim = 0.03, kRounding = 1e-9;
  const double size = shown.diagonal().norm();
  const Vector3d rim(kRim * size, kRim * size, 0);
  shown = AlignedBox3d(shown.min() - rim, shown.max() + rim);
  const AlignedBox3d around(shown.min().array() - kRounding * size, shown.max().array() + kRounding * size);
  for (const auto& obstacle : obstacles) {
    if (!is_half_space(*obstacle)) continue;
    const Vector3d at = foot(*obstacle), normal = in_space(away);
    append(out.ground, plane_in_box(normal, normal.dot(at), around));
  }
  out.lower = shown.min();
  out.upper = shown.max();
}

}  // namespace

Eigen::VectorXd along_path(const Points& configurations, double part) {
  const Points& path = configurations;
  Eigen::VectorXd lengths = Eigen::VectorXd::Zero(path.cols());
  for (Index i = 1; i < path.cols(); ++i) lengths[i] = lengths[i - 1] + (path.col(i) - path.col(i - 1)).norm();
  const double wanted = part * lengths[lengths.size() - 1];
  for (Index i = 1; i < path.cols(); ++i) {
    const double length = lengths[i] - lengths[i - 1];
    if (lengths[i] >= wanted && length > 0)
      return path.col(i - 1) +
             std::clamp((wanted - lengths[i - 1]) / length, 0.0, 1.0) * (path.col(i) - path.col(i - 1));
  }
  return path.col(path.cols() - 1);
}

Workspace robot_workspace(const Robot& robot, const std::vector<std::shared_ptr<const Obstacle>>& obstacles,
                          const Points& configurations) {
  Workspace out;
  out.unit = robot.unit;
  std::map<int, std::size_t> number;  // of the links that have parts
  for (std::size_t part = 0; part < robot.parts(); ++part) number.emplace(robot.link(part), 0);
  std::size_t next = 0;
  for (auto& [link, drawn] : number) drawn = next++;
  for (const Capsule& capsule : robot.capsules)
    out.capsules.push_back({number.at(capsule.link), capsule.from, capsule.to, capsule.radius});
  for (const Plate& plate : robot.plates) out.plates.push_back({number.at(plate.link), plate.corners});
  std::vector<Frame> links;
  for (int k = 0; k < kPoses; ++k) {
    robot.kinematics->place(along_path(configurations, static_cast<double>(k) / (kPoses - 1)), links);
    std::vector<DrawnFrame>& frames = out.poses.emplace_back();
    for (const auto& [link, drawn] : number) {
      const Frame& frame = links[static_cast<std::size_t>(link)];
      frames.push_back({Eigen::Quaterniond(frame.rotation), frame.origin});
    }
  }
  add_obstacles(obstacles, swept(robot, configurations), out);
  return out;
}

}  // namespace leastcost
