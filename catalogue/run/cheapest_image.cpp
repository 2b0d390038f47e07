// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/cheapest_image.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/has_images.hpp>
#include <leastcost/framework/result/other_images.hpp>

namespace leastcost {
namespace {

/// Where coordinates are names only the target is called by the one nearest to the source, or to the last waypoint.
void name_target(RunParts& out) {
  Problem& problem = out.problem;
  Eigen::VectorXd last = problem.source.u;
  if (out.initializer->name() == "waypoints" && find_ability<HasChart>(*problem.manifold) != nullptr) {
    try {
      const Points stops = out.initializer->first_path(problem, {}).path.u;
      last = stops.col(stops.cols() - 2);
    } catch (const InitializationError&) {  // the search says so
    }
  }
  name_target_near(last, problem);
  out.target.end.u = problem.target.u;
}

}  // namespace

void take_cheapest_image(const RunConfig& config, const std::shared_ptr<const ConstraintManifold>& open_domain,
                         RunParts& out) {
  Problem& problem = out.problem;
  const auto* domain = find_ability<HasImages>(*problem.manifold);
  if (domain == nullptr || problem.ring || config.target_image == TargetImageChoice::given) return;
  name_target(out);
  if (config.family.windings > 0) return;
  const bool chart = find_ability<HasChart>(*problem.manifold) != nullptr;  // where other starts have their own way
  if (chart && out.initializer->name() != "straight") return;
  if (out.initializer->name() == "waypoints") return;  // they lead to the coordinates that are given
  if (domain->states_way(problem.target.u, problem.source.u)) return;
  Problem open = problem;
  open.manifold = open_domain;
  const std::optional<CheaperImage> best = find_cheaper_image(open);
  if (!best) return;
  problem.target.u = out.target.end.u = best->image.u;
  const std::string instead = std::isfinite(best->given) ? fmt::format(", not {:.9g}", best->given) : "";
  constexpr double kWorthSaying = 1e-6;
  if (best->cost >= (1 - kWorthSaying) * best->given) return;
  if (!best->image.way.empty()) {
    if (!std::isfinite(best->given)) return;  // as of ends at a pole, whose longitude says nothing
    out.notes.push_back(
        fmt::format("the path goes {}, which costs about {:.9g}{}", best->image.way, best->cost, instead));
    return;
  }
  out.notes.push_back(
      fmt::format("the target was replaced by ({:.6g}), {}, the same point in other coordinates: a path to it costs "
                  "about {:.9g}{}{} (images tried: {}; to keep the given one, set path: {{target_image: given}})",
                  fmt::join(best->image.u, ", "), best->image.where, best->cost, instead,
                  open_domain == problem.manifold ? "" : " without obstacles", best->tried));
}

}  // namespace leastcost
