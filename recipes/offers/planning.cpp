// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Part of the library leastcost::planning: what find_path(problem) chooses among obstacles.
#include <leastcost/problems/post_processors/shortest_plan.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include "problems/methods/offered_methods.hpp"
#include "problems/post_processors/plan_curve.hpp"

namespace leastcost {
namespace {

std::shared_ptr<const PostProcessor> make_taut() { return std::make_shared<const TautPostProcessor>(); }

std::optional<GlobalProofStep> proof_among_obstacles(const Problem& problem, const GlobalProof& proof) {
  if (problem.manifold->dimensions().ambient != 2 || !why_no_tight_path(problem).empty()) return std::nullopt;
  return GlobalProofStep{std::make_shared<const ShortestPlanPostProcessor>(proof), make_taut(), ""};
}

constexpr PlanningMethods kPlanningMethods{make_taut, proof_among_obstacles};

}  // namespace
}  // namespace leastcost

// Who links the library asks the linker for this name (cmake/leastcost_library.cmake, OFFERS).
extern "C" const bool leastcost_planning_methods;
const bool leastcost_planning_methods = leastcost::offer(leastcost::kPlanningMethods);
