// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "framework/extremal_field.hpp"
#include "framework/tube.hpp"
#include "framework/tube_bounds.hpp"

namespace leastcost {
namespace {

constexpr double kLeastGap = 1e-12;  ///< relative

Calibration failed(Calibration out, Index segment, std::string why) {
  out.segment = segment;
  out.trouble = std::move(why);
  return out;
}

template <int N>
Calibration calibrate_in(const Problem& problem, const CoordinatePath& chain, const CalibrationOptions& options,
                         const Deadline& deadline) {
  Calibration out;
  out.applies = true;
  const TubeMetric<N> metric(problem);
  const TubeField<N> field(metric);
  Tube<N> tube(metric, chain, options.segments, deadline);
  if (tube.trouble) return failed(out, tube.trouble->segment, tube.trouble->why);
  out.half_width = tube.widths.minCoeff();
  const ExtremalField<N> extremals(field, tube, deadline);
  if (!extremals.exists())
    return failed(out, -1, "no field of extremals: the path is not a strict minimum, or nearly not");

  TubeBounds<N> bounds(field, extremals.margin(), tube.segments.size(), deadline);
  const double enough = std::max(kLeastGap, options.gap / 2);
  const double enough_of_cost =
      std::max(kLeastGap, enough / 10) * tube.cost / static_cast<double>(tube.segments.size());
  Interval curve(0);
  double loss = 0, worst = 0;
  for (std::size_t i = 0; i < tube.segments.size(); ++i) {
    const auto n = static_cast<Index>(i);
    const double curvature = bounds.mean_curvature(tube.segments[i], tube.widths[n]);
    if (!(curvature < 0)) return failed(out, n, "the cost is not resolved, or a path nearby is cheaper");
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

}  // namespace

Calibration calibrate(const Problem& problem, const CoordinatePath& chain, const CalibrationOptions& options,
                      const Deadline& deadline) {
  if (chain.ring) return {};
  if (TubeMetric<2>::exists(problem)) return calibrate_in<2>(problem, chain, options, deadline);
  if (TubeMetric<3>::exists(problem)) return calibrate_in<3>(problem, chain, options, deadline);
  return {};
}

}  // namespace leastcost
