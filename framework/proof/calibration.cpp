// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/proof/calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/newton/path_index.hpp>
#include "framework/proof/extremal_field.hpp"
#include "framework/proof/tube.hpp"
#include "framework/proof/tube_bounds.hpp"
#include "framework/proof/tube_details.hpp"

namespace leastcost {
namespace {

constexpr double kLeastGap = 1e-12;  ///< relative

/// The straight line between the ends of a chain under a constant metric: the least of all paths, with nothing hidden.
/// `metric(i, j)`: an entry, as an interval.
template <class Metric>
Calibration straight_line(const CoordinatePath& chain, const Metric& metric) {
  Interval squared(0);
  const auto move = [&](Index k) { return Interval(chain.u(k, chain.u.cols() - 1)) - Interval(chain.u(k, 0)); };
  for (Index i = 0; i < chain.u.rows(); ++i)
    for (Index j = 0; j < chain.u.rows(); ++j) squared += metric(i, j) * (i == j ? square(move(i)) : move(i) * move(j));
  const Interval cost = sqrt(squared);
  Calibration out;
  out.applies = out.proved = cost.is_finite() && cost.lo > 0;
  out.details = DetailVerdict::none;
  out.lower = cost.lo;
  out.half_width = cost.hi;
  out.upper = cost.hi;
  return out;
}

/// Under a metric by formula that turns out to be constant.
template <int N, int D>
std::optional<Calibration> calibrate_constant(const TubeMetric<N, D>& metric, const CoordinatePath& chain) {
  constexpr double kFar = 1e9;  // times the coordinates: a formula may be constant on the path and not beside it
  const double far = kFar * (1 + chain.u.cwiseAbs().maxCoeff());
  JetPoint<N> everywhere;
  for (int i = 0; i < N; ++i) everywhere[static_cast<std::size_t>(i)] = IntervalJet<N>::variable({-far, far}, i);
  const JetMatrix<N> g = metric(everywhere);
  if (!std::all_of(g.begin(), g.end(), [](const IntervalJet<N>& entry) { return entry.is_constant(); })) return {};
  return straight_line(chain, [&g](Index i, Index j) { return g[static_cast<std::size_t>(N * i + j)].value(); });
}

/// The cost of the curve, to what `enough` of it is.
template <int N, int D>
Interval curve_cost(TubeBounds<N, D>& bounds, const Tube<N, D>& tube, double enough) {
  Interval sum(0);
  for (const TubeSegment<N, D>& segment : tube.segments)
    sum += bounds.curve_cost(segment, {0, 1}, enough * tube.cost / static_cast<double>(tube.segments.size()));
  return sum;
}

/// The bounds of the proof, for a field that is there. Not proved where they are too wide, or a path nearby is cheaper.
template <int N, int D>
Calibration prove(TubeBounds<N, D>& bounds, const Tube<N, D>& tube, const ExtremalField<N, D>& extremals,
                  const Interval& curve, double enough, Calibration out) {
  double loss = 0, worst = 0;
  for (std::size_t i = 0; i < tube.segments.size(); ++i) {
    const auto n = static_cast<Index>(i);
    const double curvature = bounds.mean_curvature(tube.segments[i], tube.widths[n], extremals.margin());
    if (!(curvature < 0)) return out;
    const double excess = bounds.squared_slope(tube.segments[i], -2 * curvature * enough) / (-2 * curvature);
    worst = std::max(worst, excess);
    loss += excess * tube.costs[n];
  }
  out.gap = !tube.ring() && extremals.varies_little_across() ? loss / tube.cost : worst;
  out.lower = curve.lo * (1 - out.gap);
  out.proved = std::isfinite(out.lower) && out.upper;
  return out;
}

/// Whether f is concave across the curve at the sides of the tube, looked at in the middle of each segment.
template <int N, int D>
bool concave(const TubeField<N, D>& field, const Tube<N, D>& tube, const Deadline& deadline) {
  for (std::size_t i = 0; i < tube.segments.size(); ++i) {
    look_at_clock(deadline);
    const typename TubeField<N, D>::OnCurve curve = field.on_curve(tube.segments[i], Interval(0.5));
    const double w = tube.widths[static_cast<Index>(i)];
    for (int corner = 0; corner < 1 << (N - 1); ++corner) {
      std::array<Interval, N - 1> z;
      for (std::size_t k = 0; k < z.size(); ++k) z[k] = Interval(corner >> k & 1 ? w : -w);
      const IntervalJet<N> f = field.squared_norm(tube.segments[i], curve, Interval(0.5), z);
      for (int k = 1; k < N; ++k)
        if (!(f.d(k, k).hi < 0)) return false;
    }
  }
  return true;
}

template <int N, int D>
Calibration calibrate_in(const Problem& problem, const CoordinatePath& chain, const CalibrationOptions& options,
                         const Deadline& deadline) {
  Calibration out;
  const TubeMetric<N, D> metric(problem);
  if constexpr (D == N)
    if (!chain.ring)
      if (const std::optional<Calibration> constant = calibrate_constant(metric, chain)) return *constant;
  const TubeField<N, D> field(metric);
  Tube<N, D> tube(metric, chain, options.segments, deadline);
  out.applies = tube.exists() || tube.torn;
  out.detail = tube.torn.value_or(0);
  if (!tube.exists()) return out;
  out.half_width = tube.widths.minCoeff();
  TubeDetails<N, D> details(field, tube, deadline);
  out.details = details.examine();
  out.detail = details.segment();
  if (out.details == DetailVerdict::found) return out;
  TubeBounds<N, D> bounds(field, options.boxes * static_cast<Index>(tube.segments.size()), deadline);
  const double enough = std::max(kLeastGap, options.gap / 2);
  const Interval curve = curve_cost(bounds, tube, std::max(kLeastGap, enough / 10));
  if (curve.is_finite()) out.upper = curve.hi;
  ExtremalField<N, D> extremals(field, tube, deadline);
  if (!extremals.exists()) return out;
  if (!tube.ring() && !concave(field, tube, deadline)) extremals.add_third_derivatives();
  return prove(bounds, tube, extremals, curve, enough, out);
}

}  // namespace

bool can_calibrate(const Problem& problem) {
  return is_convex(problem) || TubeMetric<2, 2>::exists(problem) || TubeMetric<3, 3>::exists(problem) ||
         TubeMetric<2, 3>::exists(problem);
}

Calibration calibrate(const Problem& problem, const CoordinatePath& chain, const CalibrationOptions& options,
                      const Deadline& deadline) {
  if (chain.ring) {
    const bool turned = !chain.closing.identity() && !(chain.closing.sign.array() == 1).all();  // a Moebius strip
    if (turned) return {};
    if (TubeMetric<2, 2>::exists(problem)) return calibrate_in<2, 2>(problem, chain, options, deadline);
    if (TubeMetric<2, 3>::exists(problem)) return calibrate_in<2, 3>(problem, chain, options, deadline);
    return {};
  }
  if (is_convex(problem)) {  // in any number of coordinates
    const Eigen::MatrixXd g = find_ability<HasConstantMetric>(*problem.cost)->metric();
    return straight_line(chain, [&g](Index i, Index j) { return Interval(g(i, j)); });
  }
  if (TubeMetric<2, 2>::exists(problem)) return calibrate_in<2, 2>(problem, chain, options, deadline);
  if (TubeMetric<3, 3>::exists(problem)) return calibrate_in<3, 3>(problem, chain, options, deadline);
  if (TubeMetric<2, 3>::exists(problem)) return calibrate_in<2, 3>(problem, chain, options, deadline);
  return {};
}

}  // namespace leastcost
