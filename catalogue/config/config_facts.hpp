// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <leastcost/recipes/methods.hpp>
#include "catalogue/config/run_config.hpp"

namespace leastcost {

/// What the types of a domain and a cost say to the recipes.
ProblemFacts facts_of_types(const PluginEntry* manifold, std::string_view cost);

/// What a configuration says to the recipes, before there are objects.
ProblemFacts facts_of(const RunConfig& config);
FirstPathFacts first_path_of(const RunConfig& config);

/// The proof over all paths that is asked for: none without a certificate.
GlobalProof asked_proof(const RunConfig& config);

/// Why paths cannot be pulled tight among the obstacles; empty: they can. Obstacles are told by their types.
std::string why_not_taut(const RunConfig& config);

/// Whether the run proves that its path is the shortest of all, or tries to: an open path on a mesh, or
/// among obstacles in the plane, under the Euclidean cost, whose first path states no class, unless the configuration
/// says otherwise.
bool proves_shortest(const RunConfig& config);

/// Whether the run puts a bracket around the globally least cost: in a box, where a budget for it is
/// given.
bool brackets(const RunConfig& config);

/// Whether the path begins with the straight line and nothing looks at other ways, under a cost that may have several.
bool sees_one_way(const RunConfig& config);

}  // namespace leastcost
