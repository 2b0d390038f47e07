// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/look_elsewhere.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/initializers/bow.hpp>

namespace leastcost {
namespace {

constexpr double kLess = 0.01;  ///< of the cost: what is worth a note

/// What a bow leads to with so many points; infinite where it leads to nothing.
double cost_by(const BowOptions& bow, int points, const RunParts& parts, const Monitor& monitor) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  FindOptions options;
  options.points = points;
  options.certificate.enabled = false;
  try {
    const Result found = find_path(parts.problem, BowInitializer(bow), *parts.solver, options, monitor);
    return found.status != Status::interrupted && found.curve.cost > 0 ? found.curve.cost : kNone;
  } catch (const Error&) {
    return kNone;  // no arc, or none of finite cost
  }
}

}  // namespace

std::string look_elsewhere(const RunParts& parts, const Result& result, const Monitor& monitor) {
  constexpr int kFewPoints = 24;
  const double allowed = (1 - kLess) * result.curve.cost;
  const bool wide = parts.problem.source.u.size() > 2;
  Monitor quiet = monitor;
  quiet.observe = nullptr;
  std::vector<std::pair<double, BowOptions>> bows;
  for (const double height : {0.25, 0.6})
    for (const double angle : {0.0, 90.0, 180.0, 270.0}) {
      if (!wide && (angle == 90 || angle == 270)) continue;
      const BowOptions bow{height, angle};
      bows.emplace_back(cost_by(bow, kFewPoints, parts, quiet), bow);
    }
  std::stable_sort(bows.begin(), bows.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [coarse, bow] : bows) {
    if (!(coarse < allowed)) break;
    // As the run itself would: few points may say too little, or lead elsewhere.
    const double cost = cost_by(bow, parts.options.points.value_or(kFewPoints), parts, quiet);
    if (!(cost < allowed)) continue;
    return fmt::format(
        "another path costs about {:.4g}, {:.2g} % less; to start from it, use 'initializer: {{type: bow, height: "
        "{:g}, angle: {:g}}}'",
        cost, 100 * (1 - cost / result.curve.cost), bow.height, bow.angle);
  }
  return "";
}

}  // namespace leastcost
