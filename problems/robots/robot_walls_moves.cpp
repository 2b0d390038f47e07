// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/robots/robot_walls_moves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <utility>

#include "problems/robots/least_value.hpp"
#include "problems/robots/move_sieve.hpp"
#include "problems/robots/robot_walls_parts.hpp"

// RobotWalls: what is near a place, on a move, and on those of a chain.

namespace leastcost {
using robot_walls::kDecided, robot_walls::kShareOfGap, robot_walls::kUnbounded;
namespace {

constexpr double kShareOfCoreRoom = 0.5;
constexpr int kFewestPlaces = 4, kMostPlaces = 64;    ///< of a move that are looked at before its least gap is followed
constexpr double kFollowed = 1e-12, kNearest = 1e-3;  // sizes: how closely that is; at least, of the move
constexpr double kPlacesApart = 0.5;                  ///< of what is required: how far a part goes between them

/// Places of one move, for pairs that are looked at there one after another: links are placed once for all of them.
class PlacesOfMove {
 public:
  void begin() { count_ = next_ = 0; }
  template <class Place>
  RobotPose& at(const Robot& robot, double t, const Place& place) {
    for (std::size_t i = 0; i < count_; ++i)
      if (times_[i] == t) return poses_[i];
    const std::size_t i = count_ < kKept ? count_++ : kFirst + next_++ % (kKept - kFirst);
    times_[i] = t;
    poses_[i].place_links(robot, place(t));
    return poses_[i];
  }

 private:
  static constexpr std::size_t kKept = 8, kFirst = 6;  ///< the first are those that all pairs are looked at
  std::array<double, kKept> times_ = {};
  std::array<RobotPose, kKept> poses_;
  std::size_t count_ = 0, next_ = 0;
};

}  // namespace

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
    const Vector farthest = Vector::Constant(x.rows(), x.cwiseAbs().maxCoeff());
    rounding_ = walls.rounding(farthest, farthest);
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
    constexpr Eigen::Index kAtFirst = 13;  // pieces: longer ones are split anyway
    const Eigen::Index moves = x_.cols() - 1, each = (moves + kAtFirst - 1) / kAtFirst;
    for (Eigen::Index first = 0; first < moves; first += each) add(first, std::min(first + each, moves));
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
  thread_local PlacesOfMove places_of_move;
  places_of_move.begin();
  for (const Pair& pair : pairs) {
    const auto distance_at = [&](double t) {
      RobotPose& pose = places_of_move.at(*robot_, t, [&](double s) { return move.place(s); });
      pose.place_part(*robot_, static_cast<std::size_t>(pair.part));
      if (pair.self) pose.place_part(*robot_, static_cast<std::size_t>(pair.other));
      return between(pose, pair).distance;
    };
    const MotionBound bound = move.bound(pair);
    const MovingDistance known{bound.speed, bound.acceleration};
    const double speed = bound.speed, wanted = pair.required + reach * pair.steepest;
    const double middle = distance_at(kMiddle);
    if (middle - speed / 2 >= wanted) continue;
    if (least_distance_on_piece(known, kMiddle, distance_at(0), middle) >= wanted &&
        least_distance_on_piece(known, kMiddle, middle, distance_at(1)) >= wanted)
      continue;
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

}  // namespace leastcost
