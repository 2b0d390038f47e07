// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>
#include "framework/proof/detail_verdict.hpp"
#include "framework/proof/tube.hpp"
#include "framework/proof/tube_field.hpp"

namespace leastcost {

/// How DetailVerdict (framework/proof/detail_verdict.hpp) comes about: whether the metric varies in a tube on a scale
/// finer than its segments: by a bound of its third derivatives, over the whole tube, against the first and second ones
/// on the curve, which the chain has seen. All in units of a segment along the curve, of the tube's half width across
/// it, and of the metric on the curve.
template <int N, int D>
class TubeDetails {
 public:
  TubeDetails(const TubeField<N, D>& field, const Tube<N, D>& tube, const Deadline& deadline)
      : field_(field), tube_(tube), deadline_(deadline), left_(kBoxes * tube.segments.size()) {
    for (std::size_t i = 0; i < tube_.segments.size(); ++i) seen_.push_back(seen_on_curve(i));
    most_seen_ = *std::max_element(seen_.begin(), seen_.end());
  }

  /// Throws Interrupted.
  DetailVerdict examine() {
    for (segment_ = 0; segment_ < tube_.segments.size(); ++segment_) {
      Box all;
      all.fill({-width(segment_), width(segment_)});
      const DetailVerdict verdict = examine({0, 1}, all, allowed(segment_), 0);
      if (verdict != DetailVerdict::none) return verdict;
    }
    return kink_ ? DetailVerdict::kink : DetailVerdict::none;
  }
  /// Where examine() ended.
  Index segment() const { return static_cast<Index>(std::min(segment_, tube_.segments.size() - 1)); }

 private:
  static constexpr std::size_t kAcross = N - 1;
  using Box = std::array<Interval, kAcross>;
  static constexpr double kFiner = 2;         ///< third derivatives over lower ones: a scale of half a segment
  static constexpr double kOfAll = 1e-3;      ///< what does no harm, of the most that was seen anywhere
  static constexpr double kRounding = 1e-11;  ///< of intervals, in derivatives that vanish
  static constexpr std::size_t kBoxes = 40, kBeside = 2;  ///< per segment; segments on each side that count as seen

  double width(std::size_t i) const { return tube_.widths[static_cast<Index>(i)]; }

  double allowed(std::size_t i) const {
    double most = std::max(kRounding, kOfAll * most_seen_);
    for (std::size_t j = i - std::min(i, kBeside); j <= std::min(i + kBeside, seen_.size() - 1); ++j)
      most = std::max(most, seen_[j]);
    return kFiner * most;
  }

  /// The largest of the derivatives of the given order in units of the tube.
  template <class Derivative>
  double largest(std::size_t i, int order, const Derivative& derivative) const {
    const double speed = tube_.costs[static_cast<Index>(i)];
    double most = 0;
    for (int p = 0; p < N; ++p)
      for (int q = p; q < N; ++q) {
        const double unit = (p == 0 ? speed : 1) * (q == 0 ? speed : 1);
        for (int code = 0; code < (order == 1 ? N : order == 2 ? N * N : N * N * N); ++code) {
          const int k = code % N, l = code / N % N, m = code / (N * N);
          double scale = k == 0 ? 1 : width(i);
          if (order > 1) scale *= l == 0 ? 1 : width(i);
          if (order > 2) scale *= m == 0 ? 1 : width(i);
          most = std::max(most, derivative(static_cast<std::size_t>(N * p + q), k, l, m) * scale / unit);
        }
      }
    return std::isnan(most) ? std::numeric_limits<double>::infinity() : most;
  }

  JetMatrix<N> metric(std::size_t i, const Interval& t, const Box& across) const {
    std::array<IntervalJet<N>, kAcross> z;
    for (std::size_t k = 0; k < kAcross; ++k) z[k] = IntervalJet<N>::variable(across[k], static_cast<int>(k) + 1);
    return field_.metric_in_tube(tube_.segments[i], t, z);
  }

  /// The third derivative of |dgamma/dt|^2, relative: what the cubic brings into the metric by itself, on a sphere as
  /// well as in the plane.
  double of_parameter(std::size_t i) const {
    double at_start = 0, at_end = 0, speed2 = 0;
    for (const Cubic& c : tube_.segments[i].curve) {
      const Cubic first = c.derivative(), second = first.derivative();
      const double third = second.c[1], speed = first.at(0.5);
      at_start += 6 * second.at(0) * third;
      at_end += 6 * second.at(1) * third;
      speed2 += speed * speed;
    }
    return std::max(std::abs(at_start), std::abs(at_end)) / speed2;
  }

  double seen_on_curve(std::size_t i) const {
    look_at_clock(deadline_);
    double most = of_parameter(i);
    for (const double t : {0.0, 0.5, 1.0}) {
      const JetMatrix<N> g = metric(i, Interval(t), {});
      const double first = largest(i, 1, [&](std::size_t e, int k, int, int) { return g[e].d(k).magnitude(); }),
                   second = largest(i, 2, [&](std::size_t e, int k, int l, int) { return g[e].d(k, l).magnitude(); });
      for (const double seen : {first, second})
        if (std::isfinite(seen)) most = std::max(most, seen);  // at a kink nothing is, which excuses nothing
    }
    return most;
  }

  DetailVerdict examine(const Interval& t, const Box& across, double allowed, int depth) {
    look_at_clock(deadline_);
    const auto third = [](const JetMatrix<N>& g) {
      return [&g](std::size_t e, int k, int l, int m) { return g[e].d(k, l, m).magnitude(); };
    };
    const JetMatrix<N> g = metric(segment_, t, across);
    const double most = largest(segment_, 3, third(g));
    if (most <= allowed) return DetailVerdict::none;
    constexpr int kDeepest = 6, kDeepestKink = 2;
    if (depth >= kDeepestKink && !std::isfinite(most) && has_slopes(g)) {
      kink_ = true;
      return DetailVerdict::none;
    }
    Box middle;
    for (std::size_t k = 0; k < kAcross; ++k) middle[k] = Interval(across[k].middle());
    const JetMatrix<N> there = metric(segment_, Interval(t.middle()), middle);
    const double found = largest(segment_, 3, third(there));
    if (std::isfinite(found) && found > allowed) return DetailVerdict::found;
    if (left_ == 0 || depth == kDeepest) return DetailVerdict::undecided;
    --left_;
    for (int part = 0; part < 1 << N; ++part) {
      Box z = across;
      for (std::size_t k = 0; k < kAcross; ++k) (part >> (k + 1) & 1 ? z[k].lo : z[k].hi) = across[k].middle();
      const Interval half = part & 1 ? Interval(t.middle(), t.hi) : Interval(t.lo, t.middle());
      const DetailVerdict verdict = examine(half, z, allowed, depth + 1);
      if (verdict != DetailVerdict::none) return verdict;
    }
    return DetailVerdict::none;
  }

  /// Values and first derivatives are bounded, whatever the third ones are.
  static bool has_slopes(const JetMatrix<N>& g) {
    return std::all_of(g.begin(), g.end(), [](const IntervalJet<N>& entry) {
      bool finite = entry.value().is_finite();
      for (int k = 0; k < N; ++k) finite = finite && entry.d(k).is_finite();
      return finite;
    });
  }

  const TubeField<N, D>& field_;
  const Tube<N, D>& tube_;
  const Deadline& deadline_;
  bool kink_ = false;
  std::vector<double> seen_;
  double most_seen_ = 0;
  std::size_t left_, segment_ = 0;
};

}  // namespace leastcost
