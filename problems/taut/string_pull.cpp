// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/string_pull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "framework/domain/in_parts.hpp"

namespace leastcost {
namespace {

using Point2 = Eigen::Vector2d;

constexpr int kPointsOfCircle = 64;
constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();
constexpr std::size_t kMostCuts = 200000;  ///< beyond those that a corner each needs

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A corner of the path: where it was given, or on the circle of a disc.
struct Corner {
  Point2 at;
  std::optional<Round> round;
};

/// Pulls from the first corner to the last: what lies before `at_` is tight, as far as its own triangles go.
class StringPull {
 public:
  StringPull(double size, const HasRounds& made, const Points& start) : made_(made) {
    for (Eigen::Index i = 0; i < start.cols(); ++i) path_.push_back({start.col(i), std::nullopt});
    size_ = std::max(size, start.cwiseAbs().maxCoeff());
  }

  bool run(const Deadline& deadline) {
    std::size_t cuts = kMostCuts + 10 * path_.size();
    // Looked at from the back, a corner and the two beside it; what is tight goes over to the other pile.
    std::vector<Corner> rest(path_.rbegin(), path_.rend());
    path_.clear();
    path_.push_back(rest.back());
    rest.pop_back();
    while (rest.size() > 1) {
      if (cuts-- == 0) return false;
      if (cuts % 64 == 0) look_at_clock(deadline);
      const Corner corner = rest.back();
      rest.pop_back();
      const std::optional<std::vector<Corner>> hull = cut(path_.back(), corner, rest.back());
      if (!hull) {
        path_.push_back(corner);
        continue;
      }
      rest.insert(rest.end(), hull->rbegin(), hull->rend());
      if (path_.size() > 1) {  // the one before has another neighbour now
        rest.push_back(path_.back());
        path_.pop_back();
      }
    }
    path_.push_back(rest.back());
    return true;
  }

  /// Nothing where a corner is left that no disc holds.
  std::optional<std::vector<Bend>> bends() const {
    std::vector<Bend> bends;
    for (std::size_t i = 1; i + 1 < path_.size(); ++i) {
      const Corner& corner = path_[i];
      if (!corner.round) return std::nullopt;
      const Point2 in = corner.at - path_[i - 1].at, out = path_[i + 1].at - corner.at;
      const double turn = std::atan2(cross(in, out), in.dot(out));
      const int side = turn > 0 ? 1 : -1;
      const bool goes_on = !bends.empty() && bends.back().side == side && same(bends.back().round, *corner.round);
      if (!goes_on) bends.push_back({*corner.round, side, 0});
      bends.back().turn += turn;
    }
    return bends;
  }

 private:
  static bool same(const Round& a, const Round& b) {
    return a.obstacle == b.obstacle && a.center == b.center && a.radius == b.radius;
  }

  /// What takes the place of p between a and b: the hull of what stands in their triangle; nothing if p stays.
  std::optional<std::vector<Corner>> cut(const Corner& a, const Corner& p, const Corner& b) {
    const Point2 in = p.at - a.at, out = b.at - p.at;
    const double area = cross(in, out), turn = area > 0 ? 1 : -1;
    if (std::abs(area) <= none(std::max(in.norm(), out.norm()))) return std::vector<Corner>{};
    if (p.round) {
      const Point2 to_center = p.round->center - p.at;
      if (turn * cross(in, to_center) > 0 && turn * cross(out, to_center) > 0) return std::nullopt;  // it is held
    }
    std::vector<Corner> inside = standing_in(a.at, p.at, b.at, turn);
    std::vector<Corner> hull;
    Point2 from = a.at;
    for (std::size_t k = 0; k <= inside.size(); ++k) {  // gift wrapping
      const Corner* next = &b;
      for (const Corner& point : inside) {
        if (point.at == from) continue;
        const double side = turn * cross(next->at - from, point.at - from);
        const bool farther = (point.at - from).squaredNorm() > (next->at - from).squaredNorm();
        if (side < 0 || (side == 0 && next != &b && farther)) next = &point;
      }
      if (next == &b) break;
      hull.push_back(*next);
      from = next->at;
    }
    return hull;
  }

  /// An area beside a side of the given length that is none.
  double none(double side) const { return kRounding * size_ * side; }

  /// Points of circles in a triangle, on its edges a-p and p-b as well, but not on a-b.
  std::vector<Corner> standing_in(const Point2& a, const Point2& p, const Point2& b, double turn) {
    Eigen::AlignedBox2d box(a);
    box.extend(p);
    box.extend(b);
    std::vector<Corner> inside;
    const double of_in = none((p - a).norm()), of_out = none((b - p).norm()), of_cut = none((b - a).norm());
    for (const Round& round : made_.rounds(box)) {
      if (box.exteriorDistance(round.center) > round.radius) continue;
      for (int k = 0; k < kPointsOfCircle; ++k) {
        const double angle = 2 * std::numbers::pi * k / kPointsOfCircle;
        const Point2 at = round.center + round.radius * Point2(std::cos(angle), std::sin(angle));
        if (at == p) continue;  // of a disc that does not hold it
        if (turn * cross(p - a, at - a) >= -of_in && turn * cross(b - p, at - p) >= -of_out &&
            turn * cross(b - a, at - a) < -of_cut)
          inside.push_back({at, round});
      }
    }
    return inside;
  }

  const HasRounds& made_;
  std::vector<Corner> path_;
  double size_ = 0;  ///< of the scene
};

}  // namespace

std::optional<std::vector<Bend>> pull_string(const Walls& walls, const Points& start, const Deadline& deadline) {
  const auto* made = find_ability<HasRounds>(walls);
  if (made == nullptr) return std::nullopt;
  StringPull string(walls.size(), *made, start);
  if (!string.run(deadline)) return std::nullopt;
  return string.bends();
}

}  // namespace leastcost
