// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Part of the library leastcost::mesh: what find_path(problem) chooses on meshes.
#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include <leastcost/problems/post_processors/shortest.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include "problems/methods/offered_methods.hpp"

namespace leastcost {
namespace {

std::shared_ptr<const Initializer> make_dijkstra(bool diagonals) {
  return std::make_shared<const DijkstraInitializer>(DijkstraOptions{.diagonals = diagonals});
}

std::shared_ptr<const PostProcessor> make_trace() { return std::make_shared<const TracePostProcessor>(); }

std::shared_ptr<const PostProcessor> make_straighten() { return std::make_shared<const StraightenPostProcessor>(); }

std::optional<GlobalProofStep> proof_on_mesh(const Problem& problem, const GlobalProof& proof) {
  if (find_ability<HasMesh>(*problem.manifold) == nullptr) return std::nullopt;
  if (find_ability<HasConstantMetric>(*problem.cost) == nullptr)
    return GlobalProofStep{nullptr, nullptr, "on a mesh, a proof over all paths needs a cost with a constant metric"};
  return GlobalProofStep{std::make_shared<const ShortestPostProcessor>(proof), make_straighten(), ""};
}

constexpr MeshMethods kMeshMethods{make_dijkstra, make_trace, make_straighten, proof_on_mesh};

}  // namespace
}  // namespace leastcost

// Who links the library asks the linker for this name (cmake/leastcost_library.cmake, OFFERS).
extern "C" const bool leastcost_mesh_methods;
const bool leastcost_mesh_methods = leastcost::offer(leastcost::kMeshMethods);
