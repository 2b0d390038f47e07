// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/certificate/certify_straightened.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <leastcost/framework/cost/has_interfaces.hpp>
#include "framework/base/point_text.hpp"
#include "framework/certificate/shared_failures.hpp"

namespace leastcost {
namespace {

constexpr double kStraight = 1e-9;        ///< radians below pi that a side angle may fall
constexpr double kNearlyStraight = 0.02;  ///< the same of a curve whose bar has what its turns cost

constexpr double kFarBelow = 0.01;  ///< of the cost: a bound this far below says that more is known than a bar

double length_of(const Points& x) {
  return (x.rightCols(x.cols() - 1) - x.leftCols(x.cols() - 1)).colwise().norm().sum();
}

/// What rounding of positions leaves of the equal distances of points, relative.
double spacing_rounding(const PostProcessed& path) {
  constexpr double kRoundings = 64;  // of the largest coordinate, at the two ends of a segment
  const Points& x = path.curve.x;
  const double mean = length_of(x) / static_cast<double>(path.curve_costs.size());
  return mean > 0 ? kRoundings * std::numeric_limits<double>::epsilon() * x.cwiseAbs().maxCoeff() / mean : 0;
}

/// Snell's law: the slowness along an interface is the same on both sides of every crossing.
void measure_refraction(const HasInterfaces& cost, const Points& curve, const ConstraintManifold& domain,
                        const CertificateOptions& options, Certificate& c) {
  c.stationarity = 0;
  for (const Crossing& crossing : cost.crossings(curve, domain)) {
    *c.stationarity = std::max(*c.stationarity, crossing.mismatch);
    const double allowed = options.stationarity + crossing.rounding;
    if (crossing.mismatch <= allowed) continue;
    const TwoNumbers texts = told_apart(crossing.mismatch, allowed);
    c.failures.push_back({Failure::stationarity, "at " + point_text(crossing.place) +
                                                     " the slownesses along interface " +
                                                     std::to_string(crossing.interface) + " differ by " + texts.first +
                                                     " of the index; allowed " + texts.second + " (Snell's law)"});
  }
}

}  // namespace

void certify_straightened(const Problem& problem, const PostProcessed& path, const CertificateOptions& options,
                          Certificate& c) {
  c.global = path.curve.global;
  const bool global = c.global && c.global->proved, measured = path.curve.excess.has_value();
  c.scope = global                      ? c.global->scope
            : path.curve.least_of_class ? Scope::least_of_class
            : measured                  ? Scope::local
                                        : Scope::local_on_polyhedron;
  c.straightness = path.curve.straightness;
  // No angle is asked for beside a path that is proved to be shortest: all angles together shorten it by less than the
  // gap, which is in the bar, and one between two tiny segments tells of rounding alone.
  if (const auto* cost = find_ability<HasInterfaces>(*problem.cost))
    measure_refraction(*cost, path.curve.x, *problem.manifold, options, c);
  else if (!global && !(*c.straightness >= -(measured ? kNearlyStraight : kStraight)))
    c.failures.push_back({Failure::straightness, "an angle at the path is " + short_number(-*c.straightness) +
                                                     " below pi: the path can be shortened there"});
  if (c.global && c.global->outcome == ProofOutcome::blocked && c.global->gap > kFarBelow) {
    const TwoNumbers texts = told_apart(c.global->lower_bound, path.curve.cost);
    c.failures.push_back({Failure::not_global, "a path of cost " + texts.first + " may exist, but this one costs " +
                                                   texts.second + ": " + c.global->reason});
  }
  const double allowed = std::max(options.spacing, spacing_rounding(path));
  if (!(c.spacing <= allowed)) fail_spacing(c, allowed);
  c.estimate.method = ValueMethod::straightened;
  c.estimate.error = std::numeric_limits<double>::epsilon() * path.curve.cost *
                     std::sqrt(static_cast<double>(path.curve.x.cols())) * 4;
  if (global) {
    c.estimate.error += std::max(0.0, path.curve.cost - c.global->lower_bound);
    c.estimate.lower = c.global->lower_bound;
    c.estimate.upper = path.curve.cost;
  }
  if (!path.curve.least_of_class && !measured) return;
  // Lengths of m sides, each from coordinates of this size.
  const double sides = static_cast<double>(path.curve.x.cols()), size = path.curve.x.cwiseAbs().maxCoeff();
  const double unit = path.curve.cost / length_of(path.curve.x);
  const double above = measured ? *path.curve.excess
                       : global ? 0  // of which the gap knows already
                                : path.curve.cost - *path.curve.least_of_class;
  c.estimate.error +=
      std::max(0.0, above) + 2 * std::numeric_limits<double>::epsilon() * sides * (unit * size + path.curve.cost);
  c.estimate.lower = path.curve.cost - c.estimate.error;
  c.estimate.upper = path.curve.cost;
  // The gap of a proof is what its tolerance allows.
  if (!global && !(c.estimate.error <= kPolyhedronError * path.curve.cost))
    c.failures.push_back(
        {Failure::error_bar, "the error bar is " + short_number(c.estimate.error / path.curve.cost) + " of the cost"});
}

}  // namespace leastcost
