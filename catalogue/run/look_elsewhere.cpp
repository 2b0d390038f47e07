// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/look_elsewhere.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include <leastcost/framework/errors.hpp>
#include <leastcost/framework/find_path.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/solvers/lbfgs.hpp>

namespace leastcost {
namespace {

constexpr double kLess = 0.01;  ///< of the cost: what is worth a note

/// What a bow leads to with so many points; none where it leads to nothing.
std::optional<double> cost_by(const BowOptions& bow, int points, const Problem& problem, const Monitor& monitor) {
  FindOptions options;
  options.points = points;
  options.certificate.enabled = false;
  try {
    const Result found = find_path(problem, BowInitializer(bow), Lbfgs(), options, monitor);
    if (found.status == Status::interrupted || !(found.curve.cost > 0)) return std::nullopt;
    return found.curve.cost;
  } catch (const Error&) {
    return std::nullopt;  // no arc, or none of finite cost
  }
}

}  // namespace

std::string look_elsewhere(const RunParts& parts, const Result& result, const Monitor& monitor) {
  constexpr int kFewPoints = 24;
  const Problem& problem = parts.problem;
  const double allowed = (1 - kLess) * result.curve.cost;
  const bool wide = problem.source.u.size() > 2;
  Monitor quiet = monitor;
  quiet.observe = nullptr;
  std::optional<BowOptions> best;
  double least = allowed;
  for (const double height : {0.25, 0.6})
    for (const double angle : {0.0, 90.0, 180.0, 270.0}) {
      if (!wide && (angle == 90 || angle == 270)) continue;
      const BowOptions bow{height, angle};
      const std::optional<double> cost = cost_by(bow, kFewPoints, problem, quiet);
      if (cost && *cost < least) least = *cost, best = bow;
    }
  if (!best) return "";
  // Few points may say too little.
  const std::optional<double> cost =
      cost_by(*best, std::max(kFewPoints, parts.options.points.value_or(kFewPoints)), problem, quiet);
  if (!cost || !(*cost < allowed)) return "";
  return fmt::format(
      "another way costs about {:.4g}, {:.2g} % less: 'initializer: {{type: bow, height: {:g}, angle: {:g}}}' takes it",
      *cost, 100 * (1 - *cost / result.curve.cost), best->height, best->angle);
}

}  // namespace leastcost
