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
#include "framework/proof/tube_knots.hpp"

namespace leastcost {

/// How DetailVerdict (framework/proof/detail_verdict.hpp) comes about: whether the metric varies in a tube on a scale
/// finer than its segments: by a bound of its third derivatives, over the whole tube, against the first and second ones
/// on the curve, which the chain has seen. All in units of a segment along the curve, of the tube's half width across
/// it, and of the metric on the curve. "Segments" are those of the chain, whatever the tube has; a longer one of the
/// tube is held to a scale of its own length.
template <int N, int D>
class TubeDetails {
 public:
  TubeDetails(const TubeField<N, D>& field, const Tube<N, D>& tube, const TubeKnots& knots, const Deadline& deadline)
      : field_(field), tube_(tube), knots_(knots), deadline_(deadline), left_(kBoxes * tube.segments.size()) {
    for (std::size_t i = 0; i < tube_.segments.size(); ++i) seen_.push_back(seen_on_curve(i));
    for (const Seen& seen : seen_) most_seen_ = std::max(most_seen_, seen.of_metric);
  }

  /// Of one segment of the tube. Throws Interrupted.
  DetailVerdict examine(std::size_t segment) {
    segment_ = segment;
    kink_ = false;
    Box all;
    all.fill({-width(segment_), width(segment_)});
    const DetailVerdict verdict = examine({0, 1}, all, allowed(segment_), 0);
    return verdict == DetailVerdict::none && kink_ ? DetailVerdict::kink : verdict;
  }

 private:
  static constexpr std::size_t kAcross = N - 1;
  using Box = std::array<Interval, kAcross>;
  struct Seen {
    double of_metric, of_parameter;
  };
  static constexpr double kFiner = 2;         ///< third derivatives over lower ones: a scale of half a segment
  static constexpr double kOfAll = 1e-3;      ///< what does no harm, of the most that was seen anywhere
  static constexpr double kRounding = 1e-11;  ///< of intervals, in derivatives that vanish
  static constexpr std::size_t kBoxes = 40, kBeside = 2;  ///< per segment; segments on each side that count as seen

  double width(std::size_t i) const { return tube_.widths[static_cast<Index>(i)]; }

  double stride(std::size_t i) const { return static_cast<double>(knots_.stride(i)); }

  double allowed(std::size_t i) const {
    double metric = kOfAll * most_seen_, parameter = kRounding;
    for (std::size_t j = i - std::min(i, kBeside); j <= std::min(i + kBeside, seen_.size() - 1); ++j) {
      const Index far = std::max(knots_[j + 1] - knots_[i + 1], knots_[i] - knots_[j]);
      if (far > static_cast<Index>(kBeside) * knots_.stride(i)) continue;
      metric = std::max(metric, seen_[j].of_metric);
      parameter = std::max(parameter, seen_[j].of_parameter);
    }
    return kFiner * std::max(metric / stride(i), parameter);
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
          const auto unit_of = [&](int variable) { return variable == 0 ? 1 / stride(i) : width(i); };
          double scale = unit_of(k);
          if (order > 1) scale *= unit_of(l);
          if (order > 2) scale *= unit_of(m);
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

  /// The third derivative of |dgamma/dt|^2, relative: what the quintic brings into the metric by itself, on a sphere as
  /// well as in the plane.
  double of_parameter(std::size_t i) const {
    double at_start = 0, at_end = 0, speed2 = 0;
    for (const Quintic& c : tube_.segments[i].curve) {
      const Quintic first = c.derivative(), second = first.derivative(), third = second.derivative(),
                    fourth = third.derivative();
      const auto of_speed2 = [&](double t) { return 6 * second.at(t) * third.at(t) + 2 * first.at(t) * fourth.at(t); };
      at_start += of_speed2(0);
      at_end += of_speed2(1);
      const double speed = first.at(0.5);
      speed2 += speed * speed;
    }
    return std::max(std::abs(at_start), std::abs(at_end)) / (speed2 * stride(i) * stride(i) * stride(i));
  }

  Seen seen_on_curve(std::size_t i) const {
    look_at_clock(deadline_);
    double most = 0;
    for (const double t : {0.0, 0.5, 1.0}) {
      const JetMatrix<N> g = metric(i, Interval(t), {});
      const double first = largest(i, 1, [&](std::size_t e, int k, int, int) { return g[e].d(k).magnitude(); }),
                   second = largest(i, 2, [&](std::size_t e, int k, int l, int) { return g[e].d(k, l).magnitude(); });
      for (const double seen : {first, second})
        if (std::isfinite(seen)) most = std::max(most, seen);  // at a kink nothing is, which excuses nothing
    }
    return {most, of_parameter(i)};
  }

  DetailVerdict examine(const Interval& t, const Box& across, double allowed, int depth) {
    look_at_clock(deadline_);
    const auto third = [](const JetMatrix<N>& g) {
      return [&g](std::size_t e, int k, int l, int m) { return g[e].d(k, l, m).magnitude(); };
    };
    const JetMatrix<N> g = metric(segment_, t, across);
    const double most = largest(segment_, 3, third(g));
    if (most <= allowed) return DetailVerdict::none;
    constexpr int kDeepest = 6, kDeepestOfLong = 1, kDeepestKink = 2;
    if (depth >= kDeepestKink && !std::isfinite(most) && has_slopes(g)) {
      kink_ = true;
      return DetailVerdict::none;
    }
    Box middle;
    for (std::size_t k = 0; k < kAcross; ++k) middle[k] = Interval(across[k].middle());
    const JetMatrix<N> there = metric(segment_, Interval(t.middle()), middle);
    const double found = largest(segment_, 3, third(there));
    if (std::isfinite(found) && found > allowed) return DetailVerdict::found;
    if (left_ == 0 || depth == (knots_.can_divide(segment_) ? kDeepestOfLong : kDeepest))
      return DetailVerdict::undecided;
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
  const TubeKnots& knots_;
  const Deadline& deadline_;
  bool kink_ = false;
  std::vector<Seen> seen_;
  double most_seen_ = 0;
  std::size_t left_, segment_ = 0;
};

}  // namespace leastcost
