// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/obstacle_walls.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/counted.hpp"
#include "framework/base/point_text.hpp"
#include "problems/obstacles/broad_phase.hpp"
#include "problems/obstacles/outlines.hpp"

namespace leastcost {
namespace {

using Vector = Walls::Vector;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kOfCoordinates = 16 * std::numeric_limits<double>::epsilon();

Obstacle::Box around(const Vector& x, const Vector& y, double margin) {
  return {x.cwiseMin(y).array() - margin, x.cwiseMax(y).array() + margin};
}

/// The first fault of obstacles that do not fit.
void check(Eigen::Index dimension, const ObstacleWalls::Obstacles& obstacles, double clearance) {
  if (!(clearance >= 0) || !std::isfinite(clearance)) throw OptionError("clearance", "must be a number, at least 0");
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const Obstacle& obstacle = *obstacles[i];
    if (obstacle.core_bounds().dim() != dimension)
      throw OptionError(std::to_string(i), obstacle.name() + " has " +
                                               counted(obstacle.core_bounds().dim(), "dimension") +
                                               ", but the domain has " + std::to_string(dimension));
    if (!(obstacle.radius() + clearance > 0))
      throw OptionError("clearance", "must be greater than 0 with sharp corners (" + obstacle.name() +
                                         "): the path bends there only between its points");
  }
}

}  // namespace

ObstacleWalls::ObstacleWalls(Eigen::Index dimension, Obstacles obstacles, double clearance)
    : dimension_(dimension), obstacles_(std::move(obstacles)), clearance_(clearance), least_required_(kInfinity) {
  check(dimension_, obstacles_, clearance_);
  std::vector<Obstacle::Box> boxes;
  boxes.reserve(obstacles_.size());
  for (const auto& obstacle : obstacles_) {
    const Obstacle::Box core = obstacle->core_bounds();
    const double r = obstacle->radius() + clearance_;
    boxes.push_back(around(core.min(), core.max(), r));
    least_required_ = std::min(least_required_, r);
    size_ = std::max(size_, r);
    if (!core.min().allFinite() || !core.max().allFinite()) {
      Vector away(dimension_);
      size_ = std::max(size_, std::abs(obstacle->distance(Vector::Zero(dimension_), away)));
      bounded_ = false;
      continue;
    }
    size_ = std::max({size_, core.min().cwiseAbs().maxCoeff(), core.max().cwiseAbs().maxCoeff()});
  }
  tree_ = std::make_unique<const BroadPhase>(std::move(boxes));
}

ObstacleWalls::~ObstacleWalls() = default;

void ObstacleWalls::near(const Vector& x, double reach, std::vector<Wall>& found) const {
  std::vector<int> numbers;
  tree_->meeting(around(x, x, std::max(0.0, reach)), numbers);
  found.clear();
  found.reserve(numbers.size());
  for (const int i : numbers) {
    Wall wall{i, 0, Vector(x.size()), required(i)};
    wall.gap = obstacle(i).distance(x, wall.slope) - required(i);
    if (wall.gap < reach) found.push_back(std::move(wall));
  }
}

void ObstacleWalls::along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const {
  std::vector<int> numbers;
  tree_->meeting(around(a, b, std::max(0.0, reach)), numbers);
  found.clear();
  for (const int i : numbers) {
    double t = 0;
    const double gap = obstacle(i).distance_of_segment(a, b, t) - required(i);
    if (!(gap < reach)) continue;
    found.push_back({i, gap, Vector(a.size()), required(i), t});
    obstacle(i).distance(a + t * (b - a), found.back().slope);
  }
}

double ObstacleWalls::room(const Vector& a, const Vector& b, double reach) const {
  std::vector<int> numbers;
  tree_->meeting(around(a, b, reach), numbers);
  double room = reach;
  for (const int i : numbers) {
    double t = 0;
    room = std::min(room, obstacle(i).distance_of_segment(a, b, t));
  }
  return room;
}

/// How deep a move that meets a core goes into it, at most: as deep as that is wide; into a half-space, as deep as the
/// deeper of its ends.
double ObstacleWalls::depth(int i, const Vector& a, const Vector& b) const {
  const double width = obstacle(i).core_bounds().diagonal().norm();
  if (std::isfinite(width)) return width;
  Vector away(a.size());
  return std::max(-obstacle(i).distance(a, away), -obstacle(i).distance(b, away));
}

MoveClearance ObstacleWalls::clearance(const Vector& a, const Vector& b) const {
  MoveClearance least;
  least.lower = least.upper = kInfinity;
  const double size = std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()});
  std::vector<int> found;
  // What is asked for is how near it is, also where nothing is near: ever wider boxes until something is found.
  double margin = (b - a).norm() + least_required_;
  for (; found.empty() && std::isfinite(margin); margin *= 4) tree_->meeting(around(a, b, margin), found);
  // The nearest by their boxes need not be the nearest: all that may be as near as the best of these.
  if (!found.empty()) {
    double best = kInfinity, t = 0;
    for (const int i : found) best = std::min(best, obstacle(i).distance_of_segment(a, b, t) - required(i));
    tree_->meeting(around(a, b, std::max(0.0, best) + kOfCoordinates * size), found);
  }
  for (const int i : found) {
    double t = 0;
    const double from_core = obstacle(i).distance_of_segment(a, b, t);
    // A place knows how deep it lies. Through a core a move goes as deep as that is wide, at most: where little is
    // required that is no rounding.
    if (from_core <= 0 && a == b) {
      Vector away(a.size());
      const double depth = std::max(-this->depth(i, a, b), obstacle(i).distance(a, away)) - required(i);
      if (depth < least.upper) least = {depth - kOfCoordinates * (size + required(i)), depth, i, a};
      continue;
    }
    const double distance = (from_core > 0 ? from_core : -depth(i, a, b)) - required(i);
    if (distance >= least.upper) continue;
    least = {distance - kOfCoordinates * (size + required(i)), distance, i, a + t * (b - a)};
  }
  return least;
}

std::vector<Round> ObstacleWalls::rounds(const Eigen::AlignedBox2d& box) const {
  std::vector<int> numbers;
  tree_->meeting({box.min(), box.max()}, numbers);
  std::vector<Round> found;
  for (const int i : numbers) {
    const Eigen::MatrixXd corners = obstacle(i).corners();
    for (Eigen::Index k = 0; k < corners.cols(); ++k) found.push_back({i, corners.col(k), required(i)});
  }
  return found;
}

/// Across the shortest way from the core to the move, which are both convex.
bool ObstacleWalls::planes(const Vector& a, const Vector& b, double reach, std::vector<SupportPlane>& found) const {
  std::vector<int> numbers;
  tree_->meeting(around(a, b, std::max(0.0, reach)), numbers);
  found.clear();
  for (const int i : numbers) {
    double t = 0;
    const double gap = obstacle(i).distance_of_segment(a, b, t) - required(i);
    if (gap >= reach) continue;
    if (!obstacle(i).convex()) return false;
    SupportPlane plane{i, Vector(a.size()), 0, gap, a + t * (b - a)};
    const double distance = obstacle(i).distance(plane.place, plane.normal);
    plane.offset = plane.normal.dot(plane.place) - distance + required(i);
    found.push_back(std::move(plane));
  }
  return true;
}

std::string ObstacleWalls::obstacle_name(int i) const {
  return i < 0 ? "" : obstacle(i).name() + " (number " + std::to_string(i) + ")";
}

std::string ObstacleWalls::depth_text(int i, double missing) const {
  constexpr double kRounding = 1e-9;  // sizes
  const double deep = missing - clearance_;
  if (i < 0 || !(deep > kRounding * size_) || !std::isfinite(deep)) return "";
  return "lies " + short_number(deep) + " deep inside " + obstacle_name(i);
}

void ObstacleWalls::draw(const DrawnPaths&, Drawing& out) const { draw_outlines(obstacles_, clearance_, out); }

}  // namespace leastcost
