// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/certificate/cost_estimate.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <leastcost/framework/domain/fits_segments.hpp>
#include "framework/energy/curve_value.hpp"
#include "framework/problem/place_rounding.hpp"

namespace leastcost {
namespace {

/// Level differences below this part of the cost are rounding: the chain is exact at every N (lines, great circles).
constexpr double kExact = 1e-12;
/// The observed order may be off by this much before Richardson extrapolation is refused.
constexpr double kOrderTolerance = 0.2;
/// The same where the path rests on a bound, and only the bar is made of it.
constexpr double kHuggingOrder = 1;
/// A curve in a chart may differ from the extrapolated value by this part of the largest level difference.
constexpr double kCurveTolerance = 1e-3;

/// What the extrapolation R_k = (4 C_4M - C_2M) / 3 may be off. Its difference to R_{k-1} alone vanishes by chance now
/// and then: the difference before that one, which is sixteen times larger where the cost is a series in h^2, and the
/// spread of the segments, which is of the size of (h kappa)^2 and hence of the part that the fourth order is of the
/// second, must not say more.
double richardson_bar(const Refinement& refinement) {
  constexpr double kSafety = 3.0 / 15, kFall = 8, kTooCoarse = 4;
  constexpr int kFewest = 6;  // segments of the coarsest chain: fewer say little about orders
  const auto& l = refinement.levels;
  const double d24 = l[1].cost - l[2].cost;
  const double fine = (4 * l[2].cost - l[1].cost) / 3, middle = (4 * l[1].cost - l[0].cost) / 3;
  double bar = kSafety * std::abs(fine - middle);
  if (refinement.coarser) {
    const double r = static_cast<double>(l[0].segments) / refinement.coarser_segments;
    const double coarse = (r * r * l[0].cost - *refinement.coarser) / (r * r - 1);
    bar = std::max(bar, kSafety * std::abs(middle - coarse) / kFall);
  }
  if (!refinement.coarser || refinement.coarser_segments < kFewest) bar *= kTooCoarse;
  return std::max(bar, l[1].spacing * std::abs(d24));
}

void quote(CostEstimate& e, ValueMethod method, double value, double error) {
  e.value = value;
  e.error = std::max(error, kExact * value);
  e.method = method;
}

/// What rounding leaves of the sum of costs sqrt(d'Gd): the terms of an ill-conditioned G cancel. 0 where there is no
/// such G, and on curved domains, whose chords are no moves in coordinates.
double rounding_of_costs(const Problem& problem, PathEnergy& energy, const CoordinatePath& chain) {
  constexpr double kOperations = 4;
  if (problem.manifold->shape() != Shape::flat) return 0;
  if (find_ability<HasChart>(*problem.manifold) != nullptr) return 0;
  Points metrics;
  energy.metrics(chain, metrics);
  const Eigen::VectorXd costs = energy.costs(chain);
  const Index d = chain.u.rows();
  double sum = 0;
  for (Index i = 0; i < costs.size(); ++i) {
    const Eigen::VectorXd move = (chain.column(i + 1) - chain.column(i)).cwiseAbs();
    const double terms = move.dot(metrics.middleCols(d * i, d).cwiseAbs() * move);
    if (std::isfinite(terms) && costs[i] > 0) sum += terms / (2 * costs[i]);
  }
  return kOperations * std::numeric_limits<double>::epsilon() * sum;
}

/// Relative: along a path what is rounded of a place goes from one segment to the next, and the ends remain.
double rounding_of_ends(const Problem& problem, const CoordinatePath& chain) {
  constexpr double kOperations = 4;
  return kOperations * place_rounding(problem, chain) / static_cast<double>(chain.segment_count());
}

EstimatedCost estimate_from_levels(const Problem& problem, PathEnergy& energy, const CoordinatePath& chain,
                                   const Refinement& refinement, const PathIndex& index, bool hugs_bound) {
  EstimatedCost out;
  CostEstimate& e = out.estimate;
  const CostTraits& traits = problem.cost->traits();
  const bool flat = problem.manifold->shape() == Shape::flat;
  const HasChart* chart = find_ability<HasChart>(*problem.manifold);
  const double cost = energy.cost(chain), segments = static_cast<double>(chain.segment_count());
  e.value = cost;
  const bool chords_exist = flat && traits.additive;  // the chain itself is a curve of the domain
  std::optional<double> curve =
      !chords_exist && (flat || chart != nullptr) ? smooth_curve_cost(problem, chain, energy.deadline()) : std::nullopt;
  e.upper = chords_exist ? std::optional(cost) : curve;
  // Among obstacles points keep a margin, and the least chain may be longer than the least curve.
  const bool keeps_margins = find_ability<FitsSegments>(*problem.manifold) != nullptr;
  if (traits.below_curves && index.verdict == IndexVerdict::minimum && !keeps_margins)
    e.lower = segments * energy.reference_cost() * kernel_inverse(*problem.kernel, energy.value(chain) / segments);
  if (refinement.levels.size() < 3) {
    e.error = std::numeric_limits<double>::infinity();
    e.method = ValueMethod::none;
    return out;
  }
  const double c1 = refinement.levels[0].cost, c2 = refinement.levels[1].cost, c4 = refinement.levels[2].cost;
  const double d12 = c1 - c2, d24 = c2 - c4, largest = std::max(std::abs(d12), std::abs(d24));
  const double rounding = rounding_of_ends(problem, chain);
  if (largest <= std::max(kExact, rounding) * c4) {
    quote(e, ValueMethod::exact, c4, rounding * c4);
    return out;
  }
  if (d12 / d24 > 0) e.order = std::log2(d12 / d24);
  // Always with the factor 4: an observed order in its place would make both values equal and the bar 0.
  const double fine = (4 * c4 - c2) / 3, coarse = (4 * c2 - c1) / 3;
  const auto finest_curve = [&] {
    if (chords_exist) return c4;
    return smooth_curve_cost(problem, refinement.paths[2], energy.deadline()).value_or(*e.upper);
  };
  const bool second_order = e.order && std::abs(*e.order - 2) <= kOrderTolerance;
  // Beside a pole a chart turns so fast that the cubic in its coordinates leaves the path, and the chains know better.
  double beside = 0;
  if (chart != nullptr && curve && second_order && !hugs_bound &&
      !(std::abs(*curve - fine) <= kCurveTolerance * largest)) {
    curve.reset();
    e.upper.reset();
    if (chart->poles().empty())  // then it is the points that are few, and the finest chain has four times as many
      beside = std::abs(smooth_curve_cost(problem, refinement.paths[2], energy.deadline()).value_or(fine) - fine);
  }
  // Bounds that contradict each other: the chords cut what the curve goes around. The curve through the finest chain
  // has a say as well: of few points the least chain may lie in a valley of its own, and bounds nothing else.
  if (e.lower && e.upper && *e.lower > std::min(*e.upper, finest_curve()) * (1 + kExact)) {
    out.failures.push_back({Failure::bracket, "the lower bound of the cost is above the upper bound: use more points"});
    e.lower.reset();
  }
  const bool bracketed = e.lower && e.upper;
  if (bracketed) quote(e, ValueMethod::bracket, *e.upper, *e.upper - *e.lower);
  if (bracketed && (hugs_bound || !second_order)) return out;
  if (hugs_bound) {
    // The place where the path leaves the bound moves between the levels, an error of order 3 with any sign: no
    // extrapolated value. But at second order the last difference is three times what is left, and by how much
    // extrapolation disagrees with itself tells the rest.
    const bool near_second = e.order && std::abs(*e.order - 2) <= kHuggingOrder;
    quote(e, ValueMethod::differences, c4,
          near_second ? std::max(std::abs(d24), std::abs(fine - c4) + std::abs(fine - coarse)) : 2 * largest);
    return out;
  }
  if (!second_order) {
    e.error = 2 * largest;
    e.method = ValueMethod::differences;
    out.failures.push_back({Failure::not_asymptotic, "the cost does not fall at second order between " +
                                                         std::to_string(refinement.levels[0].segments) + ", " +
                                                         std::to_string(refinement.levels[1].segments) + " and " +
                                                         std::to_string(refinement.levels[2].segments) +
                                                         " segments: no extrapolated value; use more points"});
    return out;
  }
  const double richardson = richardson_bar(refinement);
  if (!curve) {
    if (!bracketed) quote(e, ValueMethod::richardson, fine, std::max(richardson, beside));
    return out;
  }
  // It has order 4 as well, and it exists: quote it, with room for both. A bracket has order 2.
  const double error = richardson + std::abs(*curve - fine);
  if (!bracketed || error < e.error) quote(e, ValueMethod::curve, *curve, error);
  return out;
}

}  // namespace

Words<ValueMethod> words(ValueMethod) {
  using enum ValueMethod;
  static constexpr Word<ValueMethod> kWords[] = {{unmeasured, ""},
                                                 {none, "none"},
                                                 {exact, "exact"},
                                                 {bracket, "bracket"},
                                                 {curve, "curve"},
                                                 {richardson, "richardson"},
                                                 {traced, "traced"},
                                                 {straightened, "straightened"},
                                                 {differences, "differences"}};
  return kWords;
}

EstimatedCost estimate_cost(const Problem& problem, PathEnergy& energy, const CoordinatePath& chain,
                            const Refinement& refinement, const PathIndex& index, bool hugs_bound) {
  EstimatedCost out = estimate_from_levels(problem, energy, chain, refinement, index, hugs_bound);
  const double rounding = std::max(rounding_of_costs(problem, energy, chain),
                                   rounding_of_ends(problem, chain) * std::abs(out.estimate.value));
  out.estimate.error = std::max(out.estimate.error, rounding);
  return out;
}

}  // namespace leastcost
