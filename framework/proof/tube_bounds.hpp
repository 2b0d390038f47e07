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
    constexpr int kDeepest = 2, kMostParts = 16;
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
    const double needed = std::sqrt(std::sqrt(sum.width() / enough));  // the error is of fourth order
    const int parts = needed < kMostParts ? std::max(2, static_cast<int>(std::ceil(needed))) : kMostParts;
    Interval all(0);
    double from = range.lo;
    for (int part = 1; part <= parts; ++part) {
      const double to = part == parts ? range.hi : range.lo + range.width() * part / parts;
      all += curve_cost(segment, {from, to}, enough / parts, depth + 1);
      from = to;
    }
    return all;
  }

  struct Curvature {
    double bound;
    IntervalJet<N> on_curve;  ///< f on the curve of the whole segment
    int parts = 1;            ///< in which the segment is better divided; the bound says nothing then
  };

  /// c < 0 such that f(t, z) <= 1 + r.z + c |z|^2 / 2 in the tube, r the slope on the curve; not negative where that is
  /// not seen. f is the double integral of its Hessian along the way from the curve to z, so that a bound on each of a
  /// few shells around the curve is enough, and farther out it may be positive. `margin`: -1/2 of that Hessian on the
  /// curve.
  Curvature mean_curvature(const TubeSegment<N, D>& segment, double half_width, double margin, bool can_divide) {
    margin_ = margin;
    on_curve_.clear();
    constexpr int kShells = kAcross == 1 ? 6 : 3;
    const IntervalJet<N> on_curve = squared_norm(segment, {0, 1}, Box{});
    const CurvatureBound at_once = mean_at_once(segment, {0, 1}, half_width, on_curve);
    if (is_good(at_once, kPart)) return {at_once.bound, on_curve};
    if (can_divide) {
      const Interval middle(0.5);
      const double cut = mean_at_once(segment, middle, half_width, squared_norm(segment, middle, Box{})).bound;
      const double off = (at_once.bound - cut) / std::abs(at_once.at_center);
      if (!(off < kOff)) return {at_once.bound, on_curve, parts_for(off)};
    }
    double sum = 0, slope = 0, worst = -std::numeric_limits<double>::infinity();  // the double integral, its slope
    for (int shell = 0; shell < kShells; ++shell) {
      const double lo = shell * half_width / kShells, hi = (shell + 1) * half_width / kShells;
      const double bound = shell_curvature(segment, {lo, hi});
      if (!std::isfinite(bound)) return {bound, on_curve};
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
    return {worst, on_curve};
  }

  /// A bound of the squared slope of f across the curve, on the curve; `enough` is good enough. `on_curve`: f of the
  /// whole segment.
  double squared_slope(const TubeSegment<N, D>& segment, const IntervalJet<N>& on_curve, double enough) {
    seen_ = 0;
    on_curve_.clear();
    return slope2(segment, on_curve, {0, 1}, enough, 0);
  }

 private:
  using Box = std::array<Interval, kAcross>;
  static constexpr double kPart = 0.25;        ///< of the curvature on the curve that is enough in the mean
  static constexpr double kPartOfShell = 0.5;  ///< and in a shell, which may have to make up for others
  static constexpr double kOff = 0.7;          ///< of a bound above that in the middle of a segment, relative

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

  static bool is_good(const CurvatureBound& found, double part) {
    return found.bound < 0 && found.bound <= part * found.at_center;
  }

  /// Parts of a segment, where its bound lies `off` above that in its middle, relative to it. The distance falls with
  /// the third power of the length.
  static int parts_for(double off) {
    constexpr int kMost = 4;
    if (!std::isfinite(off)) return 2;
    return off < kOff * kMost * kMost * kMost ? std::max(2, static_cast<int>(std::ceil(std::cbrt(off / kOff)))) : kMost;
  }

  IntervalJet<N> squared_norm(const TubeSegment<N, D>& segment, const Interval& range, const Box& across) {
    look_at_clock(deadline_);
    ++boxes_;
    const double middle = range.middle(), half = range.width() / 2 * (1 + 1e-12);
    const TubeSegment<N, D> here = segment.around(middle);
    const Interval local(-half, half);
    auto on_curve = on_curve_.find({range.lo, range.hi});
    if (on_curve == on_curve_.end())
      on_curve = on_curve_.emplace(std::pair(range.lo, range.hi), field_.on_curve(here, local)).first;
    return field_.squared_norm(here, on_curve->second, local, across);
  }

  /// A bound of the eigenvalues of the Hessian of f across the curve, by Gershgorin's circles.
  static CurvatureBound largest_eigenvalue(const IntervalJet<N>& f) {
    CurvatureBound out{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (int k = 1; k < N; ++k) {
      double row = f.d(k, k).hi, center_row = f.d_at_center(k, k).hi;
      for (int l = 1; l < N; ++l)
        if (l != k) row += f.d(k, l).magnitude(), center_row += f.d_at_center(k, l).magnitude();
      if (std::isnan(row)) row = std::numeric_limits<double>::infinity();
      out.bound = std::max(out.bound, row);
      out.at_center = std::max(out.at_center, center_row);
    }
    return out;
  }

  /// c as in mean_curvature(), from the Hessian on the curve and the third derivatives over the whole width: the
  /// second integral of a Hessian that grows by these is a third of what they add at the sides.
  CurvatureBound mean_at_once(const TubeSegment<N, D>& segment, const Interval& range, double half_width,
                              const IntervalJet<N>& f_on_curve) {
    Box all;
    all.fill({-half_width, half_width});
    const CurvatureBound on_curve = largest_eigenvalue(f_on_curve);
    const IntervalJet<N> f = squared_norm(segment, range, all);
    double norm2 = 0;
    for (int k = 1; k < N; ++k)
      for (int l = 1; l < N; ++l)
        for (int m = 1; m < N; ++m) norm2 += f.d(k, l, m).magnitude() * f.d(k, l, m).magnitude();
    const double reach = half_width * std::sqrt(static_cast<double>(kAcross)),
                 bound = (on_curve.bound + std::sqrt(norm2) * reach / 3) * (1 + 1e-15);
    const double over_box = largest_eigenvalue(f).bound;
    return {bound < over_box ? bound : over_box, on_curve.at_center};
  }

  /// A bound of the eigenvalues of the Hessian of f across the curve in a part of the tube.
  CurvatureBound curvature_bound(const TubeSegment<N, D>& segment, const Interval& range, const Box& across) {
    return largest_eigenvalue(squared_norm(segment, range, across));
  }

  /// The same, halved in every direction until the bound is good.
  double largest_curvature(const TubeSegment<N, D>& segment, const Interval& range, const Box& across, int depth) {
    constexpr int kDeepest = kAcross == 1 ? 5 : 3;
    const CurvatureBound found = curvature_bound(segment, range, across);
    if (is_good(found, kPartOfShell) || found.bound - found.at_center <= margin_ / 4 || depth == kDeepest)
      return found.bound;
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
  double slope2(const TubeSegment<N, D>& segment, const IntervalJet<N>& f, const Interval& range, double enough,
                int depth) {
    constexpr int kDeepest = 2, kMostParts = 8;
    constexpr double kSlack = 1.6;  // of the slope
    const double half = range.width() / 2 * (1 + 1e-12);
    double most = 0, seen = 0;
    for (int k = 1; k < N; ++k) {
      const double bound = std::min(f.d(k).magnitude(), largest_slope(f, k, half, f.d(k, 0, 0))),
                   there = largest_slope(f, k, half, Interval(f.d(k, 0, 0).middle()));
      most += bound * bound;
      seen += there * there;
    }
    seen_ = std::max(seen_, seen);
    if (most <= std::max(enough, kSlack * kSlack * seen_)) return most;
    if (depth == kDeepest) return std::isnan(most) ? std::numeric_limits<double>::infinity() : most;
    // What is not seen falls with the third power of the length.
    const double unseen = (std::sqrt(most) - std::sqrt(seen)) / ((kSlack - 1) * std::sqrt(std::max(enough, seen_)));
    const int parts = unseen < kMostParts * kMostParts * kMostParts
                          ? std::max(2, static_cast<int>(std::ceil(std::cbrt(unseen))))
                          : kMostParts;
    double worst = 0;
    for (int part = 0; part < parts; ++part) {
      const auto at = [&](int p) { return p == parts ? range.hi : range.lo + range.width() * p / parts; };
      const Interval there(at(part), at(part + 1));
      worst = std::max(worst, slope2(segment, squared_norm(segment, there, Box{}), there, enough, depth + 1));
    }
    return worst;
  }

  /// A bound of |df/dz_k| on the curve for |t| <= half, by Taylor's theorem, if d^3f/dz_k dt^2 is in `second`.
  static double largest_slope(const IntervalJet<N>& f, int k, double half, const Interval& second) {
    constexpr int kParts = 4;
    double most = 0;
    for (int part = -kParts; part < kParts; ++part) {
      const Interval t(half * part / kParts, half * (part + 1) / kParts);
      const Interval there = f.d_at_center(k) + t * f.d_at_center(k, 0) + square(t) * second / Interval(2);
      if (!there.is_finite()) return std::numeric_limits<double>::infinity();
      most = std::max(most, there.magnitude());
    }
    return most;
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
