// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/robot_walls.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <leastcost/framework/base/ability.hpp>
#include <leastcost/framework/base/errors.hpp>
#include "framework/base/counted.hpp"
#include "framework/base/point_text.hpp"
#include "problems/obstacles/broad_phase.hpp"
#include "problems/robots/box_distance.hpp"
#include "problems/robots/move_sieve.hpp"
#include "problems/robots/remembering_walls.hpp"
#include "problems/robots/robot_pose.hpp"
#include "problems/robots/robot_strip.hpp"
#include "problems/robots/robot_walls_parts.hpp"

namespace leastcost {
using robot_walls::farther_apart, robot_walls::kOfLengths, robot_walls::kOfScene, robot_walls::kUnbounded;
namespace {

using Eigen::Vector3d;

constexpr std::size_t kManyObstacles = 64;  ///< from here on a tree of them is quicker

/// The place as an obstacle of the plane or of space takes it.
void to_space(const Vector3d& x, Eigen::VectorXd& out) {
  for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = x[i];
}

/// Of any of the corners.
template <class Corners>
Eigen::VectorXd reach_of(const Kinematics& kinematics, int seen_from, int link, const Corners& corners) {
  Eigen::VectorXd reach = kinematics.reach_from(seen_from, link, corners[0]);
  for (const Vector3d& corner : corners) reach = reach.cwiseMax(kinematics.reach_from(seen_from, link, corner)).eval();
  return reach;
}

/// Of the core of an obstacle: how near it comes to the origin, and its largest coordinate; of a half-space the
/// distance of its side.
struct Extent {
  double nearest = 0, largest = 0;
};

Extent extent_of_core(const Obstacle& obstacle) {
  const Obstacle::Box core = obstacle.core_bounds();
  const Eigen::VectorXd origin = Eigen::VectorXd::Zero(core.dim());
  if (core.min().allFinite() && core.max().allFinite())
    return {std::sqrt(core.squaredExteriorDistance(origin)),
            std::max(core.min().cwiseAbs().maxCoeff(), core.max().cwiseAbs().maxCoeff())};
  Eigen::VectorXd away(core.dim());
  const double distance = obstacle.distance(origin, away);
  return {std::max(0.0, distance), std::abs(distance)};
}

}  // namespace

RobotWalls::RobotWalls(std::shared_ptr<const Robot> robot, Obstacles obstacles, double clearance)
    : robot_(std::move(robot)), clearance_(clearance) {
  if (!(clearance >= 0) || !std::isfinite(clearance)) throw OptionError("clearance", "must be a number, at least 0");
  const Kinematics& kinematics = *robot_->kinematics;
  const auto add_body = [&](int link, double radius, const auto& corners) {
    Body body;
    body.reach = reach_of(kinematics, 0, link, corners);
    body.radius = radius;
    body.steepest = kinematics.steepest(body.reach, 0);
    farthest_ = std::max(farthest_, body.reach.maxCoeff());
    size_ = std::max(size_, farthest_ + radius);
    bodies_.push_back(std::move(body));
  };
  for (const Capsule& capsule : robot_->capsules)
    add_body(capsule.link, capsule.radius, std::array{capsule.from, capsule.to});
  for (std::size_t i = 0; i < robot_->capsules.size(); ++i)
    bodies_[i].ball = robot_->capsules[i].from == robot_->capsules[i].to;
  for (const Plate& plate : robot_->plates) add_body(plate.link, plate.radius, plate.corners);
  add_obstacles(std::move(obstacles), clearance);
  add_self_pairs();
  thinnest_ = find_thinnest();
  if (robot_->plates.empty()) sieve_ = std::make_shared<const MoveSieve>(robot_, obstacles_, required_);
}

void RobotWalls::add_obstacles(Obstacles obstacles, double clearance) {
  obstacles_ = std::move(obstacles);
  const int space = robot_->kinematics->space();
  const double farthest_place = this->farthest_place();
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    const Obstacle::Box core = obstacles_[i]->core_bounds();
    if (core.dim() != space)
      throw OptionError(std::to_string(i), obstacles_[i]->name() + " has " + counted(core.dim(), "dimension") +
                                               ", but the workspace of the robot has " + std::to_string(space));
    if (!robot_->plates.empty()) {
      for_plates_.push_back(find_ability<MeetsTriangles>(*obstacles_[i]));
      if (for_plates_.back() == nullptr)
        throw OptionError(std::to_string(i),
                          obstacles_[i]->name() + " has no distance to triangles, which the robot has");
    }
    CoreBox box{Vector3d::Zero(), Vector3d::Zero()};
    box.lower.head(space) = core.min();
    box.upper.head(space) = core.max();
    boxes_.push_back(box);
    const auto* has = find_ability<HasCoreBox>(*obstacles_[i]);
    cores_.push_back(has != nullptr ? std::optional(has->core_box()) : std::nullopt);
    required_.push_back(obstacles_[i]->radius() + clearance);
    most_required_ = std::max(most_required_, required_.back());
    const Extent extent = extent_of_core(*obstacles_[i]);
    if (!(extent.nearest - required_.back() > farthest_place))
      scene_ = std::max({scene_, extent.largest, required_.back()});
  }
  if (boxes_.size() > kManyObstacles) {
    std::vector<BroadPhase::Box> cores;
    cores.reserve(boxes_.size());
    for (const CoreBox& box : boxes_) cores.emplace_back(Vector(box.lower), Vector(box.upper));
    tree_ = std::make_shared<const BroadPhase>(std::move(cores));
  }
}

/// How far from the origin of the workspace a part comes at most within the limits of the robot; infinity where there
/// are none.
double RobotWalls::farthest_place() const {
  const Kinematics& kinematics = *robot_->kinematics;
  const Vector lower = kinematics.lower(), upper = kinematics.upper();
  if (!lower.allFinite() || !upper.allFinite()) return kUnbounded;
  RobotPose pose;
  pose.place(*robot_, (lower + upper) / 2);
  double farthest = 0;
  for (std::size_t part = 0; part < bodies_.size(); ++part) {
    const CoreBox at = box(pose, part);
    const double here = at.lower.cwiseAbs().cwiseMax(at.upper.cwiseAbs()).norm() + bodies_[part].radius;
    farthest = std::max(farthest, here + bodies_[part].reach.dot(upper - lower) / 2);
  }
  return std::isfinite(farthest) ? farthest : kUnbounded;
}

/// Seen from the link that is nearer to the base. Where both move, their distance changes by no more than both do.
void RobotWalls::add_self_pairs() {
  const Kinematics& kinematics = *robot_->kinematics;
  int number = static_cast<int>(bodies_.size() * obstacles_.size());
  for (auto [i, j] : robot_->self) {
    const auto capsule = [&](int k) -> const Capsule& { return robot_->capsules[static_cast<std::size_t>(k)]; };
    if (capsule(i).link > capsule(j).link) std::swap(i, j);
    const Body &near = bodies_[static_cast<std::size_t>(i)], &far = bodies_[static_cast<std::size_t>(j)];
    const int from = capsule(i).link, link = capsule(j).link;
    self_reach_.push_back(reach_of(kinematics, from, link, std::array{capsule(j).from, capsule(j).to}));
    const bool branches = !kinematics.carries(from, link);
    const double steepest = branches ? near.steepest + far.steepest : kinematics.steepest(self_reach_.back(), from);
    self_.push_back({number++, j, i, true, near.radius + far.radius, steepest, branches});
  }
}

RobotWalls::CoreBox RobotWalls::box(const RobotPose& pose, std::size_t part) const {
  if (part < pose.axes.size()) {
    const Segment3& axis = pose.axes[part];
    return {axis.from.cwiseMin(axis.to), axis.from.cwiseMax(axis.to)};
  }
  const auto& [a, b, c] = pose.plates[part - pose.axes.size()];
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

/// The obstacles whose cores are no farther from a box than what is required and `farthest`; ascending.
void RobotWalls::beside(const CoreBox& box, double farthest, std::vector<int>& found) const {
  thread_local std::vector<int> met;
  const auto near = [&](std::size_t o) {
    return !farther_apart(box.lower, box.upper, boxes_[o].lower, boxes_[o].upper, required_[o] + farthest);
  };
  found.clear();
  const double widest = most_required_ + farthest;
  if (tree_ == nullptr || !std::isfinite(widest) || widest < 0) {
    for (std::size_t o = 0; o < boxes_.size(); ++o)
      if (near(o)) found.push_back(static_cast<int>(o));
    return;
  }
  tree_->meeting({Vector(box.lower.array() - widest), Vector(box.upper.array() + widest)}, met);
  for (const int o : met)
    if (near(static_cast<std::size_t>(o))) found.push_back(o);
}

RobotWalls::Between RobotWalls::between(const RobotPose& pose, const Pair& pair) const {
  Between out;
  const auto part = static_cast<std::size_t>(pair.part), other = static_cast<std::size_t>(pair.other);
  if (part >= pose.axes.size()) {
    out.distance = for_plates_[other]->distance_of_triangle(pose.plates[part - pose.axes.size()], out.point);
    return out;
  }
  const Segment3& axis = pose.axes[part];
  double on_axis = 0, on_other = 0;
  if (pair.self) {
    out.distance = distance_of_segments(axis, pose.axes[other], on_axis, on_other);
    out.foot = pose.axes[other].at(on_other);
  } else if (bodies_[part].ball && cores_[other]) {
    const OrientedBox& box = *cores_[other];
    out.distance = distance_to_box(Vector3d(box.axes.transpose() * (axis.from - box.center)), box.half);
  } else {
    thread_local Vector from, to;  // taken by reference as they are: no memory is asked for in the innermost loop
    const int space = robot_->kinematics->space();
    from.resize(space);
    to.resize(space);
    to_space(axis.from, from);
    to_space(axis.to, to);
    out.distance = obstacles_[other]->distance_of_segment(from, to, on_axis);
  }
  out.point = axis.at(on_axis);
  return out;
}

int RobotWalls::seen_from(const Pair& pair) const {
  return pair.self ? robot_->capsules[static_cast<std::size_t>(pair.other)].link : 0;
}

const RobotWalls::Vector& RobotWalls::reach(const Pair& pair) const {
  if (!pair.self) return bodies_[static_cast<std::size_t>(pair.part)].reach;
  return self_reach_[static_cast<std::size_t>(pair.number) - bodies_.size() * obstacles_.size()];
}

bool RobotWalls::convex(const Pair& pair) const {
  return pair.self || obstacles_[static_cast<std::size_t>(pair.other)]->convex();
}

/// The point of the part's core that is nearest, the nearest point of the other core, and the way from there; no way
/// where two axes meet.
RobotWalls::Plane RobotWalls::plane(const Pair& pair, const Between& nearest) const {
  Plane plane;
  plane.point = nearest.point;
  if (pair.self) {
    plane.foot = nearest.foot;
    plane.normal = (plane.point - plane.foot).normalized();
    return plane;
  }
  const int space = robot_->kinematics->space();
  Vector x(space), away(space);
  to_space(plane.point, x);
  const double distance = obstacles_[static_cast<std::size_t>(pair.other)]->distance(x, away);
  plane.normal.setZero();
  plane.normal.head(space) = away;
  plane.foot = plane.point - distance * plane.normal;
  return plane;
}

/// Of the distance by the configuration, one of them where several places are as near.
RobotWalls::Vector RobotWalls::slope(const RobotPose& pose, const Pair& pair, const Between& nearest) const {
  const Plane plane = this->plane(pair, nearest);
  const auto pull = [&](int part, const Vector3d& point) -> Vector {
    thread_local Eigen::Matrix3Xd derivative;
    const int link = robot_->link(static_cast<std::size_t>(part));
    robot_->kinematics->jacobian(pose.configuration, pose.links, link, point, derivative);
    return derivative.transpose() * plane.normal;
  };
  if (!pair.self) return pull(pair.part, plane.point);
  return pull(pair.part, plane.point) - pull(pair.other, plane.foot);
}

double RobotWalls::rounding(const Vector& a, const Vector& b) const {
  const double places = size_ + farthest_ * std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  return kOfLengths * places + kOfScene * scene_;
}

void RobotWalls::near_among(const std::vector<Pair>& pairs, const Vector& x, double reach,
                            std::vector<Wall>& found) const {
  thread_local RobotPose pose;
  pose.place_links(*robot_, x);
  int placed = -1;  // pairs of one part come one after another
  for (const Pair& pair : pairs) {
    if (pair.part != placed) pose.place_part(*robot_, static_cast<std::size_t>(pair.part));
    if (pair.self) pose.place_part(*robot_, static_cast<std::size_t>(pair.other));
    placed = pair.part;
  }
  add_near(pose, pairs, reach, found);
}

void RobotWalls::add_near(const RobotPose& pose, const std::vector<Pair>& pairs, double reach,
                          std::vector<Wall>& found) const {
  for (const Pair& pair : pairs) {
    const Between nearest = between(pose, pair);
    const double gap = (nearest.distance - pair.required) / pair.steepest;
    if (!(gap < reach)) continue;
    found.push_back({pair.number, gap, slope(pose, pair, nearest), pair.required / pair.steepest});
    found.back().slope /= pair.steepest;
  }
}

std::string RobotWalls::obstacle_name(int obstacle) const {
  if (obstacle < 0) return "";
  const auto link_of = [&](std::size_t part) { return robot_->part_name(part); };
  const auto number = static_cast<std::size_t>(obstacle), with_obstacles = bodies_.size() * obstacles_.size();
  if (number >= with_obstacles) {
    const Pair& pair = self_[number - with_obstacles];
    return link_of(static_cast<std::size_t>(pair.part)) + " and " + link_of(static_cast<std::size_t>(pair.other));
  }
  const std::size_t other = number % obstacles_.size();
  return link_of(number / obstacles_.size()) + " and " + obstacles_[other]->name() + " (number " +
         std::to_string(other) + ")";
}

/// A clearance is kept from obstacles alone.
std::string RobotWalls::depth_text(int obstacle, double missing) const {
  constexpr double kRounding = 1e-9;  // sizes
  const bool of_self = static_cast<std::size_t>(std::max(0, obstacle)) >= bodies_.size() * obstacles_.size();
  const double deep = missing - (of_self ? 0 : clearance_);
  if (obstacle < 0 || !(deep > kRounding * size_) || !std::isfinite(deep)) return "";
  return "is in collision: " + obstacle_name(obstacle) + " overlap by " + short_number(deep);
}

/// What is required of pairs, by how far the part moves at most as the configuration moves by 1.
double RobotWalls::find_thinnest() const {
  double thinnest = kUnbounded;
  const double least = required_.empty() ? kUnbounded : *std::min_element(required_.begin(), required_.end());
  for (const Body& body : bodies_)
    if (body.steepest > 0) thinnest = std::min(thinnest, (least + body.radius) / body.steepest);
  for (const Pair& pair : self_)
    if (pair.steepest > 0) thinnest = std::min(thinnest, pair.required / pair.steepest);
  return thinnest;
}

std::shared_ptr<const Walls> RobotWalls::remembering() const {
  std::shared_ptr<const RobotWalls> shared = weak_from_this().lock();
  return shared != nullptr ? std::make_shared<const RememberingWalls>(std::move(shared)) : nullptr;
}

void RobotWalls::draw(const DrawnPaths&, Drawing& out) const {
  out.notes.emplace_back("this is the configuration space; the robot and its obstacles are drawn next to it");
}

PoseStrip RobotWalls::pose_strip(const Points& configurations) const {
  return robot_strip(*robot_, obstacles_, configurations);
}

}  // namespace leastcost
