// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/pulled_string.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/taut/string_program.hpp"

namespace leastcost {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double kSoDeep = 1e-10;       ///< of the length: an end may be so deep in a clearance, for rounding
constexpr double kSlidDeep = 1e-11;     ///< of the length: and what slides
constexpr double kContactGap = 1e-7;    ///< of the length: a side so near to an obstacle touches it
constexpr double kShortestSide = 1e-9;  ///< of the length
constexpr double kKept = 4e-12;         ///< of the length, from planes: more than what the program may be off by
constexpr int kFirstSides = 12;
constexpr int kMostPulls = 400;  ///< with the same number of sides

Points columns_of(const std::vector<Vector3d>& points) {
  Points columns(3, static_cast<Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) columns.col(static_cast<Index>(i)) = points[i];
  return columns;
}

/// The largest of [0, 1] that is allowed, to a millionth, if all below an allowed one are.
template <class Allowed>
double largest_share(Allowed allowed) {
  constexpr int kHalvings = 20;
  if (allowed(1.0)) return 1;
  double share = 0, step = 0.5;
  for (int k = 0; k < kHalvings; ++k, step /= 2)
    if (allowed(share + step)) share += step;
  return share;
}

}  // namespace

/// Where a side touches obstacles: first and last on its way.
struct PulledString::Touch {
  Vector3d first, last;
  int first_obstacle, last_obstacle;
};

/// The string between two places where it touches something, or its ends.
struct PulledString::Stretch {
  double excess = 0;              ///< how much longer it is than the straight way
  Index before_side, after_side;  ///< that these places are on; -1: an end
  Vector3d from, to;
  bool round = false;  ///< both places on one obstacle
};

PulledString::PulledString(const Walls& walls, Points start, const Monitor& monitor)
    : walls_(walls),
      convex_(find_ability<HasSupportPlanes>(walls)),
      monitor_(monitor),
      x_(std::move(start)),
      unit_(polyline_length(x_)) {}

/// But for `depth`, of the length.
bool PulledString::is_clear(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double depth) const {
  const MoveClearance clearance = walls_.clearance(a, b);
  return clearance.obstacle < 0 || clearance.upper >= -depth * unit_;
}

bool PulledString::clear() const {
  for (Index i = 0; i + 1 < x_.cols(); ++i)
    if (!is_clear(x_.col(i), x_.col(i + 1), kSoDeep)) return false;
  return true;
}

void PulledString::straighten() {
  std::vector<Vector3d> kept = {x_.col(0)};
  for (Index from = 0; from + 1 < x_.cols();) {
    look_at_clock(monitor_.deadline);
    Index to = x_.cols() - 1;
    while (to > from + 1 && !is_clear(x_.col(from), x_.col(to), kSoDeep))
      to = from + std::max<Index>(1, (to - from) / 2);
    kept.emplace_back(x_.col(from = to));
  }
  const double longest = polyline_length(columns_of(kept)) / kFirstSides;
  std::vector<Vector3d> split = {kept.front()};
  for (std::size_t i = 1; i < kept.size(); ++i) {
    const Vector3d side = kept[i] - kept[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(side.norm() / longest)));
    for (int k = 1; k <= parts; ++k)
      split.emplace_back(k < parts ? Vector3d(kept[i - 1] + static_cast<double>(k) / parts * side) : kept[i]);
  }
  x_ = columns_of(split);
}

void PulledString::pull(const Matrix3Xd& forces) {
  look_at_clock(monitor_.deadline);
  const Vector3d origin = x_.col(0);
  const double reach = unit_ / kFirstSides;  // what is farther away has no plane
  std::vector<SupportPlane> planes;
  std::vector<HalfSpace> half_spaces;
  for (Index i = 0; i + 1 < x_.cols() && !failed_; ++i) {
    failed_ = convex_ == nullptr || !convex_->planes(x_.col(i), x_.col(i + 1), reach, planes);
    for (const SupportPlane& plane : planes)
      for (const Index vertex : {i, i + 1})
        if (vertex > 0 && vertex + 1 < x_.cols())
          half_spaces.push_back({vertex, plane.normal, (plane.offset - plane.normal.dot(origin)) / unit_ + kKept});
  }
  if (failed_) return;
  const Matrix3Xd scaled = (x_.colwise() - origin) / unit_;
  Eigen::VectorXd rest = (scaled.rightCols(x_.cols() - 1) - scaled.leftCols(x_.cols() - 1)).colwise().norm();
  rest = rest.cwiseMax(kShortestSide);
  const Matrix3Xd way = least_stretched(scaled, rest, half_spaces, forces) - scaled;
  const double farthest = unit_ * way.colwise().norm().maxCoeff();
  const double share = farthest > reach ? reach / farthest : 1;
  x_.middleCols(1, x_.cols() - 2) += share * unit_ * way.middleCols(1, x_.cols() - 2);
}

void PulledString::pull_tight(double least) {
  constexpr int kCalm = 2;  // pulls in a row that bring little
  constexpr double kSlow = 0.7, kFarthest = 1e4, kLessAfterFailure = 0.25;
  double before = length(), gain_before = 0, most_times = kFarthest;
  for (int calm = 0, k = 0; k < kMostPulls && calm < kCalm && !failed_; ++k) {
    const Points old = x_;
    pull();
    const double now = length(), gain = before - now, ratio = gain_before > 0 ? gain / gain_before : 0;
    const double to_come = ratio < 1 ? std::min(kFarthest, 1 / (1 - std::max(0.0, ratio))) : kFarthest;
    calm = gain * to_come <= least * now ? calm + 1 : 0;
    before = now;
    gain_before = gain;
    if (calm > 0 || ratio < kSlow || ratio >= 1) continue;
    const double times = std::min(most_times, 1 / (1 - std::sqrt(ratio)));
    if (leap(x_ - old, times)) {
      before = length();
      gain_before = 0;
      most_times = kFarthest;
    } else {
      most_times = kLessAfterFailure * times;
    }
  }
  drop_short_sides();
}

/// Goes on by so many times a step, and pulls there. False: it is not shorter there, or not clear; it stays here.
bool PulledString::leap(const Points& step, double times) {
  constexpr double kTooFar = 0.02;  // of the length
  const Points here = x_;
  const double shortest = length(), farthest = step.colwise().norm().maxCoeff();
  x_ += std::min(times, kTooFar * unit_ / farthest) * step;
  pull();
  if (!failed_ && length() < shortest && clear()) return true;
  x_ = here;
  failed_ = false;
  return false;
}

std::optional<PulledString::Touch> PulledString::touches(Index side) const {
  std::vector<SupportPlane> planes;
  if (convex_ != nullptr) convex_->planes(x_.col(side), x_.col(side + 1), kContactGap * unit_, planes);
  if (planes.empty()) return std::nullopt;
  const auto nearer = [from = Vector3d(x_.col(side))](const SupportPlane& a, const SupportPlane& b) {
    return (a.place - from).norm() < (b.place - from).norm();
  };
  const auto [first, last] = std::minmax_element(planes.begin(), planes.end(), nearer);
  return Touch{first->place, last->place, first->obstacle, last->obstacle};
}

/// Every vertex but the ends is in one of them, in order; those within a side have none.
std::vector<PulledString::Stretch> PulledString::stretches() const {
  std::vector<Stretch> all;
  const Index sides = x_.cols() - 1;
  Touch from{x_.col(0), x_.col(0), -1, -1};
  double way = 0;
  Index before = -1;
  for (Index side = 0; side < sides; ++side) {
    const Vector3d a = x_.col(side), b = x_.col(side + 1);
    if (const std::optional<Touch> touch = touches(side)) {
      const double excess = way + (touch->first - a).norm() - (touch->first - from.last).norm();
      all.push_back({excess, before, side, from.last, touch->first, touch->first_obstacle == from.last_obstacle});
      all.push_back({0, side, side, touch->first, touch->last, touch->first_obstacle == touch->last_obstacle});
      from = *touch;
      before = side;
      way = (b - touch->last).norm();
    } else {
      way += (b - a).norm();
    }
  }
  const Vector3d end = x_.col(sides);
  all.push_back({way - (end - from.last).norm(), before, -1, from.last, end, false});
  return all;
}

double PulledString::excess() const {
  double sum = 0;
  for (const Stretch& stretch : stretches()) sum += std::max(0.0, stretch.excess);
  return sum;
}

void PulledString::cut_short(double share) {
  const std::vector<Stretch> all = stretches();
  double least = 0;
  for (const Stretch& stretch : all) least += share * std::max(0.0, stretch.excess) / static_cast<double>(all.size());
  std::vector<Vector3d> cut = {x_.col(0)};
  for (const Stretch& stretch : all) {
    look_at_clock(monitor_.deadline);
    const Index first = std::max<Index>(1, stretch.before_side + 1);
    const Index last = stretch.after_side < 0 ? x_.cols() - 2 : stretch.after_side;
    const bool has_vertices = first <= last;
    Vector3d u = has_vertices ? Vector3d(x_.col(first)) : stretch.from;
    Vector3d v = has_vertices ? Vector3d(x_.col(last)) : stretch.to;
    if (has_vertices && (stretch.excess <= least || !is_clear(u, v, kSlidDeep))) {
      for (Index i = first; i <= last; ++i) cut.emplace_back(x_.col(i));
      continue;
    }
    if (has_vertices) {
      slide(u, v, stretch, first == last);
      cut.push_back(u);
    }
    if (!stretch.round)
      for (const double third : {1.0 / 3, 2.0 / 3}) cut.emplace_back(u + third * (v - u));
    if (has_vertices) cut.push_back(v);
  }
  cut.emplace_back(x_.col(x_.cols() - 1));
  x_ = columns_of(cut);
  drop_short_sides();
}

/// The ends of the part of a stretch that touches nothing, towards the places that it is between.
void PulledString::slide(Vector3d& u, Vector3d& v, const Stretch& stretch, bool one_corner) const {
  const Vector3d a = u, b = v, to_from = stretch.from - u, to_next = stretch.to - v;
  if (one_corner) {
    const double both = largest_share([&](double t) { return is_clear(a + t * to_from, b + t * to_next, kSlidDeep); });
    u += both * to_from;
    v += both * to_next;
    return;
  }
  v += largest_share([&](double t) { return is_clear(a, b + t * to_next, kSlidDeep); }) * to_next;
  u += largest_share([&](double t) { return is_clear(a + t * to_from, v, kSlidDeep); }) * to_from;
}

/// A vertex that has come to lie on its neighbour says nothing.
void PulledString::drop_short_sides() {
  std::vector<Index> kept = {0};
  for (Index i = 1; i + 1 < x_.cols(); ++i)
    if ((x_.col(i) - x_.col(kept.back())).norm() > kShortestSide * unit_ &&
        (x_.col(i) - x_.col(x_.cols() - 1)).norm() > kShortestSide * unit_)
      kept.push_back(i);
  kept.push_back(x_.cols() - 1);
  if (static_cast<Index>(kept.size()) < x_.cols()) x_ = Points(x_(Eigen::all, kept));
}

}  // namespace leastcost
