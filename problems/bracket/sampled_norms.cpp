// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/sampled_norms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "problems/bracket/cubic_minimum.hpp"

namespace leastcost::bracket {
namespace {

using Eigen::Vector2d;

constexpr double kStep = 2 * std::numbers::pi / SampledNorms::kDirections;

/// Where the parabola through three values, a step apart, is largest, in steps from the middle one; within one half
/// where that is the largest of the three.
double vertex(double before, double middle, double after) {
  const double bend = 2 * middle - before - after;
  return bend > 0 ? std::clamp(0.5 * (after - before) / bend, -1.0, 1.0) : 0;
}

}  // namespace

Vector2d SampledNorms::direction(int k) {
  static const std::array<Vector2d, kDirections> all = [] {
    std::array<Vector2d, kDirections> out;
    for (int i = 0; i < kDirections; ++i)
      out[static_cast<std::size_t>(i)] = Vector2d(std::cos(kStep * i), std::sin(kStep * i));
    return out;
  }();
  return all[static_cast<std::size_t>(k) % kDirections];
}

void SampledNorms::reset(std::size_t places) {
  row_.assign(places, -1);
  values_.clear();
}

void SampledNorms::learn(std::size_t place, const CoordinateCost::Element& element) {
  row_[place] = static_cast<int>(values_.size() / kDirections);
  for (int k = 0; k < kDirections; ++k) values_.push_back(static_cast<float>(element(direction(k))));
}

SampledNorms::Peak SampledNorms::peak(std::size_t place, const Vector2d& p) const {
  if (!knows(place) || !p.allFinite()) return {std::numeric_limits<double>::quiet_NaN(), 0};
  const auto rise = [&](int k) { return std::max(0.0, p.dot(direction(k)) / cost(place, k)); };
  int best = static_cast<int>(std::lround(std::atan2(p[1], p[0]) / kStep)) + kDirections;
  double here = rise(best), after = rise(best + 1), before = rise(best - 1);
  for (int steps = 0; steps < kDirections && (after > here || before > here || here == 0); ++steps) {
    const int way = after >= before ? 1 : -1;
    best = (best + way + kDirections) % kDirections + kDirections;
    (way > 0 ? before : after) = here;
    here = way > 0 ? after : before;
    (way > 0 ? after : before) = rise(best + way);
  }
  const int left = before > after ? best - 1 : best;
  const std::array<double, 4> around = {-rise(left - 1), -rise(left), -rise(left + 1), -rise(left + 2)};
  if (!(around[0] < 0 && around[3] < 0)) return {here, kStep * best};
  const CubicMinimum top = cubic_minimum(around, 1, 2);
  return {std::max(here, -top.value), kStep * (left - 1 + top.at)};
}

double SampledNorms::dual(std::size_t place, const Vector2d& p) const { return peak(place, p).height; }

Vector2d SampledNorms::steepest(std::size_t place, const Vector2d& p) const {
  const Peak at = peak(place, p);
  const Vector2d e(std::cos(at.angle), std::sin(at.angle));
  return e * (at.height / p.dot(e));
}

double dual_norm(const CoordinateCost::Element& element, const Vector2d& p, double angle) {
  constexpr int kMostSteps = 64, kHalvings = 6;
  const auto rise = [&](double at) {
    const Vector2d e(std::cos(at), std::sin(at));
    const double along = p.dot(e);
    return along > 0 ? along / element(e) : 0;
  };
  double step = kStep, here = rise(angle), before = rise(angle - step), after = rise(angle + step);
  for (int k = 0; k < kMostSteps && !(here > 0 && here >= before && here >= after); ++k) {
    const double way = after >= before ? 1 : -1;
    (way > 0 ? before : after) = here;
    here = way > 0 ? after : before;
    angle += way * step;
    (way > 0 ? after : before) = rise(angle + way * step);
  }
  // Towards the peak: the parabola's vertex, and in case of a kink half the step on the side where it is.
  double top = here;
  for (int k = 0; k < kHalvings; ++k) {
    const double t = vertex(before, here, after);
    top = here + 0.25 * t * (after - before);
    const double next = rise(angle + t * step);
    if (next >= here) {
      angle += t * step;
      here = next;
    }
    constexpr double kEnough = 1e-6;  // of what the parabola says and what is there
    if (std::abs(top - std::max(here, next)) <= kEnough * here) break;
    step /= 4;
    before = rise(angle - step);
    after = rise(angle + step);
    if (before > here || after > here) {
      angle += after > before ? step : -step;
      here = std::max(before, after);
      before = rise(angle - step);
      after = rise(angle + step);
    }
  }
  return std::max(top, here);
}

}  // namespace leastcost::bracket
