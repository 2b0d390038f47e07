// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/tangent_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "framework/domain/in_parts.hpp"

namespace leastcost {
namespace {

using Point2 = Eigen::Vector2d;

constexpr double kTouching = 64 * std::numeric_limits<double>::epsilon();  ///< of the size
constexpr double kEndWithin = 1e-9;  ///< of the size: by so much an end in contact may lie within a disc
constexpr double kWidestArc = 0.1;   ///< radians between two points of a polyline
constexpr int kMostChanges = 1000;   ///< besides ten for each bend

double cross2(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

bool same_round(const Round& a, const Round& b) { return a.center == b.center && a.radius == b.radius; }

/// The angle that differs from `angle` by full turns and is nearest to `known`.
double nearest_turn(double angle, double known) {
  const double full = 2 * std::numbers::pi;
  return angle + full * std::round((known - angle) / full);
}

}  // namespace

/// Adds and removes bends until nothing is left to do.
class TangentPath::Maker {
 public:
  Maker(double size, const HasRounds& made, const Point2& source, const Point2& target, TangentPath& path)
      : made_(made), path_(path) {
    size_ = std::max({size, source.cwiseAbs().maxCoeff(), target.cwiseAbs().maxCoeff()});
    ends_[0].round.center = source;
    ends_[1].round.center = target;
  }

  bool run(const Deadline& deadline) {
    for (std::size_t changes = kMostChanges + 10 * bends().size(); changes > 0; --changes) {
      look_at_clock(deadline);
      if (!draw_legs()) return false;
      if (drop_a_contained_one()) continue;
      measure_turns();
      if (drop_worst_turn()) continue;
      if (!add_what_is_met()) return true;
    }
    return false;
  }

 private:
  std::vector<Bend>& bends() { return path_.bends_; }
  std::vector<Tangent>& legs() { return path_.legs_; }

  /// The i-th disc that the path comes by; the ends are discs without a radius.
  const Bend& stop(std::size_t i) const {
    return i == 0 ? ends_[0] : i > path_.bends_.size() ? ends_[1] : path_.bends_[i - 1];
  }

  /// The tangent from one disc to the next. Where one disc lies within the other there is none; `contained_` is then
  /// the inner one. False where two overlap that it should pass between.
  bool draw_legs() {
    contained_ = 0;
    legs().clear();
    for (std::size_t i = 0; i <= bends().size(); ++i) {
      const Bend &a = stop(i), &b = stop(i + 1);
      const bool ends_here = a.side == 0 || b.side == 0;
      const auto leg = tangent(a.round.center, a.side * a.round.radius, b.round.center, b.side * b.round.radius,
                               (ends_here ? kEndWithin : kTouching) * size_);
      if (!leg) {
        const double distance = (b.round.center - a.round.center).norm();
        const bool nested = std::abs(a.round.radius - b.round.radius) >= distance;
        if (ends_here || !nested) return false;
        contained_ = a.round.radius <= b.round.radius ? i : i + 1;
        return true;
      }
      legs().push_back(*leg);
    }
    return true;
  }

  bool drop_a_contained_one() {
    if (contained_ == 0) return false;
    drop(contained_ - 1);
    return true;
  }

  void drop(std::size_t i) { bends().erase(bends().begin() + static_cast<std::ptrdiff_t>(i)); }

  /// Directions come from the tangents, not from their ends, which coincide where discs touch.
  Point2 direction(std::size_t leg) const {
    const Bend &a = stop(leg), &b = stop(leg + 1);
    const Point2 way = b.round.center - a.round.center;
    const double across = b.side * b.round.radius - a.side * a.round.radius;
    const double along = std::sqrt(std::max(0.0, way.squaredNorm() - across * across));
    return along * way + across * Point2(way.y(), -way.x());
  }

  void measure_turns() {
    Point2 in = direction(0);
    for (std::size_t i = 0; i < bends().size(); ++i) {
      const Point2 out = direction(i + 1);
      bends()[i].turn = nearest_turn(turn_between(in, out), bends()[i].turn);
      in = out;
    }
  }

  bool drop_worst_turn() {
    std::size_t worst = 0;
    double least = 0;
    bool found = false;
    for (std::size_t i = 0; i < bends().size(); ++i) {
      const double turn = bends()[i].side * bends()[i].turn;
      if (turn > least) continue;
      least = turn;
      worst = i;
      found = true;
    }
    if (found) drop(worst);
    return found;
  }

  /// The disc that a leg comes into deepest becomes a bend, leg by leg.
  bool add_what_is_met() {
    bool added = false;
    for (std::size_t i = legs().size(); i-- > 0;) {
      const std::optional<Round> met = deepest(i);
      if (!met) continue;
      const int side = cross2(legs()[i].to - legs()[i].from, met->center - legs()[i].from) > 0 ? 1 : -1;
      bends().insert(bends().begin() + static_cast<std::ptrdiff_t>(i), {*met, side, 0});
      added = true;
    }
    return added;
  }

  std::optional<Round> deepest(std::size_t leg) {
    const auto& [from, to] = legs()[leg];
    Eigen::AlignedBox2d box(from);
    box.extend(to);
    std::optional<Round> deepest;
    double depth = kTouching * size_;
    const Point2 way = to - from;
    const double square = way.squaredNorm();
    for (const Round& round : made_.rounds(box)) {
      if (same_round(round, stop(leg).round) || same_round(round, stop(leg + 1).round)) continue;
      const double t = square > 0 ? std::clamp((round.center - from).dot(way) / square, 0.0, 1.0) : 0;
      const double within = round.radius - (from + t * way - round.center).norm();
      if (within <= depth) continue;
      depth = within;
      deepest = round;
    }
    return deepest;
  }

  const HasRounds& made_;
  TangentPath& path_;
  double size_;
  Bend ends_[2];
  std::size_t contained_ = 0;  ///< number of a stop, 0: none
};

std::optional<TangentPath> TangentPath::make(const Walls& walls, const Point2& source, const Point2& target,
                                             std::vector<Bend> bends, const Deadline& deadline) {
  TangentPath path;
  path.bends_ = std::move(bends);
  const auto* made = find_ability<HasRounds>(walls);
  if (made == nullptr || !Maker(walls.size(), *made, source, target, path).run(deadline)) return std::nullopt;
  return path;
}

double TangentPath::length() const {
  double length = 0;
  for (const Tangent& leg : legs_) length += (leg.to - leg.from).norm();
  for (const Bend& bend : bends_) length += bend.round.radius * std::abs(bend.turn);
  return length;
}

/// Tangents to a circle at angles that differ by d meet at r / cos(d / 2), and are longer than the arc by r d^3 / 12.
Points TangentPath::polyline(double excess) const {
  double arcs = 0;
  for (const Bend& bend : bends_) arcs += bend.round.radius * std::abs(bend.turn);
  const double widest = arcs > 0 ? std::min(kWidestArc, std::sqrt(12 * excess * length() / arcs)) : kWidestArc;
  std::vector<Point2> points = {legs_.front().from};
  for (std::size_t i = 0; i < bends_.size(); ++i) {
    const Bend& bend = bends_[i];
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(bend.turn) / widest)));
    const double step = bend.turn / parts, far = 1 / std::cos(step / 2);
    const Point2 from_center = legs_[i].to - bend.round.center;
    for (int k = 0; k < parts; ++k)
      points.emplace_back(bend.round.center + far * (Eigen::Rotation2Dd((k + 0.5) * step) * from_center));
  }
  points.push_back(legs_.back().to);
  Points columns(2, static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index i = 0; i < columns.cols(); ++i) columns.col(i) = points[static_cast<std::size_t>(i)];
  return columns;
}

}  // namespace leastcost
