// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "framework/extremal_field.hpp"
#include "framework/tube.hpp"
#include "framework/tube_bounds.hpp"

namespace leastcost {
namespace {

constexpr double kLeastGap = 1e-12;  ///< relative
constexpr double kSteep = 1.5;       ///< how much the speed of the curve may vary within one of its segments
constexpr double kFarPositive = 4;   ///< of the margin: what a wide tube or intervals too wide do not explain

Calibration failed(Calibration out, Index segment, std::string why) {
  out.segment = segment;
  out.trouble = std::move(why);
  return out;
}

/// Under a constant metric the straight line is the least of all paths, and nothing is hidden.
template <int N>
std::optional<Calibration> calibrate_constant(const TubeMetric<N>& metric, const CoordinatePath& chain) {
  JetPoint<N> box;
  for (int i = 0; i < N; ++i)
    box[static_cast<std::size_t>(i)] =
        IntervalJet<N>::variable({chain.u.row(i).minCoeff(), chain.u.row(i).maxCoeff()}, i);
  const JetMatrix<N> g = metric(box);
  if (!std::all_of(g.begin(), g.end(), [](const IntervalJet<N>& entry) { return entry.is_constant(); })) return {};
  Interval squared(0);
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) {
      const auto move = [&](int k) { return Interval(chain.u(k, chain.u.cols() - 1)) - Interval(chain.u(k, 0)); };
      squared += g[static_cast<std::size_t>(N * i + j)].value() * (i == j ? square(move(i)) : move(i) * move(j));
    }
  const Interval cost = sqrt(squared);
  Calibration out;
  out.applies = out.proved = cost.is_finite() && cost.lo > 0;
  out.lower = cost.lo;
  out.upper = out.half_width = cost.hi;
  return out;
}

/// Bounds for a field that is there.
template <int N>
Calibration calibrate_with(const TubeField<N>& field, const Tube<N>& tube, const ExtremalField<N>& extremals,
                           const CalibrationOptions& options, Calibration out, const Deadline& deadline) {
  TubeBounds<N> bounds(field, extremals.margin(), tube.segments.size(), deadline);
  const double enough = std::max(kLeastGap, options.gap / 2);
  const double enough_of_cost =
      std::max(kLeastGap, enough / 10) * tube.cost / static_cast<double>(tube.segments.size());
  Interval curve(0);
  double loss = 0, worst = 0;
  for (std::size_t i = 0; i < tube.segments.size(); ++i) {
    const auto n = static_cast<Index>(i);
    const double curvature = bounds.mean_curvature(tube.segments[i], tube.widths[n]);
    if (!(curvature < 0)) {
      const Interval speed = field.on_curve(tube.segments[i], {0, 1}).speed.value();
      out.contradicted = (std::isfinite(curvature) && curvature > kFarPositive * 2 * extremals.margin()) ||
                         (speed.lo > 0 && speed.is_finite() && speed.hi > kSteep * speed.lo);
      return failed(out, n, "the cost is not resolved, or a path nearby is cheaper");
    }
    const double excess = bounds.squared_slope(tube.segments[i], -2 * curvature * enough) / (-2 * curvature);
    worst = std::max(worst, excess);
    loss += excess * tube.costs[n];
    curve += bounds.curve_cost(tube.segments[i], {0, 1}, enough_of_cost);
  }
  out.gap = extremals.varies_little_across() ? loss / tube.cost : worst;
  out.upper = curve.hi;
  out.lower = curve.lo * (1 - out.gap);
  out.proved = std::isfinite(out.lower) && std::isfinite(out.upper);
  return out.proved ? out : failed(out, 0, "the cost of the curve has no bounds");
}

template <int N>
Calibration calibrate_in(const Problem& problem, const CoordinatePath& chain, const CalibrationOptions& options,
                         const Deadline& deadline) {
  Calibration out;
  out.applies = true;
  const TubeMetric<N> metric(problem);
  if (const std::optional<Calibration> constant = calibrate_constant(metric, chain)) return *constant;
  const TubeField<N> field(metric);
  Tube<N> tube(metric, chain, options.segments, deadline);
  if (tube.trouble) {
    out.applies = !tube.trouble->at_singular_end;
    return failed(out, tube.trouble->segment, tube.trouble->why);
  }
  out.half_width = tube.widths.minCoeff();
  ExtremalField<N> extremals(field, tube, deadline);
  if (!extremals.exists())
    return failed(out, -1, "no field of extremals: the path is not a strict minimum, or nearly not");
  Calibration found = calibrate_with(field, tube, extremals, options, out, deadline);
  if (found.proved || found.contradicted) return found;
  extremals.add_third_derivatives();
  return calibrate_with(field, tube, extremals, options, out, deadline);
}

}  // namespace

Calibration calibrate(const Problem& problem, const CoordinatePath& chain, const CalibrationOptions& options,
                      const Deadline& deadline) {
  if (chain.ring) return {};
  if (TubeMetric<2>::exists(problem)) return calibrate_in<2>(problem, chain, options, deadline);
  if (TubeMetric<3>::exists(problem)) return calibrate_in<3>(problem, chain, options, deadline);
  return {};
}

}  // namespace leastcost
