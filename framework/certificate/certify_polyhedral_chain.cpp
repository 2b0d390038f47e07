// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/certificate/certify_polyhedral_chain.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <leastcost/framework/newton/refinement.hpp>
#include "framework/base/point_text.hpp"
#include "framework/certificate/shared_failures.hpp"
#include "framework/newton/bundle.hpp"

namespace leastcost {
namespace {

constexpr double kPolyhedronStationarity = 1e-6;  ///< relative cost error of an unstraightened path
constexpr double kTracedSafety = 4;  ///< of the largest difference between traced levels that do not settle
/// Levels settle where each difference is at most this part of the one before: kinks make the first order, 1/2.
constexpr double kSettles = 0.6;
constexpr double kTail = 3;  ///< of the last difference: what all finer levels may add at that rate, and twice that
constexpr double kLuckyFall = 4;  ///< a difference that falls faster than at second order does so by chance
constexpr int kBundleSteps = 20;

/// On a polyhedron no single gradient need be small at a minimiser: what counts is how far a bundle of them can still
/// lower the energy.
void measure_kinked_stationarity(PathEnergy& energy, const CoordinatePath& chain, const Monitor& monitor,
                                 Certificate& c) {
  CoordinatePath path = chain;
  const double scale = energy.scale(path);
  double gained = 0;
  BundleStep step{true, 0, 0};
  for (int i = 0; i < kBundleSteps && step.lowered && !monitor.interrupted(); ++i) {
    step = bundle_step(energy, path, kPolyhedronStationarity / 10);
    gained += step.decrease;
  }
  c.stationarity = gained / scale + step.cost_error;
  check_stationarity(c, kPolyhedronStationarity);
}

/// What the cost of the delivered curve may be off that of the path which ever finer levels come to. `traced`: costs of
/// the levels' curves; `chain`: that of the moves of the finest one, which comes to the same in the end.
double traced_bar(double delivered, const std::vector<double>& traced, double chain, double spread) {
  const double unsettled = kTracedSafety * spread;
  if (traced.size() < 3) return unsettled;
  const double d12 = traced[0] - traced[1], d24 = traced[1] - traced[2];
  if (!(d12 * d24 >= 0 && std::abs(d24) <= kSettles * std::abs(d12))) return unsettled;
  const double last = std::max({std::abs(d24), std::abs(d12) / kLuckyFall, std::abs(delivered - traced[1])});
  const double settled = std::max(std::abs(delivered - traced[2]) + kTail * last, std::abs(traced[2] - chain));
  return std::min(unsettled, settled);
}

}  // namespace

void certify_polyhedral_chain(const Problem& problem, PathEnergy& energy, const PostProcessed& path,
                              const ToCurve& to_curve, const Monitor& monitor, Certificate& c) {
  c.scope = Scope::chain_on_polyhedron;
  measure_kinked_stationarity(energy, path.chain, monitor, c);
  std::vector<double> values;
  const Refinement refinement = refine_levels(problem, path.chain, monitor);
  c.levels = refinement.levels;
  for (const CoordinatePath& level : refinement.paths) {
    if (monitor.interrupted()) return;
    values.push_back(to_curve(level).curve.cost);
  }
  const std::vector<double> traced = values;
  const double finest = c.levels.empty() ? path.curve.cost : c.levels.back().cost;
  values.push_back(path.curve.cost);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  c.estimate.method = ValueMethod::traced;
  c.estimate.error = traced_bar(path.curve.cost, traced, finest, *most - *least) + *c.stationarity * path.curve.cost;
  if (refinement.levels.size() < 3)
    c.failures.push_back({refinement.collapsed ? Failure::collapsed : Failure::refinement, refinement.trouble});
  else if (!(c.estimate.error <= kPolyhedronError * path.curve.cost))
    c.failures.push_back(
        {Failure::error_bar, "the traced cost varies by " + short_number((*most - *least) / path.curve.cost) +
                                 " (relative) between " + std::to_string(refinement.levels[0].segments) + " and " +
                                 std::to_string(refinement.levels[2].segments) + " segments; use more points"});
  const auto& levels = c.levels;
  // Kinks push points along the path wherever they meet them: more points even out, at last or step by step.
  const bool falling = levels.size() == 3 && levels[2].spacing < levels[1].spacing &&
                       (levels[1].spacing < levels[0].spacing || levels[2].spacing <= kPolyhedronSpacing);
  if (!(c.spacing <= kPolyhedronSpacing) && !falling) fail_spacing(c, kPolyhedronSpacing);
}

}  // namespace leastcost
