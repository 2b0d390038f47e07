// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/proof/calibrate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/newton/path_index.hpp>
#include "framework/proof/tube_knots.hpp"
#include "framework/proof/tube_metric.hpp"
#include "framework/proof/tube_proof.hpp"

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

template <int N, int D>
Calibration calibrate_in(const Problem& problem, const CoordinatePath& chain, const CalibrationOptions& options,
                         const Deadline& deadline) {
  const TubeMetric<N, D> metric(problem);
  if constexpr (D == N)
    if (!chain.ring)
      if (const std::optional<Calibration> constant = calibrate_constant(metric, chain)) return *constant;
  const double enough = std::max(kLeastGap, options.gap / 2);
  TubeKnots knots(chain, enough);
  for (;;) {
    TubeProof<N, D> proof(metric, chain, knots, options, enough, deadline);
    proof.run();
    if (!knots.divide(proof.parts())) return proof.result();
  }
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
