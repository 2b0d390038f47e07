// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>
#include "framework/proof/calibration.hpp"
#include "framework/proof/extremal_field.hpp"
#include "framework/proof/tube.hpp"
#include "framework/proof/tube_bounds.hpp"
#include "framework/proof/tube_details.hpp"
#include "framework/proof/tube_knots.hpp"

namespace leastcost {

/// The proof of framework/proof/calibration.hpp on a tube with given joints. Where it fails in segments that can be
/// divided, parts() says so, and what is found is not the last word.
template <int N, int D>
class TubeProof {
 public:
  /// `enough`: a gap, relative to the cost, that needs no more effort.
  TubeProof(const TubeMetric<N, D>& metric, const CoordinatePath& chain, const TubeKnots& knots,
            const CalibrationOptions& options, double enough, const Deadline& deadline)
      : field_(metric),
        knots_(knots),
        enough_(enough),
        deadline_(deadline),
        tube_(metric, chain, knots, options.segments, deadline),
        bounds_(field_, options.boxes * static_cast<Index>(knots.segment_count()), deadline),
        parts_(knots.segment_count(), 1) {}

  /// Throws Interrupted.
  void run() {
    if (!has_tube()) return;
    find_gap();
    if (!any_divided()) find_details();
  }

  /// In how many parts to divide each segment, and try again; all 1 where more of them would not help.
  const std::vector<int>& parts() const { return parts_; }

  /// With the cost of the curve, enclosed to a part of the gap. Throws Interrupted.
  Calibration result() {
    if (!tube_.exists() || out_.details == DetailVerdict::found) return out_;
    const double enough = uncertainty();
    Interval curve(0), loss(0);
    for (std::size_t n = 0; n < tube_.segments.size(); ++n) {
      const Interval cost = bounds_.curve_cost(tube_.segments[n], {0, 1}, enough);
      curve += cost;
      if (proved_) loss += cost * Interval(excess_[n]);
    }
    if (curve.is_finite()) out_.upper = curve.hi;
    if (!proved_) return out_;
    out_.gap = averages_ ? loss.hi / curve.lo : worst();
    out_.lower = curve.lo * (1 - out_.gap);
    out_.proved = std::isfinite(out_.lower) && out_.upper;
    return out_;
  }

 private:
  /// False where segment n cannot be divided.
  bool divide(std::size_t n, int parts = 2) {
    if (!knots_.can_divide(n)) return false;
    parts_[n] = parts;
    return true;
  }
  bool any_divided() const {
    return std::any_of(parts_.begin(), parts_.end(), [](int parts) { return parts > 1; });
  }
  void divide_none() { parts_.assign(parts_.size(), 1); }

  bool has_tube() {
    out_.applies = tube_.exists() || tube_.torn;
    if (tube_.torn) {
      out_.detail = knots_[static_cast<std::size_t>(*tube_.torn)];
      divide(static_cast<std::size_t>(*tube_.torn));
    }
    out_.segments = static_cast<Index>(knots_.segment_count());
    if (tube_.exists()) out_.half_width = tube_.widths.minCoeff();
    return tube_.exists();
  }

  void find_details() {
    TubeDetails<N, D> details(field_, tube_, knots_, deadline_);
    out_.details = DetailVerdict::none;
    for (std::size_t n = 0; n < tube_.segments.size(); ++n) {
      const DetailVerdict verdict = details.examine(n);
      if (verdict == DetailVerdict::none) continue;
      if (verdict == DetailVerdict::kink) {
        out_.details = DetailVerdict::kink;
      } else if (!divide(n)) {
        divide_none();
        out_.details = verdict;
        out_.detail = knots_[n];
        return;
      }
    }
  }

  void find_gap() {
    ExtremalField<N, D> extremals(field_, tube_, deadline_);
    if (!extremals.exists()) {  // the steps of the integration may have been too long
      if (tube_.segments.size() < kFewSteps)
        for (std::size_t n = 0; n < tube_.segments.size(); ++n) divide(n);
      return;
    }
    if (!tube_.ring() && !is_concave()) extremals.add_third_derivatives();
    find_gap(extremals);
  }

  double worst() const { return *std::max_element(excess_.begin(), excess_.end()); }

  /// Of the cost of a segment: little of what is not known anyway.
  double uncertainty() const {
    constexpr double kPart = 0.02;
    double gap = enough_;
    if (proved_) {
      double loss = 0;
      for (std::size_t n = 0; n < excess_.size(); ++n) loss += excess_[n] * tube_.costs[static_cast<Index>(n)];
      gap = std::max(gap, averages_ ? loss / tube_.cost : worst());
    }
    return std::max(kLeastGap, kPart * gap) * tube_.cost / static_cast<double>(tube_.segments.size());
  }

  /// Not proved where the bounds are too wide, or a path nearby is cheaper.
  void find_gap(const ExtremalField<N, D>& extremals) {
    std::vector<typename TubeBounds<N, D>::Curvature> found;
    for (std::size_t n = 0; n < tube_.segments.size(); ++n) {
      const double width = tube_.widths[static_cast<Index>(n)];
      found.push_back(bounds_.mean_curvature(tube_.segments[n], width, extremals.margin(), knots_.can_divide(n)));
      if (found.back().parts == 1 && found.back().bound < 0) continue;
      if (!divide(n, std::max(2, found.back().parts))) return divide_none();
    }
    if (any_divided()) return;
    for (std::size_t n = 0; n < found.size(); ++n) {
      const double twice = -2 * found[n].bound;
      excess_.push_back(bounds_.squared_slope(tube_.segments[n], found[n].on_curve, twice * enough_) / twice);
    }
    averages_ = !tube_.ring() && extremals.varies_little_across();
    proved_ = true;
  }

  /// Whether f is concave across the curve at the sides of the tube, looked at in the middle of each segment.
  bool is_concave() const {
    for (std::size_t i = 0; i < tube_.segments.size(); ++i) {
      look_at_clock(deadline_);
      const typename TubeField<N, D>::OnCurve curve = field_.on_curve(tube_.segments[i], Interval(0.5));
      const double w = tube_.widths[static_cast<Index>(i)];
      for (int corner = 0; corner < 1 << (N - 1); ++corner) {
        std::array<Interval, N - 1> z;
        for (std::size_t k = 0; k < z.size(); ++k) z[k] = Interval(corner >> k & 1 ? w : -w);
        const IntervalJet<N> f = field_.squared_norm(tube_.segments[i], curve, Interval(0.5), z);
        for (int k = 1; k < N; ++k)
          if (!(f.d(k, k).hi < 0)) return false;
      }
    }
    return true;
  }

  static constexpr double kLeastGap = 1e-12;     ///< relative
  static constexpr std::size_t kFewSteps = 128;  ///< of a Riccati equation

  const TubeField<N, D> field_;
  const TubeKnots& knots_;
  double enough_;
  const Deadline& deadline_;
  Tube<N, D> tube_;
  TubeBounds<N, D> bounds_;
  std::vector<int> parts_;
  bool proved_ = false;
  std::vector<double> excess_;  ///< where proved: f <= 1 + that, in each segment
  bool averages_ = false;       ///< the gap is the mean of the excess, not its maximum
  Calibration out_;
};

}  // namespace leastcost
