// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/choose_global_proof.hpp>

#include <memory>
#include <optional>

#include <leastcost/problems/post_processors/cell_bound.hpp>
#include <leastcost/problems/post_processors/fastest_refraction.hpp>
#include <leastcost/problems/post_processors/refract.hpp>
#include <leastcost/problems/post_processors/refract_cells.hpp>
#include "problems/cells/has_cost_cells.hpp"
#include "problems/methods/offered_methods.hpp"
#include "problems/post_processors/refracted_curve.hpp"

namespace leastcost {
namespace {

template <class Prover, class Before>
GlobalProofStep made(const GlobalProof& proof) {
  return {std::make_shared<const Prover>(proof), std::make_shared<const Before>(), ""};
}

/// Of a library; nothing where it is not linked, or the problem is not of its subject.
template <class Methods>
std::optional<GlobalProofStep> offered(const Methods* library, const Problem& problem, const GlobalProof& proof) {
  return library != nullptr ? library->proof(problem, proof) : std::nullopt;
}

}  // namespace

GlobalProofStep global_proof(const Problem& problem, const GlobalProof& proof) {
  if (problem.ring || problem.based)
    return {nullptr, nullptr, "a proof over all paths needs two ends, but a ring has none"};
  if (const auto on_mesh = offered(mesh_methods(), problem, proof)) return *on_mesh;
  if (why_no_refraction(problem).empty()) return made<FastestRefractionPostProcessor, RefractPostProcessor>(proof);
  if (why_no_cells(problem).empty()) return made<CellBoundPostProcessor, RefractCellsPostProcessor>(proof);
  if (const auto among_obstacles = offered(planning_methods(), problem, proof)) return *among_obstacles;
  if (const auto in_box = offered(bounds_methods(), problem, proof)) return *in_box;
  return {nullptr, nullptr, "the proofs over all paths in a box are in the library leastcost::bounds: link it"};
}

}  // namespace leastcost
