// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include "tests/support/compose.hpp"

namespace leastcost::test {

/// find_path() as it is on a mesh: solved, traced, straightened, certified.
inline Result find_straightened(const Problem& problem, int points, const Initializer& initializer,
                                const Solver& solver = Lbfgs()) {
  FindOptions options;
  options.points = points;
  options.post_processors = {std::make_shared<const TracePostProcessor>(),
                             std::make_shared<const StraightenPostProcessor>()};
  return find_path(problem, initializer, solver, options);
}

}  // namespace leastcost::test
