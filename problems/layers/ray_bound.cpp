// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/layers/ray_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <leastcost/framework/numbers/interval.hpp>

namespace leastcost {
namespace {

constexpr double kShorter = 1 - 8 * std::numeric_limits<double>::epsilon();

using Intervals = std::vector<Interval>;

Intervals intervals(const Eigen::VectorXd& x) { return {x.begin(), x.end()}; }

Interval dot(const Intervals& a, const Intervals& b) {
  Interval sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}
Intervals difference(const Intervals& a, const Intervals& b) {
  Intervals out = a;
  for (std::size_t i = 0; i < a.size(); ++i) out[i] -= b[i];
  return out;
}
Interval norm(const Intervals& a) {
  Interval sum = 0;
  for (const Interval& x : a) sum += square(x);
  return sqrt(sum);
}

/// The vector, shortened until it is no longer than `most` for certain.
Intervals no_longer(Eigen::VectorXd y, double most) {
  for (int i = 0; i < 100 && !(norm(intervals(y)).hi <= most); ++i) y *= kShorter;
  if (!(norm(intervals(y)).hi <= most)) y.setZero();
  return intervals(y);
}

/// A layer that a path passes `times` times from side to side, as far as `thickness`.
struct Passage {
  double index;
  double times;
  Interval thickness;
};

/// What a path passes for certain, and the least index that it may meet.
struct Passages {
  std::vector<Passage> list;
  double least_index = std::numeric_limits<double>::infinity();
};

Interval at_least_zero(const Interval& x) { return {std::max(0.0, x.lo), std::max(0.0, x.hi)}; }

/// The part of a layer between two heights.
Interval part_of(const LayerStack& stack, int layer, const Interval& low, const Interval& high) {
  Interval from = low, to = high;
  if (layer > 0) from = {std::max(low.lo, stack.offset(layer - 1)), std::max(low.hi, stack.offset(layer - 1))};
  if (layer < stack.interfaces()) to = {std::min(high.lo, stack.offset(layer)), std::min(high.hi, stack.offset(layer))};
  return at_least_zero(to - from);
}

Passages passages(const LayerStack& stack, const Eigen::VectorXd& source, const Eigen::VectorXd& target,
                  const Excursion& excursion) {
  const Intervals normal = intervals(stack.normal(0));
  const Interval a = dot(normal, intervals(source)), b = dot(normal, intervals(target));
  const Interval low{std::min(a.lo, b.lo), std::min(a.hi, b.hi)}, high{std::max(a.lo, b.lo), std::max(a.hi, b.hi)};
  Passages out;
  const auto pass = [&](int layer, double times, const Interval& thickness) {
    if (!(thickness.hi > 0)) return;
    out.list.push_back({stack.index(layer), times, thickness});
    out.least_index = std::min(out.least_index, stack.index(layer));
  };
  for (int layer = 0; layer < stack.layers(); ++layer) {
    pass(layer, 1, part_of(stack, layer, low, high));
    if (!excursion.farthest) continue;
    const int last = *excursion.farthest;
    if (layer < last && stack.offset(last - 1) > high.lo)
      pass(layer, 2, part_of(stack, layer, high, Interval(stack.offset(last - 1))));
    if (layer > last && stack.offset(last) < low.hi)
      pass(layer, 2, part_of(stack, layer, Interval(stack.offset(last)), low));
  }
  const auto meet = [&](int layer) { out.least_index = std::min(out.least_index, stack.index(layer)); };
  for (int layer = excursion.bottom; layer <= excursion.top; ++layer) meet(layer);
  if (excursion.farthest) meet(*excursion.farthest);
  return out;
}

/// The slowness p along the interfaces at which the rays get as far as `offset`, at most the least index: where the
/// bound is largest.
double ray_parameter(const Passages& passages, double offset) {
  double below = 0, above = passages.least_index;
  const auto reach = [&](double p) {
    double sum = 0;
    for (const Passage& layer : passages.list)
      sum += layer.times * layer.thickness.hi * p / std::sqrt((layer.index - p) * (layer.index + p));
    return sum;
  };
  if (reach(above) <= offset) return above;
  for (int i = 0; i < 100; ++i) {
    const double middle = (below + above) / 2;
    (reach(middle) <= offset ? below : above) = middle;
  }
  return below;
}

/// The largest s for certain with |along + s normal| and |along - s normal| at most n.
double slowness_across(const Intervals& along, const Intervals& normal, double n) {
  const Interval length = norm(along), square_left = (Interval(n) - length) * (Interval(n) + length);
  const Interval skew = abs(dot(along, normal)), unit = dot(normal, normal);
  if (!(square_left.lo >= 0)) return 0;
  return std::max(0.0, ((sqrt(square(skew) + unit * square_left) - skew) / unit).lo);
}

}  // namespace

double word_bound(const LayerStack& stack, const RefractedRay& ray, double upper, std::optional<double> last_index) {
  const std::size_t legs = ray.word.size();
  std::vector<Intervals> y;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < legs; ++i) {
    const double n = i + 1 == legs ? last_index.value_or(stack.index(ray.word[i])) : stack.index(ray.word[i]);
    y.push_back(no_longer(ray.slowness.col(static_cast<Index>(i)), n));
    least = std::min(least, n);
  }
  const Intervals source = intervals(ray.x.leftCols(1));
  const Interval reach = Interval(upper) / Interval(least);
  Interval bound = dot(y.back(), intervals(ray.x.rightCols(1))) - dot(y.front(), source);
  for (std::size_t i = 0; i + 1 < legs; ++i) {
    const int k = interface_between(ray.word[i], ray.word[i + 1]);
    const Intervals normal = intervals(stack.normal(k)), x = intervals(ray.x.col(static_cast<Index>(i) + 1));
    Intervals jump = difference(y[i], y[i + 1]);
    const Interval across = dot(jump, normal).middle();
    for (std::size_t j = 0; j < jump.size(); ++j) jump[j] -= across * normal[j];
    bound += across * Interval(stack.offset(k)) + dot(jump, x);
    bound -= norm(jump) * (reach + norm(difference(x, source)));
  }
  return bound.lo;
}

double excursion_bound(const LayerStack& stack, const Eigen::VectorXd& source, const Eigen::VectorXd& target,
                       const Excursion& excursion) {
  const Passages passed = passages(stack, source, target, excursion);
  const Eigen::VectorXd normal = stack.normal(0), way = target - source;
  Eigen::VectorXd along = stack.tangents(0) * (stack.tangents(0).transpose() * way);
  const double offset = along.norm();
  if (offset > 0) along *= ray_parameter(passed, offset) / offset;
  const Intervals slowness = no_longer(along, passed.least_index);
  Interval bound = dot(slowness, difference(intervals(target), intervals(source)));
  for (const Passage& layer : passed.list)
    bound += Interval(layer.times) * Interval(layer.thickness.lo) *
             Interval(slowness_across(slowness, intervals(normal), layer.index));
  return bound.lo;
}

}  // namespace leastcost
