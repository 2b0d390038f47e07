// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/tight_string.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "problems/taut/string_program.hpp"

namespace leastcost {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double kSoDeep = 1e-10;     ///< of the length: an end may be so deep in a clearance, for rounding
constexpr double kContactGap = 1e-7;  ///< of the length: a side so near to an obstacle touches it
constexpr double kOfCoordinate = 64 * std::numeric_limits<double>::epsilon();  ///< of coordinates
constexpr double kShortestSide = 1e-9;                                         ///< of the length
constexpr double kKept = 4e-12;  ///< of the length, from planes: more than what the program may be off by
constexpr int kFirstSides = 12;  ///< of a string, before it is split where it bends
constexpr Index kMostSides = 3000;
constexpr int kMostPulls = 400;  ///< with the same number of sides
constexpr int kMostSplits = 14;

double string_length(const Points& x) {
  return (x.rightCols(x.cols() - 1) - x.leftCols(x.cols() - 1)).colwise().norm().sum();
}

/// A string with small forces on it gives way until the changes of its tension balance them: half of their squares,
/// summed along it, is gained.
class Tension {
 public:
  void push(const Vector3d& force) { force_ += force; }
  void run(double side) {
    length_ += side;
    squares_ += side * force_.squaredNorm();
    sum_ += side * force_;
  }
  double gain() const { return length_ > 0 ? std::max(0.0, squares_ - sum_.squaredNorm() / length_) / 2 : 0; }

 private:
  Vector3d force_ = Vector3d::Zero(), sum_ = Vector3d::Zero();
  double length_ = 0, squares_ = 0;
};

/// How obstacles hold a bend.
struct Held {
  Vector3d left;     ///< the part of it that no push against the planes makes
  double slack = 0;  ///< what the string would gain if it came up to the planes that it leans on: push times gap
};

/// Of pushes against at most three planes, which make any vector that can be made, those that leave the least: the part
/// that is left counts by the way that the vertex has.
Held hold(const Vector3d& bend, double way, const std::vector<SupportPlane>& planes) {
  Held best{bend, 0};
  std::vector<const SupportPlane*> by;
  const auto look = [&](auto& self, std::size_t next) -> void {
    if (!by.empty()) {
      Points normals(3, static_cast<Index>(by.size()));
      for (Index k = 0; k < normals.cols(); ++k) normals.col(k) = by[static_cast<std::size_t>(k)]->normal;
      const Eigen::VectorXd pushes = normals.colPivHouseholderQr().solve(bend);
      if (pushes.minCoeff() < 0) return;  // a larger set with this one in it may still do, but so does one without
      Held held{bend - normals * pushes, 0};
      for (Index k = 0; k < pushes.size(); ++k)
        held.slack += pushes[k] * std::max(0.0, by[static_cast<std::size_t>(k)]->gap);
      if (held.left.norm() * way + held.slack < best.left.norm() * way + best.slack) best = held;
    }
    if (by.size() == 3) return;
    for (std::size_t k = next; k < planes.size(); ++k) {
      by.push_back(&planes[k]);
      self(self, k + 1);
      by.pop_back();
    }
  };
  look(look, 0);
  return best;
}

class Pulled {
 public:
  Pulled(const Walls& walls, Points start, const Monitor& monitor)
      : walls_(walls), monitor_(monitor), x_(std::move(start)), unit_(string_length(x_)) {}

  const Points& polyline() const { return x_; }
  double length() const { return string_length(x_); }
  bool failed() const { return failed_; }

  /// Leaves out vertices that a straight move can do without, and splits what is left into sides of equal length.
  void straighten() {
    std::vector<Index> kept = {0};
    for (Index from = 0; from + 1 < x_.cols();) {
      look_at_clock(monitor_.deadline);
      Index to = x_.cols() - 1;
      while (to > from + 1 && !is_clear(x_.col(from), x_.col(to))) to = from + std::max<Index>(1, (to - from) / 2);
      kept.push_back(from = to);
    }
    const Points corners = x_(Eigen::all, kept);
    const double longest = string_length(corners) / kFirstSides;
    split([&](Index i) { return static_cast<int>(std::ceil((corners.col(i + 1) - corners.col(i)).norm() / longest)); },
          corners);
  }

  /// Until a pull shortens it by less than `least`, of its length, twice.
  void pull_tight(double least) {
    constexpr int kCalm = 2;  // pulls in a row that bring little
    double before = length();
    for (int calm = 0, k = 0; k < kMostPulls && calm < kCalm && !failed_; ++k) {
      pull({});
      const double now = length();
      calm = before - now <= least * now ? calm + 1 : 0;
      before = now;
    }
    drop_short_sides();
  }

  void take(const Pulled& other) { x_ = other.x_; }

  /// One solution between the planes of where it is now.
  void pull(const Matrix3Xd& aside) {
    look_at_clock(monitor_.deadline);
    const Vector3d origin = x_.col(0);
    const double reach = reach_of_pull();
    std::vector<HalfSpace> half_spaces;
    for (Index i = 0; i + 1 < x_.cols() && !failed_; ++i) {
      failed_ = !walls_.planes(x_.col(i), x_.col(i + 1), reach, found_);
      for (const SupportPlane& plane : found_)
        for (const Index vertex : {i, i + 1})
          if (vertex > 0 && vertex + 1 < x_.cols())
            half_spaces.push_back({vertex, plane.normal, (plane.offset - plane.normal.dot(origin)) / unit_ + kKept});
    }
    if (failed_) return;
    const Matrix3Xd scaled = (x_.colwise() - origin) / unit_;
    Eigen::VectorXd rest = (scaled.rightCols(x_.cols() - 1) - scaled.leftCols(x_.cols() - 1)).colwise().norm();
    rest = rest.cwiseMax(kShortestSide);
    const Matrix3Xd way = least_stretched(scaled, rest, half_spaces, aside) - scaled;
    const double farthest = unit_ * way.colwise().norm().maxCoeff();
    const double share = farthest > reach ? reach / farthest : 1;  // what is farther away was not asked for
    x_.middleCols(1, x_.cols() - 2) += share * unit_ * way.middleCols(1, x_.cols() - 2);
  }

  /// Sides that end at a bend whose part of the excess is above `most` become two. False: there are none.
  bool split_bends(double most) {
    const std::vector<double> parts = excess_parts();
    std::vector<char> bent(parts.size(), 0);
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i] > most) bent[i] = bent[std::max<std::size_t>(i, 1) - 1] = 1;  // the sides i - 1 and i of vertex i
    if (std::find(bent.begin(), bent.end(), 1) == bent.end() || x_.cols() > kMostSides) return false;
    const Points old = x_;
    split([&](Index i) { return bent[static_cast<std::size_t>(i)] != 0 ? 2 : 1; }, old);
    return true;
  }

  double excess() const {
    double sum = 0;
    for (const double part : excess_parts()) sum += part;
    return sum;
  }
  long bends() const {
    const std::vector<double> parts = excess_parts();
    return std::max<long>(1, std::count_if(parts.begin(), parts.end(), [](double part) { return part > 0; }));
  }

  bool clear() const {
    for (Index i = 0; i + 1 < x_.cols(); ++i)
      if (!is_clear(x_.col(i), x_.col(i + 1))) return false;
    return true;
  }

 private:
  bool is_clear(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    const MoveClearance clearance = walls_.clearance(a, b);
    return clearance.obstacle < 0 || clearance.upper >= -kSoDeep * unit_;
  }

  /// How far a vertex may go at once: all obstacles that are so near have a plane.
  double reach_of_pull() const { return unit_ / kFirstSides; }

  template <class Parts>
  void split(Parts parts_of, const Points& corners) {
    std::vector<Eigen::VectorXd> points = {corners.col(0)};
    for (Index i = 0; i + 1 < corners.cols(); ++i) {
      const int parts = std::max(1, parts_of(i));
      for (int k = 1; k < parts; ++k)
        points.emplace_back(corners.col(i) + static_cast<double>(k) / parts * (corners.col(i + 1) - corners.col(i)));
      points.emplace_back(corners.col(i + 1));
    }
    x_.resize(3, static_cast<Index>(points.size()));
    for (Index i = 0; i < x_.cols(); ++i) x_.col(i) = points[static_cast<std::size_t>(i)];
  }

  /// A vertex that has come to lie on its neighbour says nothing.
  void drop_short_sides() {
    std::vector<Index> kept = {0};
    for (Index i = 1; i + 1 < x_.cols(); ++i)
      if ((x_.col(i) - x_.col(kept.back())).norm() > kShortestSide * unit_ &&
          (x_.col(i) - x_.col(x_.cols() - 1)).norm() > kShortestSide * unit_)
        kept.push_back(i);
    kept.push_back(x_.cols() - 1);
    if (static_cast<Index>(kept.size()) < x_.cols()) x_ = Points(x_(Eigen::all, kept));
  }

  /// Of a side that touches, the place nearest to one of its ends where it does; else its other end.
  Vector3d touch_near(Index side, bool at_end) const {
    const Vector3d a = x_.col(side), b = x_.col(side + 1);
    std::vector<SupportPlane> found;
    Vector3d nearest = at_end ? a : b;
    if (!walls_.planes(a, b, kContactGap * unit_, found)) return nearest;
    const Vector3d end = at_end ? b : a;
    for (const SupportPlane& plane : found)
      if ((plane.place - end).norm() < (nearest - end).norm()) nearest = plane.place;
    return nearest;
  }

  /// For each vertex: how much longer the way over it is than the straight one between where its sides touch.
  std::vector<double> excess_parts() const {
    std::vector<double> parts(static_cast<std::size_t>(x_.cols()), 0.0);
    for (Index i = 1; i + 1 < x_.cols(); ++i) {
      const Vector3d corner = x_.col(i), in = corner - x_.col(i - 1), out = x_.col(i + 1) - corner;
      if (in.cross(out).norm() <= kOfCoordinate * in.norm() * out.norm()) continue;
      const Vector3d before = touch_near(i - 1, true), after = touch_near(i, false);
      parts[static_cast<std::size_t>(i)] =
          std::max(0.0, (corner - before).norm() + (after - corner).norm() - (after - before).norm());
    }
    return parts;
  }

  const Walls& walls_;
  const Monitor& monitor_;
  Points x_;
  double unit_;  ///< the length that it began with
  bool failed_ = false;
  std::vector<SupportPlane> found_;
};

/// Pulls in a direction of its own at every vertex, the same in all runs.
Matrix3Xd aside(Index vertices, int turn) {
  constexpr double kStrong = 0.3;  // of the tension
  Matrix3Xd pulls(3, vertices);
  for (Index i = 0; i < vertices; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(std::max<Index>(1, vertices - 1));
    pulls.col(i) = kStrong / static_cast<double>(vertices) * 4 *
                   Vector3d(std::sin(3 * t + turn), std::cos(5 * t + 2 * turn), std::sin(7 * t + 3 * turn + 1));
  }
  return pulls;
}

/// Coarse strings are cheap: this is where it is pulled aside.
void settle_coarsely(Pulled& string, const Monitor& monitor, const Walls& walls) {
  constexpr double kRoughly = 1e-5;
  string.pull_tight(kRoughly);
  for (int turn = 0; turn < 2 && !string.failed(); ++turn) {
    Pulled other(walls, string.polyline(), monitor);
    other.pull(aside(other.polyline().cols(), turn));
    other.pull_tight(kRoughly);
    if (!other.failed() && other.length() < (1 - kRoughly) * string.length()) string.take(other);
  }
}

}  // namespace

std::optional<TightString> tight_string(const Walls& walls, const Points& start, double excess,
                                        const Monitor& monitor) {
  constexpr double kNearly = 0.1, kFully = 1e-3;  // of the excess
  constexpr double kSafety = 2, kMostPace = 0.999;
  if (walls.dimension() != 3 || start.cols() < 2 || !(string_length(start) > 0)) return std::nullopt;
  Pulled string(walls, start, monitor);
  if (!string.clear()) return std::nullopt;
  string.straighten();
  settle_coarsely(string, monitor, walls);
  for (int k = 0; k < kMostSplits && !string.failed(); ++k) {
    string.pull_tight(kNearly * excess);
    const double allowed = excess * string.length();
    if (string.excess() <= allowed / 2 || !string.split_bends(allowed / 2 / static_cast<double>(string.bends()))) break;
  }
  string.pull_tight(kFully * excess);
  if (string.failed()) return std::nullopt;
  // How fast what is still unheld to the side goes away says how little the roundness of obstacles leaves to hold it.
  const double before = unheld_bends(walls, string.polyline()).sideways;
  string.pull({});
  const Unheld unheld = unheld_bends(walls, string.polyline());
  const bool told = unheld.sideways > kOfCoordinate * string.length();
  const double pace = told ? std::min(kMostPace, before > 0 ? std::sqrt(unheld.sideways / before) : 1.0) : 0;
  const double gain = kSafety * (unheld.gain + unheld.sideways / (1 - pace));
  return TightString{string.polyline(), string.length(), string.excess() + gain};
}

Unheld unheld_bends(const Walls& walls, const Points& polyline) {
  constexpr double kBeside = 1e-3;  // of the length: what a string may lean on
  Unheld all;
  const double length = string_length(polyline);
  std::vector<SupportPlane> after, before;
  Tension all_left, to_the_side;
  for (Index i = 0; i + 1 < polyline.cols(); ++i) {
    const Vector3d out = polyline.col(i + 1) - polyline.col(i);
    std::swap(before, after);
    walls.planes(polyline.col(i), polyline.col(i + 1), kBeside * length, after);
    if (i > 0) {
      const Vector3d in = polyline.col(i) - polyline.col(i - 1), side = in.cross(out).normalized();
      before.insert(before.end(), after.begin(), after.end());
      const Held held = hold(in.normalized() - out.normalized(), std::min(in.norm(), out.norm()), before);
      all.largest = std::max(all.largest, held.left.norm());
      all.gain += held.slack;
      all_left.push(held.left);
      to_the_side.push(side.dot(held.left) * side);
    }
    all_left.run(out.norm());
    to_the_side.run(out.norm());
  }
  all.gain += all_left.gain();
  all.sideways = to_the_side.gain();
  return all;
}

}  // namespace leastcost
