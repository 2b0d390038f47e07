// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/recipes/methods.hpp>

namespace leastcost {

/// What a domain, or a cost, says about itself.
void add_facts(const ConstraintManifold& domain, ProblemFacts& facts);
void add_facts(const SegmentCost& cost, ProblemFacts& facts);

/// What the objects of a problem say about themselves (their abilities). `problem`: with a domain and a cost.
ProblemFacts facts_of(const Problem& problem);

}  // namespace leastcost
