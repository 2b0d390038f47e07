// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/robots/move_sieve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <leastcost/framework/base/ability.hpp>
#include "problems/obstacles/broad_phase.hpp"
#include "problems/robots/box_distance.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kManyThings = 64;       ///< from here on a tree of them is quicker
constexpr std::size_t kMostPieces = 1 << 16;  ///< of a move, open at once: of one with more nothing is known in time
constexpr int kMostTogether = 64;             ///< parts of a link, pairs of two links: bits of Open::which

constexpr std::uint64_t all_of(int count) { return ~std::uint64_t{0} >> (kMostTogether - count); }

/// A vector in the axes of a box.
Vector3d seen_from(const OrientedBox& box, const Vector3d& x) {
  return {box.axes.col(0).dot(x), box.axes.col(1).dot(x), box.axes.col(2).dot(x)};
}

Vector3d in_workspace(const Frame& link, const Vector3d& local) {
  return link.origin + local[0] * link.rotation.col(0) + local[1] * link.rotation.col(1) +
         local[2] * link.rotation.col(2);
}

OrientedBox box_around(const Obstacle& obstacle, bool& exact) {
  const auto* has = find_ability<HasCoreBox>(obstacle);
  exact = has != nullptr;
  if (exact) return has->core_box();
  const Obstacle::Box core = obstacle.core_bounds();
  OrientedBox box;
  if (!core.min().allFinite() || !core.max().allFinite()) {  // of a half-space: all that is known is its distance
    box.half.setConstant(std::numeric_limits<double>::infinity());
    return box;
  }
  box.center.head(core.dim()) = (core.min() + core.max()) / 2;
  box.half.head(core.dim()) = (core.max() - core.min()) / 2;
  return box;
}

}  // namespace

/// A robot on its way from a to b: one place of it, its capsules as they are asked for.
struct MoveSieve::OnMove {
  const MoveSieve* sieve = nullptr;
  Vector way, place;
  std::vector<MotionBound> bounds;  ///< of the links, then the pairs of links
  std::vector<Frame> frames;
  std::vector<Vector3d> centers;
  std::vector<char> placed;  ///< links
  std::vector<Segment3> axes;
  std::vector<double> speeds;  ///< of the parts, here; negative: not asked for yet

  void go_to(const Vector& configuration) {
    place = configuration;
    sieve->robot_->kinematics->place(place, frames);
    centers.resize(sieve->links_.size());
    for (std::size_t i = 0; i < centers.size(); ++i)
      centers[i] = in_workspace(frames[static_cast<std::size_t>(sieve->links_[i].number)], sieve->links_[i].center);
    placed.assign(centers.size(), 0);
    axes.resize(sieve->parts_.size());
    speeds.assign(sieve->parts_.size(), -1);
  }

  void place_parts(int link) {
    char& done = placed[static_cast<std::size_t>(link)];
    if (done != 0) return;
    done = 1;
    const Link& of = sieve->links_[static_cast<std::size_t>(link)];
    const Frame& frame = frames[static_cast<std::size_t>(of.number)];
    for (int k = of.first; k < of.last; ++k) {
      const Capsule& capsule = sieve->parts_[static_cast<std::size_t>(k)].capsule;
      axes[static_cast<std::size_t>(k)] = {in_workspace(frame, capsule.from), in_workspace(frame, capsule.to)};
    }
  }

  /// Of the ends of a part's axis, and so of all of it.
  double speed_of(std::size_t part, int seen_from) const {
    const Kinematics& kinematics = *sieve->robot_->kinematics;
    const auto speed = [&](const Vector3d& x) {
      return kinematics.moving(place, frames, way, sieve->parts_[part].capsule.link, x, seen_from).velocity.norm();
    };
    const Segment3& axis = axes[part];
    return sieve->parts_[part].half > 0 ? std::max(speed(axis.from), speed(axis.to)) : speed(axis.from);
  }

  double speed_here(std::size_t part) {
    if (speeds[part] < 0) speeds[part] = speed_of(part, 0);
    return speeds[part];
  }
};

MoveSieve::MoveSieve(std::shared_ptr<const Robot> robot, Obstacles obstacles, const std::vector<double>& required)
    : robot_(std::move(robot)), obstacles_(std::move(obstacles)) {
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    Thing thing;
    thing.required = required[i];
    thing.box = box_around(*obstacles_[i], thing.exact);
    thing.reach = thing.box.half.norm();
    things_.push_back(thing);
    most_required_ = std::max(most_required_, thing.required);
  }
  if (things_.size() > kManyThings) {
    std::vector<BroadPhase::Box> cores;
    cores.reserve(things_.size());
    for (const auto& obstacle : obstacles_) cores.push_back(obstacle->core_bounds());
    tree_ = std::make_shared<const BroadPhase>(std::move(cores));
  }
  std::vector<int> order(robot_->capsules.size());  // by links
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) {
    return robot_->capsules[static_cast<std::size_t>(i)].link < robot_->capsules[static_cast<std::size_t>(j)].link;
  });
  add_links(order);
  add_link_pairs(order);
}

void MoveSieve::add_links(const std::vector<int>& order) {
  const Kinematics& kinematics = *robot_->kinematics;
  for (const int i : order) {
    const Capsule& capsule = robot_->capsules[static_cast<std::size_t>(i)];
    if (links_.empty() || links_.back().number != capsule.link ||
        links_.back().last - links_.back().first == kMostTogether) {
      Link link;
      link.number = capsule.link;
      link.first = link.last = static_cast<int>(parts_.size());
      link.reach = Vector::Zero(kinematics.dimension());
      links_.push_back(std::move(link));
    }
    Link& link = links_.back();
    ++link.last;
    for (const Vector3d& end : {capsule.from, capsule.to})
      link.reach = link.reach.cwiseMax(kinematics.reach(capsule.link, end)).eval();
    parts_.push_back({capsule, (capsule.to - capsule.from).norm() / 2});
  }
  for (Link& link : links_) {
    Eigen::AlignedBox3d box;
    for (int k = link.first; k < link.last; ++k) {
      const Capsule& capsule = parts_[static_cast<std::size_t>(k)].capsule;
      for (const Vector3d& end : {capsule.from, capsule.to}) {
        box.extend(Vector3d(end.array() - capsule.radius));
        box.extend(Vector3d(end.array() + capsule.radius));
      }
    }
    link.center = box.center();
    for (int k = link.first; k < link.last; ++k) {
      const Capsule& capsule = parts_[static_cast<std::size_t>(k)].capsule;
      for (const Vector3d& end : {capsule.from, capsule.to})
        link.radius = std::max(link.radius, (end - link.center).norm() + capsule.radius);
    }
    link.moves = kinematics.steepest(link.reach, 0) > 0;
  }
}

/// Of all parts of a link, as seen from another one.
MoveSieve::Vector MoveSieve::reach_from(int seen_from, int link) const {
  const Kinematics& kinematics = *robot_->kinematics;
  const Link &from = links_[static_cast<std::size_t>(seen_from)], &of = links_[static_cast<std::size_t>(link)];
  Vector reach = Vector::Zero(kinematics.dimension());
  for (int k = of.first; k < of.last; ++k) {
    const Capsule& capsule = parts_[static_cast<std::size_t>(k)].capsule;
    for (const Vector3d& end : {capsule.from, capsule.to})
      reach = reach.cwiseMax(kinematics.reach_from(from.number, of.number, end)).eval();
  }
  return reach;
}

/// Seen from the link that is nearer to the base.
void MoveSieve::add_link_pairs(const std::vector<int>& order) {
  std::vector<int> place(parts_.size());  // of the robot's capsules in parts_
  for (std::size_t k = 0; k < order.size(); ++k) place[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  const auto link_with = [&](int part) {
    int i = 0;
    while (links_[static_cast<std::size_t>(i)].last <= part) ++i;
    return i;
  };
  std::map<std::pair<int, int>, std::vector<Pair>> by_links;
  for (const auto& [i, j] : robot_->self) {
    int near = place[static_cast<std::size_t>(i)], far = place[static_cast<std::size_t>(j)];
    if (near > far) std::swap(near, far);
    by_links[{link_with(far), link_with(near)}].push_back(
        {far, near,
         parts_[static_cast<std::size_t>(far)].capsule.radius + parts_[static_cast<std::size_t>(near)].capsule.radius});
  }
  for (const auto& [links, pairs] : by_links)
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (k % kMostTogether == 0) {
        LinkPair both;
        both.far = links.first;
        both.near = links.second;
        both.first = both.last = static_cast<int>(pairs_.size());
        both.reach = reach_from(both.near, both.far);
        link_pairs_.push_back(std::move(both));
      }
      ++link_pairs_.back().last;
      pairs_.push_back(pairs[k]);
    }
}

double MoveSieve::distance(const Segment3& axis, std::size_t thing) const {
  const OrientedBox& box = things_[thing].box;
  if (things_[thing].exact)
    return distance_to_box(seen_from(box, axis.from - box.center), seen_from(box, axis.to - axis.from), box.half);
  thread_local Vector from, to;
  const int space = robot_->kinematics->space();
  from = axis.from.head(space);
  to = axis.to.head(space);
  double t = 0;
  return obstacles_[thing]->distance_of_segment(from, to, t);
}

/// What a link may come near to on the whole move: its ball in the middle, made larger by how far it goes. All there
/// is, where few are there or nothing is known of the move.
void MoveSieve::things_near(const OnMove& move, std::size_t link, double rounding, std::vector<int>& found) const {
  const double reach = links_[link].radius + most_required_ + move.bounds[link].speed / 2 + rounding;
  if (tree_ == nullptr || !std::isfinite(reach)) {
    found.resize(things_.size());
    std::iota(found.begin(), found.end(), 0);
    return;
  }
  const Vector center = move.centers[link].head(robot_->kinematics->space());
  tree_->meeting({Vector(center.array() - reach), Vector(center.array() + reach)}, found);
}

MoveSieve::Found MoveSieve::look_at_thing(OnMove& move, Open& open, double half, double rounding) const {
  const Link& link = links_[static_cast<std::size_t>(open.link)];
  const auto number = static_cast<std::size_t>(open.thing);
  const Thing& thing = things_[number];
  const MotionBound& bound = move.bounds[static_cast<std::size_t>(open.link)];
  const double far = half * bound.speed, wanted = link.radius + thing.required + far + rounding;
  const Vector3d apart = move.centers[static_cast<std::size_t>(open.link)] - thing.box.center;
  if (apart.squaredNorm() >= (wanted + thing.reach) * (wanted + thing.reach)) return Found::clear;
  if (distance_to_box(seen_from(thing.box, apart), thing.box.half) >= wanted) return Found::clear;
  move.place_parts(open.link);
  for (int k = link.first; k < link.last; ++k) {
    const std::uint64_t bit = std::uint64_t{1} << (k - link.first);
    if ((open.which & bit) == 0) continue;
    const auto i = static_cast<std::size_t>(k);
    const Part& part = parts_[i];
    const double required = thing.required + part.capsule.radius;
    double least = distance_to_box(seen_from(thing.box, move.axes[i].at(0.5) - thing.box.center), thing.box.half);
    bool clear = least - part.half >= required + far + rounding;
    if (!clear) {
      if (!thing.exact || part.half > 0) least = distance(move.axes[i], number);
      if (least < required - rounding) return Found::touches;
      clear = least >= required + far + rounding ||
              least >= required + half * (move.speed_here(i) + half * bound.acceleration / 2) + rounding;
    }
    if (clear) open.which &= ~bit;
  }
  return open.which == 0 ? Found::clear : Found::open;
}

MoveSieve::Found MoveSieve::look_at_pair(OnMove& move, Open& open, double half, double rounding) const {
  const LinkPair& both = link_pairs_[static_cast<std::size_t>(open.link)];
  const auto first = static_cast<std::size_t>(both.far), second = static_cast<std::size_t>(both.near);
  const MotionBound& bound = move.bounds[links_.size() + static_cast<std::size_t>(open.link)];
  const double far = half * bound.speed, wanted = links_[first].radius + links_[second].radius + far + rounding;
  if ((move.centers[first] - move.centers[second]).squaredNorm() >= wanted * wanted) return Found::clear;
  move.place_parts(both.far);
  move.place_parts(both.near);
  for (int k = both.first; k < both.last; ++k) {
    const std::uint64_t bit = std::uint64_t{1} << (k - both.first);
    if ((open.which & bit) == 0) continue;
    const Pair& pair = pairs_[static_cast<std::size_t>(k)];
    const auto i = static_cast<std::size_t>(pair.far), j = static_cast<std::size_t>(pair.near);
    const double halves = parts_[i].half + parts_[j].half;
    double least = (move.axes[i].at(0.5) - move.axes[j].at(0.5)).norm();
    bool clear = least - halves >= pair.required + far + rounding;
    if (!clear) {
      double s = 0, t = 0;
      if (halves > 0) least = distance_of_segments(move.axes[i], move.axes[j], s, t);
      if (least < pair.required - rounding) return Found::touches;
      clear = least >= pair.required + far + rounding ||
              least >= pair.required + rounding +
                           half * (move.speed_of(i, links_[second].number) + half * bound.acceleration / 2);
    }
    if (clear) open.which &= ~bit;
  }
  return open.which == 0 ? Found::clear : Found::open;
}

bool MoveSieve::passes(const Vector& a, const Vector& b, double rounding, double finest, Pieces& left) const {
  struct Piece {
    double from, to;
    std::size_t first, last;  // of what is open there
  };
  thread_local OnMove move;
  thread_local std::vector<Piece> pieces, halves;
  thread_local std::vector<Open> open, still;
  thread_local std::vector<int> near;
  left.clear();
  open.clear();
  move.sieve = this;
  move.way = b - a;
  move.bounds.clear();
  const Kinematics& kinematics = *robot_->kinematics;
  double farthest = 0;
  const auto add_bound = [&](const Vector& reach, int seen_from) {
    move.bounds.push_back(kinematics.motion(a, b, reach, seen_from));
    farthest = std::max(farthest, move.bounds.back().speed);
  };
  if (tree_ != nullptr) move.go_to(a + 0.5 * move.way);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    add_bound(link.reach, 0);
    if (!link.moves) continue;
    things_near(move, i, rounding, near);
    for (const int o : near) open.push_back({static_cast<int>(i), o, all_of(link.last - link.first)});
  }
  for (std::size_t i = 0; i < link_pairs_.size(); ++i) {
    const LinkPair& both = link_pairs_[i];
    add_bound(both.reach, links_[static_cast<std::size_t>(both.near)].number);
    open.push_back({static_cast<int>(i), -1, all_of(both.last - both.first)});
  }
  thread_local Open met;  // what is in the way of one move is mostly in the way of the next, and looked at first
  const auto is_met = [&](const Open& one) { return one.link == met.link && one.thing == met.thing; };
  const auto known = std::find_if(open.begin(), open.end(), is_met);
  if (known != open.end()) std::swap(*known, open.front());
  if (!std::isfinite(farthest)) {  // nothing is known of places in between
    left.emplace_back(0, 1);
    return true;
  }
  pieces.assign(1, {0, 1, 0, open.size()});
  while (!pieces.empty()) {
    if (pieces.size() > kMostPieces) return false;
    halves.clear();
    still.clear();
    for (const Piece& piece : pieces) {
      const double middle = (piece.from + piece.to) / 2, half = (piece.to - piece.from) / 2;
      move.go_to(a + middle * move.way);
      const std::size_t first = still.size();
      for (std::size_t k = piece.first; k < piece.last; ++k) {
        Open one = open[k];
        const Found found =
            one.thing < 0 ? look_at_pair(move, one, half, rounding) : look_at_thing(move, one, half, rounding);
        if (found == Found::touches) {
          met = one;
          return false;
        }
        if (found == Found::open) still.push_back(one);
      }
      if (still.size() == first) continue;
      if (half * farthest <= finest) {
        if (!left.empty() && left.back().second == piece.from)
          left.back().second = piece.to;
        else
          left.emplace_back(piece.from, piece.to);
        still.resize(first);
        continue;
      }
      halves.push_back({piece.from, middle, first, still.size()});
      halves.push_back({middle, piece.to, first, still.size()});
    }
    pieces.swap(halves);
    open.swap(still);
  }
  return true;
}

}  // namespace leastcost
