// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <leastcost/framework/errors.hpp>
#include <leastcost/framework/path_energy.hpp>
#include "framework/chain_newton.hpp"
#include "framework/curve_value.hpp"
#include "framework/spacing.hpp"

namespace leastcost {
namespace {

bool solved(Termination termination) {
  return termination == Termination::converged || termination == Termination::round_off;
}

/// Level differences below this part of the cost are rounding: the chain is exact at every N (lines, great circles).
constexpr double kExact = 1e-12;
/// The observed order may be off by this much before Richardson extrapolation is refused.
constexpr double kOrderTolerance = 0.2;
/// The same where the path rests on a bound, and only the bar is made of it.
constexpr double kHuggingOrder = 1;
/// A curve in a chart may differ from the extrapolated value by this part of the largest level difference.
constexpr double kCurveTolerance = 1e-3;

CoordinatePath sample(const Problem& problem, const CoordinatePath& chain, int segments, const Monitor& monitor) {
  return sample_equally(problem, chain, chain.ring ? segments : segments - 1, 0.05, 8, monitor.deadline);
}

double mean_cost(const Problem& problem, const CoordinatePath& path, const Monitor& monitor) {
  return PathEnergy(problem, 1, monitor.deadline).cost(path) / static_cast<double>(path.segment_count());
}

/// As a reference cost: a path may cost nothing, or infinitely much.
bool usable(double s0) { return s0 > 0 && std::isfinite(s0); }

/// Half as many segments as the first level, or about that: one more difference to judge the others by.
void solve_coarser(const Problem& problem, const CoordinatePath& chain, int segments, const Monitor& monitor,
                   Refinement& result) {
  const int least = chain.ring ? 3 : 2;
  try {
    CoordinatePath path = sample(problem, chain, std::max(least, segments / 2), monitor);
    const double s0 = mean_cost(problem, path, monitor);
    if (!usable(s0)) return;
    PathEnergy energy(problem, s0, monitor.deadline);
    if (!solved(ChainNewton().solve(energy, path, monitor).termination)) return;
    result.coarser = energy.cost(path);
    result.coarser_segments = static_cast<int>(path.segment_count());
  } catch (const InitializationError&) {
    // Too few points for this path: there is nothing to compare with.
  }
}

/// What the extrapolation R_k = (4 C_4M - C_2M) / 3 may be off. Its difference to R_{k-1} alone vanishes by chance now
/// and then: the difference before that one, which is sixteen times larger where the cost is a series in h^2, and the
/// spread of the segments, which is of the size of (h kappa)^2 and hence of the part that the fourth order is of the
/// second, must not say more.
double richardson_bar(const Refinement& refinement) {
  constexpr double kSafety = 3.0 / 15, kFall = 8, kTooCoarse = 4;
  const auto& l = refinement.levels;
  const double d24 = l[1].cost - l[2].cost;
  const double fine = (4 * l[2].cost - l[1].cost) / 3, middle = (4 * l[1].cost - l[0].cost) / 3;
  double bar = kSafety * std::abs(fine - middle);
  if (refinement.coarser) {
    const double r = static_cast<double>(l[0].segments) / refinement.coarser_segments;
    const double coarse = (r * r * l[0].cost - *refinement.coarser) / (r * r - 1);
    bar = std::max(bar, kSafety * std::abs(middle - coarse) / kFall);
  }
  if (!refinement.coarser || refinement.coarser_segments < 4) bar *= kTooCoarse;
  return std::max(bar, l[1].spacing * std::abs(d24));
}

void quote(CostEstimate& e, const char* method, double value, double error) {
  e.value = value;
  e.error = std::max(error, kExact * value);
  e.method = method;
}

}  // namespace

namespace {

/// Solves one level; false where there is nothing to solve, or it came to nothing.
bool solve_level(const Problem& problem, CoordinatePath& path, const Monitor& monitor, Refinement& result) {
  const int segments = static_cast<int>(path.segment_count());
  const std::string which = "the chain with " + std::to_string(segments) + " segments ";
  const double s0 = mean_cost(problem, path, monitor);
  if (!usable(s0)) {
    result.trouble = which + (s0 > 0 ? "costs infinitely much" : "costs nothing");
    return false;
  }
  PathEnergy energy(problem, s0, monitor.deadline);
  const SolveReport report = ChainNewton().solve(energy, path, monitor);
  const Eigen::VectorXd costs = energy.costs(path);
  result.levels.push_back({segments, costs.sum(), 0, spread(costs), report.iterations});
  result.paths.push_back(path);
  if (!solved(report.termination)) result.trouble = which + "ended with " + std::string(name(report.termination));
  result.collapsed = report.termination == Termination::collapsed;
  return !result.collapsed && !monitor.interrupted();
}

}  // namespace

Refinement refine_levels(const Problem& problem, const CoordinatePath& chain, const Monitor& monitor) {
  Refinement result;
  const int coarse = std::max(4, (static_cast<int>(chain.segment_count()) + 1) / 2);
  CoordinatePath path;
  try {
    path = sample(problem, chain, coarse, monitor);
  } catch (const InitializationError& error) {
    result.trouble = error.what();
    result.collapsed = chain.ring && chain.u == chain.u.col(0).replicate(1, chain.u.cols());
    return result;
  }
  for (int k = 0; k < 3; ++k) {
    if (k > 0) path = refine(problem, path, monitor.deadline);
    if (!solve_level(problem, path, monitor, result)) return result;
  }
  solve_coarser(problem, chain, result.levels[0].segments, monitor, result);
  // Energies of all levels at one s0, that of the middle level, so that they can be compared.
  const double s0 = result.levels[1].cost / result.levels[1].segments;
  if (!usable(s0)) {
    result.trouble = "the chain with " + std::to_string(result.levels[1].segments) + " segments costs nothing";
    return result;
  }
  PathEnergy energy(problem, s0, monitor.deadline);
  for (std::size_t k = 0; k < 3; ++k) result.levels[k].energy = energy.value(result.paths[k]);
  return result;
}

CostEstimate estimate_cost(const Problem& problem, PathEnergy& energy, const CoordinatePath& chain,
                           const Refinement& refinement, const PathIndex& index, bool hugs_bound,
                           std::vector<CertificateFailure>& failures) {
  CostEstimate e;
  const CostTraits& traits = problem.cost->traits();
  const bool flat = problem.manifold->shape() == Shape::flat;
  const bool chart = find_ability<HasChart>(*problem.manifold) != nullptr;
  const double cost = energy.cost(chain), segments = static_cast<double>(chain.segment_count());
  e.value = cost;
  const bool chords_exist = flat && traits.additive;  // the chain itself is a curve of the domain
  std::optional<double> curve =
      !chords_exist && (flat || chart) ? smooth_curve_cost(problem, chain, energy.deadline()) : std::nullopt;
  e.upper = chords_exist ? std::optional(cost) : curve;
  if (traits.below_curves && index.verdict == IndexVerdict::minimum)
    e.lower = segments * energy.reference_cost() * kernel_inverse(*problem.kernel, energy.value(chain) / segments);
  if (refinement.levels.size() < 3) {
    e.error = std::numeric_limits<double>::infinity();
    e.method = "none";
    return e;
  }
  const double c1 = refinement.levels[0].cost, c2 = refinement.levels[1].cost, c4 = refinement.levels[2].cost;
  const double d12 = c1 - c2, d24 = c2 - c4, largest = std::max(std::abs(d12), std::abs(d24));
  if (largest <= kExact * c4) {
    quote(e, "exact", c4, 0);
    return e;
  }
  if (d12 / d24 > 0) e.order = std::log2(d12 / d24);
  // Always with the factor 4: an observed order in its place would make both values equal and the bar 0.
  const double fine = (4 * c4 - c2) / 3, coarse = (4 * c2 - c1) / 3;
  const bool second_order = e.order && std::abs(*e.order - 2) <= kOrderTolerance;
  // Beside a pole a chart turns so fast that the cubic in its coordinates leaves the path, and the chains know better.
  if (chart && curve && second_order && !hugs_bound && !(std::abs(*curve - fine) <= kCurveTolerance * largest)) {
    curve.reset();
    e.upper.reset();
  }
  // Bounds that contradict each other: the chords cut what the curve goes around.
  if (e.lower && e.upper && *e.lower > *e.upper * (1 + kExact)) {
    failures.push_back(
        {"bracket", "the lower bound of the cost lies above the upper one: too few points for this path"});
    e.lower.reset();
  }
  const bool bracketed = e.lower && e.upper;
  if (bracketed) quote(e, "bracket", *e.upper, *e.upper - *e.lower);
  if (bracketed && (hugs_bound || !second_order)) return e;
  if (hugs_bound) {
    // The place where the path leaves the bound moves between the levels, an error of order 3 with any sign: no
    // extrapolated value. But at second order the last difference is three times what is left, and by how much
    // extrapolation disagrees with itself tells the rest.
    const bool near_second = e.order && std::abs(*e.order - 2) <= kHuggingOrder;
    quote(e, "differences", c4,
          near_second ? std::max(std::abs(d24), std::abs(fine - c4) + std::abs(fine - coarse)) : 2 * largest);
    return e;
  }
  if (!second_order) {
    e.error = 2 * largest;
    e.method = "differences";
    failures.push_back({"not_asymptotic", "the cost does not fall at second order between " +
                                              std::to_string(refinement.levels[0].segments) + ", " +
                                              std::to_string(refinement.levels[1].segments) + " and " +
                                              std::to_string(refinement.levels[2].segments) +
                                              " segments: no extrapolated value; use more points"});
    return e;
  }
  const double richardson = richardson_bar(refinement);
  if (!curve) {
    if (!bracketed) quote(e, "richardson", fine, richardson);
    return e;
  }
  // It has order 4 as well, and it exists: quote it, with room for both. A bracket has order 2.
  const double error = richardson + std::abs(*curve - fine);
  if (!bracketed || error < e.error) quote(e, "curve", *curve, error);
  return e;
}

}  // namespace leastcost
