// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <leastcost/problems/robots/robot_walls.hpp>
#include "problems/robots/least_on_move.hpp"
#include "problems/robots/robot_pose.hpp"
#include "problems/robots/robot_walls_parts.hpp"

namespace leastcost {

/// Pairs with a distance of at most what is required and margin(part), some others among them; ascending by number.
/// Obstacles are first looked at for all parts of a link at once.
template <class Margin>
void RobotWalls::pairs_within(const RobotPose& pose, const Margin& margin, std::vector<Pair>& found) const {
  thread_local std::vector<CoreBox> own;
  thread_local std::vector<int> beside;  // what a link may be near to
  own.clear();
  for (std::size_t i = 0; i < bodies_.size(); ++i) own.push_back(box(pose, i));
  for (std::size_t first = 0, last = 0; first < bodies_.size(); first = last) {
    CoreBox all = own[first];
    double farthest = -robot_walls::kUnbounded;
    const int link = robot_->link(first);
    for (last = first; last < bodies_.size() && robot_->link(last) == link; ++last) {
      all.lower = all.lower.cwiseMin(own[last].lower).eval();
      all.upper = all.upper.cwiseMax(own[last].upper).eval();
      farthest = std::max(farthest, bodies_[last].radius + margin(static_cast<int>(last)));
    }
    this->beside(all, farthest, beside);
    for (std::size_t i = first; i < last; ++i) {
      const Body& body = bodies_[i];
      if (!(body.steepest > 0)) continue;
      const int part = static_cast<int>(i);
      const double wanted = margin(part);
      for (const int other : beside) {
        const auto o = static_cast<std::size_t>(other);
        const double required = required_[o] + body.radius;
        if (robot_walls::farther_apart(own[i].lower, own[i].upper, boxes_[o].lower, boxes_[o].upper, required + wanted))
          continue;
        found.push_back({part * static_cast<int>(boxes_.size()) + other, part, other, false, required, body.steepest});
      }
    }
  }
  for (const Pair& pair : self_) {
    const CoreBox &first = own[static_cast<std::size_t>(pair.part)],
                  &second = own[static_cast<std::size_t>(pair.other)];
    const double within = pair.required + margin(pair.part) + (pair.branches ? margin(pair.other) : 0.0);
    if (!robot_walls::farther_apart(first.lower, first.upper, second.lower, second.upper, within))
      found.push_back(pair);
  }
}

/// A robot on its way from a to b.
class RobotWalls::OnMove final : public DistancesOnMove {
 public:
  OnMove(const RobotWalls& walls, const Vector& a, const Vector& b) : walls_(&walls), a_(a), b_(b), way_(b - a) {}

  Vector place(double t) const { return t == 1 ? b_ : Vector(a_ + t * way_); }
  const RobotPose& pose(double t) {
    if (t != placed_) pose_.place(*walls_->robot_, place(t));
    placed_ = t;
    return pose_;
  }
  bool bounded() {
    const std::vector<double>& all = speeds();
    return std::all_of(all.begin(), all.end(), [](double speed) { return std::isfinite(speed); });
  }
  double fastest() { return *std::max_element(speeds().begin(), speeds().end()); }

  /// Pairs whose gap may be below `beyond(part)` somewhere on the move.
  template <class Beyond>
  std::vector<Pair> pairs(const Beyond& beyond) {
    std::vector<Pair> found;
    const std::vector<double>& all = speeds();
    walls_->pairs_within(
        pose(kMiddle), [&](int i) { return all[static_cast<std::size_t>(i)] / 2 + beyond(i); }, found);
    return found;
  }

  /// Pairs that may be too near in the middle of the move.
  std::vector<Pair> pairs_at_middle() {
    std::vector<Pair> found;
    walls_->pairs_within(
        pose(kMiddle), [](int) { return 0.0; }, found);
    return found;
  }

  /// Where others are not asked for at this t, no more than the pair is placed.
  double distance(double t, const Pair& pair) {
    if (t == placed_) return walls_->between(pose_, pair).distance;
    if (t != placed_alone_) alone_.place_links(*walls_->robot_, place(t));
    placed_alone_ = t;
    alone_.place_part(*walls_->robot_, static_cast<std::size_t>(pair.part));
    if (pair.self) alone_.place_part(*walls_->robot_, static_cast<std::size_t>(pair.other));
    return walls_->between(alone_, pair).distance;
  }

  MotionBound bound(const Pair& pair) const {
    return kinematics().motion(a_, b_, walls_->reach(pair), walls_->seen_from(pair));
  }

  /// The least of (distance - offset) / scale over some pairs; offset and scale are those of scaled(pair, distance).
  template <class Scaled>
  LeastOnMove least(const std::vector<Pair>& pairs, const Scaled& scaled, const MovePrecision& precision) {
    pairs_ = &pairs;
    bounds_.clear();
    std::vector<MovingDistance> known;
    for (const Pair& pair : pairs) {
      bounds_.push_back(bound(pair));
      known.push_back(scaled(pair, MovingDistance{bounds_.back().speed, bounds_.back().acceleration}));
    }
    return least_on_move(known, *this, precision);
  }

  void at(double t, const std::vector<int>& which, std::vector<double>& distances) override {
    distances.clear();
    if (which.size() > 1) pose(t);
    for (const int k : which) distances.push_back(distance(t, (*pairs_)[static_cast<std::size_t>(k)]));
  }

  /// A convex core lies behind the plane through its nearest point; what a corner of the part's core is before that
  /// plane is at most a cubic's worth off its second-order expansion.
  double least_around(double t, double half, int which, double distance) override {
    const Pair& pair = (*pairs_)[static_cast<std::size_t>(which)];
    if (!(distance > 0) || !walls_->convex(pair)) return -robot_walls::kUnbounded;
    const RobotPose& here = pose(t);
    const Plane plane = walls_->plane(pair, walls_->between(here, pair));
    const auto part = static_cast<std::size_t>(pair.part);
    const int link = walls_->robot_->link(part);
    const double off = bounds_[static_cast<std::size_t>(which)].jerk * half * half * half / 6;
    const auto least_of = [&](const Eigen::Vector3d& corner) {
      const PointMotion motion =
          kinematics().moving(here.configuration, here.links, way_, link, corner, walls_->seen_from(pair));
      const double height = plane.normal.dot(corner - plane.foot), slope = std::abs(plane.normal.dot(motion.velocity));
      const double bend = plane.normal.dot(motion.acceleration);
      const bool valley = bend > 0 && slope < bend * half;
      return height - off - (valley ? slope * slope / (2 * bend) : (slope - bend * half / 2) * half);
    };
    if (part < here.axes.size()) return std::min(least_of(here.axes[part].from), least_of(here.axes[part].to));
    const auto& [a, b, c] = here.plates[part - here.axes.size()];
    return std::min({least_of(a), least_of(b), least_of(c)});
  }

 private:
  static constexpr double kMiddle = 0.5;

  const Kinematics& kinematics() const { return *walls_->robot_->kinematics; }
  /// Of the parts. Who asks about some pairs only needs none of them.
  const std::vector<double>& speeds() {
    if (!speeds_.empty()) return speeds_;
    speeds_.reserve(walls_->bodies_.size());
    for (const Body& body : walls_->bodies_)
      speeds_.push_back(body.steepest > 0 ? kinematics().motion(a_, b_, body.reach, 0).speed : 0);
    return speeds_;
  }

  const RobotWalls* walls_;
  const Vector &a_, &b_;
  Vector way_;
  std::vector<double> speeds_;  ///< empty: not asked for yet
  const std::vector<Pair>* pairs_ = nullptr;
  std::vector<MotionBound> bounds_;  ///< of the pairs
  double placed_ = std::numeric_limits<double>::quiet_NaN(), placed_alone_ = placed_;
  RobotPose pose_, alone_;
};

}  // namespace leastcost
