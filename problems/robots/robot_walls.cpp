// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/robot_walls.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include <leastcost/framework/base/ability.hpp>
#include <leastcost/framework/base/errors.hpp>
#include "problems/obstacles/broad_phase.hpp"
#include "problems/robots/box_distance.hpp"
#include "problems/robots/least_on_move.hpp"
#include "problems/robots/least_value.hpp"
#include "problems/robots/move_sieve.hpp"
#include "problems/robots/remembering_walls.hpp"
#include "problems/robots/robot_pose.hpp"
#include "problems/robots/robot_strip.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kOfLengths = 256 * std::numeric_limits<double>::epsilon();  ///< rounding of frames and distances
constexpr double kDecided = 1e-10;  ///< sizes: so near are the bounds of a clearance in contact
constexpr double kShareOfGap = 0.5, kShareOfCoreRoom = 0.5;
constexpr int kFewestPlaces = 4, kMostPlaces = 64;    ///< of a move that are looked at before its least gap is followed
constexpr std::size_t kManyObstacles = 64;            ///< from here on a tree of them is quicker
constexpr double kFollowed = 1e-12, kNearest = 1e-3;  // sizes: how closely that is; at least, of the move
constexpr double kPlacesApart = 0.5;                  ///< of what is required: how far a part goes between them

/// Whether the distance of two boxes with sides along the axes is more than this.
bool farther_apart(const Vector3d& lower, const Vector3d& upper, const Vector3d& other_lower,
                   const Vector3d& other_upper, double distance) {
  double square = 0;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double apart = std::max({other_lower[i] - upper[i], lower[i] - other_upper[i], 0.0});
    square += apart * apart;
  }
  return distance < 0 || square > distance * distance;
}

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

}  // namespace

/// A robot on its way from a to b.
class RobotWalls::OnMove final : public DistancesOnMove {
 public:
  OnMove(const RobotWalls& walls, const Vector& a, const Vector& b) : walls_(&walls), a_(a), b_(b), way_(b - a) {
    speeds_.reserve(walls.bodies_.size());
    for (const Body& body : walls.bodies_)
      speeds_.push_back(body.steepest > 0 ? kinematics().motion(a, b, body.reach, 0).speed : 0);
  }

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
    if (!(distance > 0) || !walls_->convex(pair)) return -kUnbounded;
    const RobotPose& here = pose(t);
    const Plane plane = walls_->plane(pair, walls_->between(here, pair));
    const auto part = static_cast<std::size_t>(pair.part);
    const int link = walls_->robot_->link(part);
    const double off = bounds_[static_cast<std::size_t>(which)].jerk * half * half * half / 6;
    const auto least_of = [&](const Vector3d& corner) {
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

RobotWalls::RobotWalls(std::shared_ptr<const Robot> robot, Obstacles obstacles, double clearance)
    : robot_(std::move(robot)) {
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
  if (robot_->plates.empty()) sieve_ = std::make_shared<const MoveSieve>(robot_, obstacles_, required_);
}

void RobotWalls::add_obstacles(Obstacles obstacles, double clearance) {
  obstacles_ = std::move(obstacles);
  const int space = robot_->kinematics->space();
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    const Obstacle::Box core = obstacles_[i]->core_bounds();
    if (core.dim() != space)
      throw OptionError(std::to_string(i), obstacles_[i]->name() + " has " + std::to_string(core.dim()) +
                                               " dimensions, but the workspace of the robot has " +
                                               std::to_string(space));
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
    size_ = std::max(size_, required_.back());
    Vector away(space);
    size_ = std::max(size_, box.lower.allFinite() && box.upper.allFinite()
                                ? std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff())
                                : std::abs(obstacles_[i]->distance(Vector::Zero(space), away)));
  }
  if (boxes_.size() > kManyObstacles) {
    std::vector<BroadPhase::Box> cores;
    cores.reserve(boxes_.size());
    for (const CoreBox& box : boxes_) cores.emplace_back(Vector(box.lower), Vector(box.upper));
    tree_ = std::make_shared<const BroadPhase>(std::move(cores));
  }
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
    double farthest = -kUnbounded;
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
        if (farther_apart(own[i].lower, own[i].upper, boxes_[o].lower, boxes_[o].upper, required + wanted)) continue;
        found.push_back({part * static_cast<int>(boxes_.size()) + other, part, other, false, required, body.steepest});
      }
    }
  }
  for (const Pair& pair : self_) {
    const CoreBox &first = own[static_cast<std::size_t>(pair.part)],
                  &second = own[static_cast<std::size_t>(pair.other)];
    const double within = pair.required + margin(pair.part) + (pair.branches ? margin(pair.other) : 0.0);
    if (!farther_apart(first.lower, first.upper, second.lower, second.upper, within)) found.push_back(pair);
  }
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
  return kOfLengths * (size_ + farthest_ * std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()));
}

void RobotWalls::near(const Vector& x, double reach, std::vector<Wall>& found) const {
  found.clear();
  thread_local RobotPose pose;
  thread_local std::vector<Pair> pairs;
  pose.place(*robot_, x);
  pairs.clear();
  const double within = std::max(0.0, reach);
  pairs_within(
      pose, [&](int i) { return within * bodies_[static_cast<std::size_t>(i)].steepest; }, pairs);
  add_near(pose, pairs, reach, found);
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

void RobotWalls::gaps_within(const Vector& x, double reach, std::vector<PairGap>& found) const {
  thread_local RobotPose pose;
  thread_local std::vector<Pair> pairs;
  pose.place(*robot_, x);
  pairs.clear();
  pairs_within(
      pose, [&](int i) { return reach * bodies_[static_cast<std::size_t>(i)].steepest; }, pairs);
  found.clear();
  for (const Pair& pair : pairs) {
    const double gap = (between(pose, pair).distance - pair.required) / pair.steepest;
    if (gap < reach) found.push_back({pair, gap});
  }
}

MoveClearance RobotWalls::clearance(const Vector& a, const Vector& b) const {
  MoveClearance least;
  least.lower = least.upper = kUnbounded;
  if (obstacles_.empty() && self_.empty()) return least;
  if (!a.allFinite() || !b.allFinite()) return {-kUnbounded, kUnbounded, -1, a};
  OnMove move(*this, a, b);
  if (!move.bounded()) {  // too far for anything to be known in between
    least = clearance(a, a);
    MoveClearance at_end = clearance(b, b);
    if (at_end.upper < least.upper) least = std::move(at_end);
    least.lower = -kUnbounded;
    return least;
  }
  // What is asked for is how near it is, also where nothing is near: ever farther until something is found.
  std::vector<Pair> pairs;
  double wanted = move.fastest() + size_ / 16;
  for (; pairs.empty() && std::isfinite(wanted); wanted *= 4) pairs = move.pairs([&](int) { return wanted; });
  if (pairs.empty()) return least;
  double best = kUnbounded;
  for (const Pair& pair : pairs) best = std::min(best, move.distance(0.5, pair) - pair.required);
  return least_gap(move, std::max(0.0, best) + rounding(a, b), rounding(a, b));  // no others can be as near
}

/// Of the pairs that may come nearer than `widest`; where there are none, that.
MoveClearance RobotWalls::least_gap(OnMove& move, double widest, double rounding) const {
  const std::vector<Pair> pairs = move.pairs([&](int) { return widest; });
  if (pairs.empty()) return {widest - rounding, kUnbounded, -1, {}};
  const auto gap = [](const Pair& pair, MovingDistance known) {
    known.offset = pair.required;
    return known;
  };
  const LeastOnMove found = move.least(pairs, gap, {.accuracy = kDecided * size_, .share = kShareOfGap});
  if (found.which < 0) return {-kUnbounded, kUnbounded, -1, move.place(0)};
  return {found.lower - rounding, found.upper, pairs[static_cast<std::size_t>(found.which)].number,
          move.place(found.at)};
}

/// Pieces of a chain, those that may come nearest first: what is near the place in their middle is no nearer anywhere
/// on them than what its part goes from there. Moves alone are measured as such.
class RobotWalls::ChainLook {
 public:
  ChainLook(const RobotWalls& walls, const Points& x)
      : walls_(walls), x_(x), gone_(Points::Zero(static_cast<Eigen::Index>(walls.bodies_.size()), x.cols())) {
    const Kinematics& kinematics = *walls.robot_->kinematics;
    const Eigen::Index last = x.cols() - 1;
    rounding_ = std::max(walls.rounding(x.col(0), x.col(last)),
                         kOfLengths * (walls.size_ + walls.farthest_ * x.cwiseAbs().maxCoeff()));
    for (Eigen::Index k = 0; k < last; ++k) {
      const Vector a = x.col(k), b = x.col(k + 1);
      for (std::size_t i = 0; i < walls.bodies_.size(); ++i) {
        const Body& body = walls.bodies_[i];
        const auto row = static_cast<Eigen::Index>(i);
        gone_(row, k + 1) = gone_(row, k) + (body.steepest > 0 ? kinematics.motion(a, b, body.reach, 0).speed : 0);
      }
    }
    best_.least.lower = best_.least.upper = kUnbounded;
  }

  std::optional<ChainClearance> run() {
    if (!gone_.allFinite() || !x_.allFinite()) return std::nullopt;
    add(0, x_.cols() - 1);
    while (!open_.empty() && !enough(std::min(settled_, open_.front().lower))) {
      std::pop_heap(open_.begin(), open_.end());
      const Piece piece = open_.back();
      open_.pop_back();
      split(piece);
    }
    const double open = open_.empty() ? kUnbounded : open_.front().lower;
    best_.least.lower = std::min({settled_, open, best_.least.upper}) - rounding_;
    return best_;
  }

 private:
  struct Piece {
    Eigen::Index first = 0, last = 0;  ///< columns
    double lower = 0;
    bool operator<(const Piece& other) const { return lower > other.lower; }  // the lowest is on top
  };

  bool enough(double lower) const {
    const double upper = best_.least.upper;
    return lower >= upper - kDecided * walls_.size_ || (lower > 0 && lower >= kShareOfGap * upper);
  }

  void split(const Piece& piece) {
    if (piece.last - piece.first > 1) {
      const Eigen::Index middle = (piece.first + piece.last) / 2;
      add(piece.first, middle);
      add(middle, piece.last);
      return;
    }
    const Vector a = x_.col(piece.first), b = x_.col(piece.last);
    OnMove move(walls_, a, b);
    MoveClearance least = walls_.least_gap(move, std::max(0.0, best_.least.upper) + rounding_, rounding_);
    settled_ = std::min(settled_, least.lower + rounding_);
    if (least.upper < best_.least.upper) best_ = {std::move(least), piece.first};
  }

  void add(Eigen::Index first, Eigen::Index last) {
    const Eigen::Index middle = (first + last) / 2;
    pose_.place(*walls_.robot_, x_.col(middle));
    const auto goes = [&](int part) {
      return std::max(gone_(part, last) - gone_(part, middle), gone_(part, middle) - gone_(part, first));
    };
    const auto look = [&](double beyond) {
      pairs_.clear();
      walls_.pairs_within(
          pose_, [&](int part) { return goes(part) + beyond; }, pairs_);
    };
    double beyond = best_.least.upper;
    if (std::isfinite(beyond)) {
      look(beyond);
    } else {  // how near it is, also where nothing is near: ever farther until something is found
      for (beyond = walls_.size_ / 16; std::isfinite(beyond); beyond *= 4) {
        look(beyond);
        if (!pairs_.empty()) break;
      }
    }
    Piece piece{first, last, beyond};
    for (const Pair& pair : pairs_) {
      const double gap = walls_.between(pose_, pair).distance - pair.required;
      piece.lower = std::min(piece.lower, gap - goes(pair.part) - (pair.branches ? goes(pair.other) : 0.0));
      if (gap >= best_.least.upper) continue;
      best_ = {{gap, gap, pair.number, x_.col(middle)}, std::min(middle, x_.cols() - 2)};
    }
    open_.push_back(piece);
    std::push_heap(open_.begin(), open_.end());
  }

  const RobotWalls& walls_;
  const Points& x_;
  Points gone_;  ///< parts x places: how far each has gone on the way there, at most
  double rounding_ = 0, settled_ = kUnbounded;
  ChainClearance best_;
  RobotPose pose_;
  std::vector<Pair> pairs_;
  std::vector<Piece> open_;
};

std::optional<ChainClearance> RobotWalls::chain_clearance(const Points& x) const {
  if (obstacles_.empty() && self_.empty()) return std::nullopt;
  return ChainLook(*this, x).run();
}

/// What seems to be in contact is left to second-order bounds.
bool RobotWalls::clears(const Vector& a, const Vector& b) const {
  constexpr double kFinest = 1e-3;  // sizes: how far a part goes on the shortest pieces that are looked at
  if (!a.allFinite() || !b.allFinite()) return false;
  if (sieve_ == nullptr) return clears_closely(a, b);
  MoveSieve::Pieces left;
  if (!sieve_->passes(a, b, rounding(a, b), kFinest * size_, left)) return false;
  return std::all_of(left.begin(), left.end(), [&](const std::pair<double, double>& piece) {
    const auto place = [&](double t) { return t == 1 ? b : Vector(a + t * (b - a)); };
    return clears_closely(place(piece.first), place(piece.second));
  });
}

/// Long moves in halves, the coarse ones first, so that what is in the way is met early; what few pairs may be in the
/// way of is bisected for these alone.
bool RobotWalls::clears_closely(const Vector& a, const Vector& b) const {
  constexpr std::size_t kFewPairs = 12, kManyPairs = 60;
  constexpr double kShort = 1e-3;  // sizes
  const auto gap = [](const Pair& pair, MovingDistance known) {
    known.offset = pair.required;
    return known;
  };
  const double rounding = this->rounding(a, b);
  std::deque<std::pair<Vector, Vector>> open = {{a, b}};
  for (; !open.empty(); open.pop_front()) {
    const auto& [from, to] = open.front();
    OnMove move(*this, from, to);
    if (!move.bounded()) return clearance(a, b).upper >= 0;
    std::vector<Pair> pairs = move.pairs([](int) { return 0.0; });
    const bool many = pairs.size() > kManyPairs && move.fastest() > kShort * size_;
    if (many) pairs = move.pairs_at_middle();  // what is in the way there, no more
    for (Pair& pair : pairs) {
      const double room = move.distance(0.5, pair) - pair.required;
      if (room < -rounding) return false;
      const double moved = pair.branches ? move.fastest() : move.fastest() / 2;
      if (room > moved + rounding) pair.part = -1;  // nowhere on this part of the move
    }
    std::erase_if(pairs, [](const Pair& pair) { return pair.part < 0; });
    if (pairs.empty() && !many) continue;
    if (many || (pairs.size() > kFewPairs && move.fastest() > kShort * size_)) {
      const Vector middle = move.place(0.5);
      open.emplace_back(from, middle);
      open.emplace_back(middle, open.front().second);
      continue;
    }
    const MovePrecision precision{.accuracy = kDecided * size_, .enough = 0, .too_low = -rounding};
    const LeastOnMove least = move.least(pairs, gap, precision);
    if (least.upper < -rounding || !(least.lower >= -2 * precision.accuracy - rounding)) return false;
  }
  return true;
}

/// The least gaps are followed to their places from the lowest of some; what is proved is the clearance.
void RobotWalls::along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const {
  found.clear();
  OnMove move(*this, a, b);
  if (!move.bounded()) return Walls::along(a, b, reach, found);
  const double within = std::max(0.0, reach);
  const std::vector<Pair> pairs =
      move.pairs([&](int i) { return within * bodies_[static_cast<std::size_t>(i)].steepest; });
  add_along(move, pairs, reach, found);
}

void RobotWalls::along_among(const std::vector<Pair>& pairs, const Vector& a, const Vector& b, double reach,
                             std::vector<Wall>& found) const {
  OnMove move(*this, a, b);
  for (const Pair& pair : pairs)
    if (!std::isfinite(move.bound(pair).speed)) return Walls::along(a, b, reach, found);
  add_along(move, pairs, reach, found);
}

void RobotWalls::add_along(OnMove& move, const std::vector<Pair>& pairs, double reach, std::vector<Wall>& found) const {
  constexpr double kMiddle = 0.5;
  for (const Pair& pair : pairs) {
    const MotionBound bound = move.bound(pair);
    const MovingDistance known{bound.speed, bound.acceleration};
    const double speed = bound.speed, wanted = pair.required + reach * pair.steepest;
    const double middle = move.distance(kMiddle, pair);
    if (middle - speed / 2 >= wanted) continue;
    if (least_distance_on_piece(known, kMiddle, move.distance(0, pair), middle) >= wanted &&
        least_distance_on_piece(known, kMiddle, middle, move.distance(1, pair)) >= wanted)
      continue;
    const auto distance_at = [&](double t) { return move.distance(t, pair); };
    const int places = static_cast<int>(
        std::clamp(std::ceil(speed / (kPlacesApart * pair.required)), double{kFewestPlaces}, double{kMostPlaces}));
    const double near = std::sqrt(2 * kFollowed * size_ / bound.acceleration);  // of t, for so much of the distance
    const ValueAt least = least_value(distance_at, places, std::clamp(near, 2e-9, kNearest));
    const double gap = (least.value - pair.required) / pair.steepest;
    if (!(gap < reach)) continue;
    const RobotPose& there = move.pose(least.at);
    const Vector slope = this->slope(there, pair, between(there, pair));
    found.push_back({pair.number, gap, slope, pair.required / pair.steepest, least.at});
    found.back().slope /= pair.steepest;
  }
}

double RobotWalls::room(const Vector& a, const Vector& b, double reach) const {
  OnMove move(*this, a, b);
  if (!move.bounded()) return 0;
  const std::vector<Pair> pairs = move.pairs([&](int i) {
    const Body& body = bodies_[static_cast<std::size_t>(i)];
    return reach * body.steepest - body.radius;  // between the cores, not from the surface
  });
  std::vector<PairGap> unknown;
  unknown.reserve(pairs.size());
  for (const Pair& pair : pairs) unknown.push_back({pair, 0});
  return room(move, unknown, reach);
}

double RobotWalls::room_among(const std::vector<PairGap>& pairs, const Vector& a, const Vector& b, double reach) const {
  OnMove move(*this, a, b);
  return room(move, pairs, reach);
}

/// Pairs ascending by a lower bound of what is asked for. A look in the middle will mostly do. 0 for moves so long that
/// nothing is known of places in between.
double RobotWalls::room(OnMove& move, const std::vector<PairGap>& pairs, double reach) const {
  constexpr double kMiddle = 0.5, kEnough = 0.6, kShareOfMiddle = 0.5;
  double known = reach;
  thread_local std::vector<PairGap> unsettled;
  unsettled.clear();
  for (const auto& [pair, bound] : pairs) {
    if (bound >= known) break;
    const double speed = move.bound(pair).speed;
    if (!std::isfinite(speed)) return 0;
    const double middle = move.distance(kMiddle, pair) / pair.steepest;
    const double lower = std::max(bound, middle - speed / 2 / pair.steepest);
    if (lower >= known) continue;
    if (lower >= kEnough * reach || lower >= kShareOfMiddle * middle)
      known = lower;
    else
      unsettled.push_back({pair, lower});
  }
  std::vector<Pair> open;
  for (const auto& [pair, lower] : unsettled)
    if (lower < known) open.push_back(pair);
  if (open.empty()) return std::max(0.0, known);
  const auto from_core = [](const Pair& pair, MovingDistance one) {
    one.scale = pair.steepest;
    return one;
  };
  const MovePrecision precision{.accuracy = 1e-3 * reach, .share = kShareOfCoreRoom, .enough = kEnough * reach};
  return std::clamp(move.least(open, from_core, precision).lower, 0.0, known);
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

/// What is required of pairs, by how far the part moves at most as the configuration moves by 1.
double RobotWalls::thinnest() const {
  double thinnest = kUnbounded;
  for (const Body& body : bodies_)
    for (const double required : required_)
      if (body.steepest > 0) thinnest = std::min(thinnest, (required + body.radius) / body.steepest);
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
