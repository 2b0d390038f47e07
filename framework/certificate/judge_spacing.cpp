// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/certificate/judge_spacing.hpp"

#include <algorithm>

#include <leastcost/framework/domain/fits_segments.hpp>
#include "framework/base/point_text.hpp"
#include "framework/certificate/shared_failures.hpp"

namespace leastcost {
namespace {

constexpr double kSpacingFall = 3;   ///< second order halves the step and quarters the spread; 3 leaves room
constexpr double kGentleFall = 2.2;  ///< of a small spread: a bend sharper than a segment is met at places that differ
constexpr double kSmallSpread = 0.05;  ///< as for an unstraightened path on a polyhedron
constexpr double kWidestSpread = 1;    ///< a segment of twice the cost of another: not equally spaced in any sense
constexpr double kBoundJitter = 4;     ///< room for where points happen to meet a bound

/// The spread of the segments falls with the stiffness of the kernel along the path. The levels have s = 1 in the
/// mean; the delivered chain has less where its reference cost comes from a longer first path, and an exponential
/// kernel is then up to three times less stiff.
double softer_than_levels(const Problem& problem, PathEnergy& energy, const CoordinatePath& chain) {
  const double s = energy.cost(chain) / static_cast<double>(chain.segment_count()) / energy.reference_cost();
  const double stiffness = kernel_stiffness(*problem.kernel, s);
  return stiffness > 0 ? std::max(1.0, kernel_stiffness(*problem.kernel, 1) / stiffness) : 1;
}

}  // namespace

/// Exactly equal where the cost is additive along the path; elsewhere as unequal as the discretisation makes it,
/// which falls at second order.
void judge_spacing(const Problem& problem, PathEnergy& energy, const CoordinatePath& chain,
                   const CertificateOptions& options, bool hugs_bound, Certificate& c) {
  if (c.spacing <= options.spacing) return;
  const bool additive = problem.cost->traits().additive && problem.manifold->shape() == Shape::flat && !hugs_bound;
  if (additive || c.levels.size() < 3) return fail_spacing(c, options.spacing);
  if (!(c.spacing <= kWidestSpread)) return fail_spacing(c, kWidestSpread);
  // Walls push points along the path wherever moves of that length meet them: what is unequal need not even out.
  if (hugs_bound && find_ability<FitsSegments>(*problem.manifold) != nullptr) return;
  const double s1 = c.levels[0].spacing, s2 = c.levels[1].spacing, s4 = c.levels[2].spacing;
  bool falls = s2 <= options.spacing || (s1 / s2 >= kSpacingFall && s2 / s4 >= kSpacingFall) ||
               (s2 <= kSmallSpread && s1 > s2 && s2 / s4 >= kGentleFall);
  double second_order = s2;
  if (hugs_bound) {
    // Where the path meets the bound one segment is off by h^2 times a factor between 0 and a constant, which depends
    // on where the points happen to be: the largest of the levels must show it, up to kBoundJitter.
    second_order = kBoundJitter / 2 * std::max({s1 / 4, s2, 4 * s4});
    falls = s4 <= std::max(options.spacing, kBoundJitter / 16 * std::max(s1, 4 * s2));
  }
  const double ratio = c.levels[1].segments / static_cast<double>(chain.segment_count());
  const double expected =
      std::max(options.spacing, 2 * softer_than_levels(problem, energy, chain) * second_order * ratio * ratio);
  if (!falls)
    return c.failures.push_back({Failure::spacing, "unequal segments (" + short_number(c.spacing) +
                                                       ") that do not become equal at second order"});
  if (c.spacing > expected) fail_spacing(c, expected);
}

}  // namespace leastcost
