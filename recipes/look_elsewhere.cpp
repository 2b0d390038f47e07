// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/recipes/look_elsewhere.hpp>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/search/find_path.hpp>

namespace leastcost {
namespace {

constexpr double kLess = 0.01;  ///< of the cost: what is worth a note

/// What a bow leads to with so many points; infinite where it leads to nothing.
double cost_by(const BowOptions& bow, int points, const Problem& problem, const Solver& solver,
               const Monitor& monitor) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  FindOptions options;
  options.points = points;
  options.certificate.enabled = false;
  try {
    const Result found = find_path(problem, BowInitializer(bow), solver, options, monitor);
    return found.status != Status::interrupted && found.curve.cost > 0 ? found.curve.cost : kNone;
  } catch (const Error&) {
    return kNone;  // no arc, or none of finite cost
  }
}

}  // namespace

std::optional<OtherWay> look_elsewhere(const Problem& problem, const Solver& solver, const Result& result,
                                       std::optional<int> points, const Monitor& monitor) {
  constexpr int kFewPoints = 24;
  const double allowed = (1 - kLess) * result.curve.cost;
  const bool wide = problem.source.u.size() > 2;
  Monitor quiet = monitor;
  quiet.observe = nullptr;
  std::vector<std::pair<double, BowOptions>> bows;
  for (const double height : {0.25, 0.6})
    for (const double angle : {0.0, 90.0, 180.0, 270.0}) {
      if (!wide && (angle == 90 || angle == 270)) continue;
      const BowOptions bow{height, angle};
      bows.emplace_back(cost_by(bow, kFewPoints, problem, solver, quiet), bow);
    }
  std::stable_sort(bows.begin(), bows.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [coarse, bow] : bows) {
    if (!(coarse < allowed)) break;
    // As the search itself would: few points may say too little, or lead elsewhere.
    const double cost = cost_by(bow, points.value_or(kFewPoints), problem, solver, quiet);
    if (cost < allowed) return OtherWay{cost, 1 - cost / result.curve.cost, bow};
  }
  return std::nullopt;
}

}  // namespace leastcost
