// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include <leastcost/framework/base/deadline.hpp>
#include "framework/proof/tube_field.hpp"

namespace leastcost {

/// Bounds in interval arithmetic on the potential of a tube: of f, the squared dual norm of its gradient, and of the
/// cost of the curve.
template <int N, int D>
class TubeBounds {
 public:
  static constexpr int kAcross = N - 1;

  /// Looks at `most_boxes` before it takes the bounds as they are.
  TubeBounds(const TubeField<N, D>& field, Index most_boxes, const Deadline& deadline)
      : field_(field), most_boxes_(most_boxes), kinks_left_(most_boxes), deadline_(deadline) {}

  /// The cost of a part of the curve, by Taylor's theorem: the third derivative of the speed bounds what its parabola
  /// leaves out. Where there is none, at a kink, the part is halved until only a short one holds the kink.
  Interval curve_cost(const TubeSegment<N, D>& segment, const Interval& range, double enough, int depth = 0) {
    constexpr int kDeepest = 3, kMostParts = 4;
    look_at_clock(deadline_);
    const double middle = range.middle(), half = range.width() / 2 * (1 + 1e-15);
    const TubeSegment<N, D> here = segment.around(middle);
    const IntervalJet<N> speed = field_.on_curve(here, {-half, half}).speed;
    if (!speed.d(0, 0, 0).is_finite()) return kinked_cost(segment, range, speed.value(), enough);
    const Interval r(range.width() / 2 * (1 - 1e-15), half), r3 = r * square(r);
    const double odd = speed.d(0, 0, 0).width() * (r3 * r).hi / 24;
    const Interval sum =
        Interval(2) * speed.value_at_center() * r + speed.d_at_center(0, 0) * r3 / Interval(3) + Interval(-odd, odd);
    if (sum.width() <= enough || depth == kDeepest) return sum;
    const double parts_needed = std::sqrt(std::sqrt(sum.width() / enough));  // the error is of fourth order
    const int parts = parts_needed <= 2 ? 2 : parts_needed <= 3 ? 3 : kMostParts;
    Interval all(0);
    double from = range.lo;
    for (int part = 1; part <= parts; ++part) {
      const double to = part == parts ? range.hi : range.lo + range.width() * part / parts;
      all += curve_cost(segment, {from, to}, enough / parts, depth + 1);
      from = to;
    }
    return all;
  }

  /// c < 0 such that f(t, z) <= 1 + r.z + c |z|^2 / 2 in the tube, r the slope on the curve; not negative where that is
  /// not seen. f is the double integral of its Hessian along the way from the curve to z, so that a bound on each of a
  /// few shells around the curve is enough, and farther out it may be positive. `margin`: -1/2 of that Hessian on the
  /// curve.
  double mean_curvature(const TubeSegment<N, D>& segment, double half_width, double margin) {
    margin_ = margin;
    on_curve_.clear();
    constexpr int kShells = kAcross == 1 ? 6 : 3;
    Box all;
    all.fill({-half_width, half_width});
    const CurvatureBound at_once = curvature_bound(segment, {0, 1}, all);
    if (is_good(at_once)) return at_once.bound;
    double sum = 0, slope = 0, worst = -std::numeric_limits<double>::infinity();  // the double integral, its slope
    for (int shell = 0; shell < kShells; ++shell) {
      const double lo = shell * half_width / kShells, hi = (shell + 1) * half_width / kShells;
      const double bound = shell_curvature(segment, {lo, hi});
      if (!std::isfinite(bound)) return std::numeric_limits<double>::infinity();
      // The integral over z^2 is a + b / z + c / z^2 within the shell.
      const double a = bound / 2, b = slope - bound * lo, c = sum - slope * lo + bound * lo * lo / 2;
      const auto mean = [&](double inverse) { return 2 * (a + inverse * (b + inverse * c)); };
      worst = std::max(worst, mean(1 / hi));
      if (lo > 0) worst = std::max(worst, mean(1 / lo));
      if (lo > 0 && c < 0 && -b / (2 * c) > 1 / hi && -b / (2 * c) < 1 / lo)
        worst = std::max(worst, mean(-b / (2 * c)));
      sum += (hi - lo) * (slope + bound * (hi - lo) / 2);
      slope += bound * (hi - lo);
    }
    return worst;
  }

  /// A bound of the squared slope of f across the curve, on the curve; `enough` is good enough.
  double squared_slope(const TubeSegment<N, D>& segment, double enough) {
    seen_ = 0;
    return slope2(segment, {0, 1}, enough, 0);
  }

 private:
  using Box = std::array<Interval, kAcross>;

  /// The cost of a part with a kink in it, which falls as the square of its length.
  Interval kinked_cost(const TubeSegment<N, D>& segment, const Interval& range, const Interval& speed, double enough) {
    const Interval sum = speed * (Interval(range.hi) - Interval(range.lo));
    if (!sum.is_finite() || sum.width() <= enough || kinks_left_ == 0) return sum;
    --kinks_left_;
    const double middle = range.middle();
    return curve_cost(segment, {range.lo, middle}, enough / 2) + curve_cost(segment, {middle, range.hi}, enough / 2);
  }

  /// A bound of the eigenvalues of the Hessian of f across the curve where the largest coordinate is in `radius`.
  double shell_curvature(const TubeSegment<N, D>& segment, const Interval& radius) {
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < kAcross; ++k)
      for (const Interval& side : {radius, -radius}) {
        Box box;
        box.fill({-radius.hi, radius.hi});
        box[k] = side;
        largest = std::max(largest, largest_curvature(segment, {0, 1}, box, 0));
      }
    return largest;
  }

  struct CurvatureBound {
    double bound, at_center;
  };

  static bool is_good(const CurvatureBound& found) { return found.bound < 0 && found.bound <= found.at_center / 2; }

  /// A bound of the eigenvalues of the Hessian of f across the curve in a part of the tube, by Gershgorin's circles.
  CurvatureBound curvature_bound(const TubeSegment<N, D>& segment, const Interval& range, const Box& across) {
    look_at_clock(deadline_);
    ++boxes_;
    const double middle = range.middle(), half = range.width() / 2 * (1 + 1e-12);
    const TubeSegment<N, D> here = segment.around(middle);
    const Interval local(-half, half);
    auto on_curve = on_curve_.find({range.lo, range.hi});
    if (on_curve == on_curve_.end())
      on_curve = on_curve_.emplace(std::pair(range.lo, range.hi), field_.on_curve(here, local)).first;
    const IntervalJet<N> f = field_.squared_norm(here, on_curve->second, local, across);
    CurvatureBound out{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (int k = 1; k < N; ++k) {
      double row = f.d(k, k).hi, center_row = f.d_at_center(k, k).hi;
      for (int l = 1; l < N; ++l)
        if (l != k) row += f.d(k, l).magnitude(), center_row += f.d_at_center(k, l).magnitude();
      out.bound = std::max(out.bound, row);
      out.at_center = std::max(out.at_center, center_row);
    }
    if (std::isnan(out.bound)) out.bound = std::numeric_limits<double>::infinity();
    return out;
  }

  /// The same, halved in every direction until the bound is good.
  double largest_curvature(const TubeSegment<N, D>& segment, const Interval& range, const Box& across, int depth) {
    constexpr int kDeepest = kAcross == 1 ? 5 : 3;
    const CurvatureBound found = curvature_bound(segment, range, across);
    if (is_good(found) || found.bound - found.at_center <= margin_ / 4 || depth == kDeepest) return found.bound;
    if (boxes_ > most_boxes_) return found.bound;
    double largest = -std::numeric_limits<double>::infinity();
    for (int part = 0; part < 1 << N && largest < std::numeric_limits<double>::infinity(); ++part) {
      const double middle = range.middle();
      const Interval t = part & 1 ? Interval(middle, range.hi) : Interval(range.lo, middle);
      Box z = across;
      for (std::size_t k = 0; k < kAcross; ++k) (part >> (k + 1) & 1 ? z[k].lo : z[k].hi) = across[k].middle();
      largest = std::max(largest, largest_curvature(segment, t, z, depth + 1));
    }
    return largest;
  }

  /// A bound of the squared slope of f across the curve, on the curve.
  double slope2(const TubeSegment<N, D>& segment, const Interval& range, double enough, int depth) {
    constexpr int kDeepest = 4;
    look_at_clock(deadline_);
    const double middle = range.middle(), half = range.width() / 2 * (1 + 1e-12);
    const TubeSegment<N, D> here = segment.around(middle);
    const Interval local(-half, half);
    const Box zero = {};
    const IntervalJet<N> f = field_.squared_norm(here, field_.on_curve(here, local), local, zero);
    double sum = 0, least = 0;
    for (int k = 1; k < N; ++k) {
      const Interval there = f.d_at_center(k), slope = f.d(k);
      sum += slope.magnitude() * slope.magnitude();
      least += there.magnitude() * there.magnitude();
    }
    seen_ = std::max(seen_, least);
    if (sum <= std::max(enough, 2 * seen_) || depth == kDeepest)
      return std::isnan(sum) ? std::numeric_limits<double>::infinity() : sum;
    return std::max(slope2(segment, {range.lo, middle}, enough, depth + 1),
                    slope2(segment, {middle, range.hi}, enough, depth + 1));
  }

  const TubeField<N, D>& field_;
  double margin_ = 0;
  std::map<std::pair<double, double>, typename TubeField<N, D>::OnCurve>
      on_curve_;  ///< of parts of the segment at hand
  Index boxes_ = 0, most_boxes_;
  Index kinks_left_;  ///< parts with a kink that may still be halved
  double seen_ = 0;   ///< largest squared slope met on the curve in a segment
  const Deadline& deadline_;
};

}  // namespace leastcost
