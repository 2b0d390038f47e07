// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include <leastcost/framework/problem/initializer.hpp>
#include <leastcost/framework/problem/offers_global_proof.hpp>
#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

/// The proof over all paths of a problem that a library has; nothing where the problem is not one of its subject.
using OfferedProof = std::optional<GlobalProofStep> (*)(const Problem& problem, const GlobalProof& proof);
using OfferedPostProcessor = std::shared_ptr<const PostProcessor> (*)();

/// What `core` chooses from the libraries above it: find_path(problem) its methods, a domain its proof. `core` does not
/// link them, so that a program is linked with what it asks for alone; each library says what it has when the program
/// is loaded (recipes/offers).
struct MeshMethods {
  std::shared_ptr<const Initializer> (*dijkstra)(bool diagonals);
  OfferedPostProcessor trace, straighten;
  OfferedProof proof;
};

struct PlanningMethods {
  OfferedPostProcessor taut;
  OfferedProof proof;
};

struct BoundsMethods {
  OfferedProof proof;
};

/// Null: the library is not part of the program.
const MeshMethods* mesh_methods();
const PlanningMethods* planning_methods();
const BoundsMethods* bounds_methods();

/// Says what a library has; true. The methods have to live as long as the program.
bool offer(const MeshMethods& methods);
bool offer(const PlanningMethods& methods);
bool offer(const BoundsMethods& methods);

}  // namespace leastcost
