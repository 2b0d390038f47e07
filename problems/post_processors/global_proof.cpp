// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/global_proof.hpp>

#include <memory>
#include <string>
#include <utility>
#include <variant>

#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/problems/layers/has_layers.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include <leastcost/problems/post_processors/bracket.hpp>
#include <leastcost/problems/post_processors/cell_bound.hpp>
#include <leastcost/problems/post_processors/fastest_refraction.hpp>
#include <leastcost/problems/post_processors/refract.hpp>
#include <leastcost/problems/post_processors/refract_cells.hpp>
#include <leastcost/problems/post_processors/shortest.hpp>
#include <leastcost/problems/post_processors/shortest_plan.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include "problems/cells/has_cost_cells.hpp"
#include "problems/post_processors/plan_curve.hpp"
#include "problems/post_processors/refracted_curve.hpp"

namespace leastcost {
namespace {

template <class Prover, class Before>
GlobalProofStep made(const GlobalProof& proof) {
  return {std::make_shared<const Prover>(proof), std::make_shared<const Before>(), ""};
}

}  // namespace

GlobalProofStep global_proof(const Problem& problem, const GlobalProof& proof) {
  if (problem.ring || problem.based)
    return {nullptr, nullptr, "a proof over all paths needs two ends, but a ring has none"};
  const bool constant = find_ability<HasConstantMetric>(*problem.cost) != nullptr;
  if (find_ability<HasMesh>(*problem.manifold) != nullptr) {
    if (constant) return made<ShortestPostProcessor, StraightenPostProcessor>(proof);
    return {nullptr, nullptr, "on a mesh, a proof over all paths needs a cost with a constant metric"};
  }
  if (why_no_refraction(problem).empty()) return made<FastestRefractionPostProcessor, RefractPostProcessor>(proof);
  if (why_no_cells(problem).empty()) return made<CellBoundPostProcessor, RefractCellsPostProcessor>(proof);
  if (problem.manifold->dimensions().ambient == 2 && why_no_tight_path(problem).empty())
    return made<ShortestPlanPostProcessor, TautPostProcessor>(proof);
  if (std::string why = why_no_bracket(problem); !why.empty()) return {nullptr, nullptr, std::move(why)};
  const auto* budget = std::get_if<GlobalBudget>(&proof);
  return {std::make_shared<const BracketPostProcessor>(budget != nullptr ? *budget : GlobalBudget{}), nullptr, ""};
}

}  // namespace leastcost
