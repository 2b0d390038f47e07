// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/robots/robot_strip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/robots/robot_pose.hpp"
#include "problems/robots/robot_workspace.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr int kPosesOfStrip = 8;
constexpr int kCorners = 48;                         ///< of a circle
constexpr std::size_t kMostDrawn = 500;              ///< obstacles
constexpr double kAzimuth = 0.6, kElevation = 0.45;  ///< rad: from where space is looked at

/// Onto the picture; a ball stays a circle.
Vector2d projected(const Eigen::Vector3d& x, int space) {
  if (space == 2) return x.head<2>();
  const double across = -std::sin(kAzimuth) * x[0] + std::cos(kAzimuth) * x[1];
  const double away = std::cos(kAzimuth) * x[0] + std::sin(kAzimuth) * x[1];
  return {across, std::cos(kElevation) * x[2] - std::sin(kElevation) * away};
}

/// The hull of discs of one radius around points, closed (Andrew's chains).
Points hull_of_discs(const std::vector<Vector2d>& centers, double radius) {
  std::vector<Vector2d> all;
  for (const Vector2d& center : centers) {
    const int corners = radius > 0 ? kCorners : 1;
    for (int k = 0; k < corners; ++k) {
      const double at = 2 * std::numbers::pi * k / kCorners;
      all.emplace_back(center + radius * Vector2d(std::cos(at), std::sin(at)));
    }
  }
  std::sort(all.begin(), all.end(),
            [](const Vector2d& a, const Vector2d& b) { return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]); });
  std::vector<Vector2d> hull;
  const auto left = [](const Vector2d& a, const Vector2d& b, const Vector2d& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
  };
  const auto walk = [&](auto from, auto to) {
    const std::size_t begin = hull.size();
    for (; from != to; ++from) {
      while (hull.size() >= begin + 2 && !left(hull[hull.size() - 2], hull.back(), *from)) hull.pop_back();
      hull.push_back(*from);
    }
    hull.pop_back();  // the other chain begins with it
  };
  if (all.size() > 2) {
    walk(all.begin(), all.end());
    walk(all.rbegin(), all.rend());
  } else {
    hull = all;
  }
  hull.push_back(hull.front());
  Points line(2, static_cast<Index>(hull.size()));
  for (std::size_t k = 0; k < hull.size(); ++k) line.col(static_cast<Index>(k)) = hull[k];
  return line;
}

Points outline_of(const Obstacle& obstacle, int space) {
  const Obstacle::Box core = obstacle.core_bounds();
  std::vector<Vector2d> corners;
  if (space == 2) {
    const Eigen::MatrixXd all = obstacle.corners();
    for (const auto corner : all.colwise()) corners.emplace_back(corner);
  } else if (const Eigen::MatrixXd all = obstacle.corners(); all.rows() == 3) {
    for (const auto corner : all.colwise()) corners.push_back(projected(Eigen::Vector3d(corner), space));
  } else {
    for (int k = 0; k < 8; ++k)
      corners.push_back(projected({(k & 1 ? core.max() : core.min())[0], (k & 2 ? core.max() : core.min())[1],
                                   (k & 4 ? core.max() : core.min())[2]},
                                  space));
  }
  return hull_of_discs(corners, obstacle.radius());
}

}  // namespace

PoseStrip robot_strip(const Robot& robot, const std::vector<std::shared_ptr<const Obstacle>>& obstacles,
                      const Points& configurations) {
  const int space = robot.kinematics->space();
  PoseStrip strip;
  for (std::size_t i = 0; i < std::min(kMostDrawn, obstacles.size()); ++i)
    if (std::isfinite(obstacles[i]->core_bounds().diagonal().norm()))  // a half-space is everywhere
      strip.obstacles.push_back(outline_of(*obstacles[i], space));
  RobotPose pose;
  for (int k = 0; k < kPosesOfStrip; ++k) {
    pose.place(robot, along_path(configurations, static_cast<double>(k) / (kPosesOfStrip - 1)));
    std::vector<Points>& parts = strip.poses.emplace_back();
    for (std::size_t i = 0; i < robot.capsules.size(); ++i)
      parts.push_back(hull_of_discs({projected(pose.axes[i].from, space), projected(pose.axes[i].to, space)},
                                    robot.capsules[i].radius));
  }
  strip.hand.resize(2, configurations.cols());
  strip.hand_in_space.resize(3, configurations.cols());
  for (Index i = 0; i < configurations.cols(); ++i) {
    pose.place_links(robot, configurations.col(i));
    const Eigen::Vector3d hand = pose.links.back().origin;
    strip.hand.col(i) = projected(hand, space);
    strip.hand_in_space.col(i) = hand;
  }
  if (space == 3) strip.workspace = robot_workspace(robot, obstacles, configurations);
  return strip;
}

}  // namespace leastcost
