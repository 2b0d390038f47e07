// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/cells/sampled_norms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "problems/bracket/cubic_minimum.hpp"

namespace leastcost::bracket {
namespace {

using Eigen::Vector2d;

double step_of(int directions) { return 2 * std::numbers::pi / directions; }

Vector2d at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Where the parabola through three values, a step apart, is largest, in steps from the middle one; within one half
/// where that is the largest of the three.
double vertex(double before, double middle, double after) {
  const double bend = 2 * middle - before - after;
  return bend > 0 ? std::clamp(0.5 * (after - before) / bend, -1.0, 1.0) : 0;
}

}  // namespace

int directions_for(const CoordinateCost& cost, const Eigen::AlignedBox2d& box) {
  constexpr int kFewest = 64, kMost = 256, kSide = 5;
  constexpr double kEnough = 1e-4;
  std::vector<CoordinateCost::Element> elements;
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i)
      elements.emplace_back(cost, box.min() + box.sizes().cwiseProduct(Vector2d(i + 0.5, j + 0.5) / kSide));
  const auto suffice = [&](int directions) {
    const double step = step_of(directions);
    for (const CoordinateCost::Element& element : elements)
      for (int k = 0; k < directions; ++k) {
        const auto f = [&](double steps) { return element(at_angle(step * (k + steps))); };
        const double middle = f(0.5), between = (9 * (f(0) + f(1)) - f(-1) - f(2)) / 16;
        if (std::isfinite(between) && std::abs(between - middle) > kEnough * middle) return false;
      }
    return true;
  };
  int directions = kFewest;
  while (directions < kMost && !suffice(directions)) directions *= 2;
  return directions;
}

void SampledNorms::reset(std::size_t places, int directions) {
  row_.assign(places, -1);
  values_.clear();
  least_.clear();
  unit_.clear();
  for (int k = 0; k < directions; ++k) unit_.push_back(at_angle(step_of(directions) * k));
}

void SampledNorms::learn(std::size_t place, const CoordinateCost::Element& element) {
  row_[place] = static_cast<int>(values_.size() / unit_.size());
  for (const Vector2d& e : unit_) values_.push_back(static_cast<float>(element(e)));
  least_.push_back(*std::min_element(values_.end() - directions(), values_.end()));
}

SampledNorms::Peak SampledNorms::peak(std::size_t place, const Vector2d& p) const {
  if (!knows(place) || !p.allFinite()) return {std::numeric_limits<double>::quiet_NaN(), 0};
  const int all = directions();
  const auto rise = [&](int k) { return std::max(0.0, p.dot(direction(k + all)) / cost(place, k + all)); };
  int best = static_cast<int>(std::lround(std::atan2(p[1], p[0]) / step_of(all)));
  double here = rise(best);
  for (int stride = all / 32; stride > 0; stride /= 2)
    for (int steps = 0; steps < all / stride; ++steps) {
      const double after = rise(best + stride), before = rise(best - stride);
      if (here > 0 && after <= here && before <= here) break;
      best = (best + (after >= before ? stride : -stride)) % all;
      here = std::max(before, after);
    }
  const int left = rise(best - 1) > rise(best + 1) ? best - 1 : best;
  const std::array<double, 4> around = {-rise(left - 1), -rise(left), -rise(left + 1), -rise(left + 2)};
  if (!(around[0] < 0 && around[3] < 0)) return {here, step_of(all) * best};
  const CubicMinimum top = cubic_minimum(around, 1, 2);
  return {std::max(here, -top.value), step_of(all) * (left - 1 + top.at)};
}

double SampledNorms::dual(std::size_t place, const Vector2d& p) const { return peak(place, p).height; }

Vector2d SampledNorms::steepest(std::size_t place, const Vector2d& p) const {
  const Peak at = peak(place, p);
  const Vector2d e = at_angle(at.angle);
  return e * (at.height / p.dot(e));
}

double dual_norm(const CoordinateCost::Element& element, const Vector2d& p, double angle) {
  constexpr int kMostSteps = 64, kHalvings = 6;
  const auto rise = [&](double at) {
    const Vector2d e = at_angle(at);
    const double along = p.dot(e);
    return along > 0 ? along / element(e) : 0;
  };
  double step = step_of(64), here = rise(angle), before = rise(angle - step), after = rise(angle + step);
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
