// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/family_ways.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

#include <leastcost/problems/chart/target_images.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/initializers/mirrored.hpp>

namespace leastcost {

void add_family_ways(const RunConfig& config, const std::vector<std::shared_ptr<const Initializer>>& others,
                     RunParts& out) {
  const FamilyOptions& family = config.family;
  out.windings = family.windings;
  for (int i = 0; i < family.bows; ++i) {
    const double angle = 360.0 * i / family.bows;
    out.family.push_back({fmt::format("bow {:g} degrees", angle),
                          std::make_shared<const BowInitializer>(BowOptions{family.bow_height, angle})});
  }
  if (family.mirrored)
    out.family.push_back({fmt::format("{}, mirrored", out.initializer->name()),
                          std::make_shared<const MirroredInitializer>(out.initializer)});
  for (int rank = 2; rank <= family.routes; ++rank)
    out.family.push_back({fmt::format("route {}", rank),
                          std::make_shared<const DijkstraInitializer>(DijkstraOptions{.routes = 1, .rank = rank})});
  for (std::size_t i = 0; i < others.size(); ++i) out.family.push_back({family.initializers[i].path, others[i]});
}

std::vector<FamilyStart> family_starts(const RunParts& parts) {
  std::vector<FamilyWay> ways = {{std::string(parts.initializer->name()), parts.initializer}};
  ways.insert(ways.end(), parts.family.begin(), parts.family.end());
  std::vector<TargetImage> problems = target_images(parts.problem, parts.windings);
  if (problems.empty()) problems.push_back({parts.problem, ""});
  std::vector<FamilyStart> starts;
  const auto add = [&](const Problem& problem, const std::string& where) {
    for (const FamilyWay& way : ways) starts.push_back({way.name + where, problem, way.initializer});
  };
  for (const TargetImage& image : problems)
    add(image.problem, image.winding.empty() ? "" : fmt::format(", winding {}", image.winding));
  for (const PlacedEnd& goal : parts.goals) {
    Problem problem = parts.problem;
    problem.target = goal.end;
    add(problem, fmt::format(", goal ({:.4g})", fmt::join(goal.end.u, ", ")));
  }
  return starts;
}

}  // namespace leastcost
