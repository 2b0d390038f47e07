// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/recipes/find_path.hpp>

#include <algorithm>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/recipes/recommended.hpp>

namespace leastcost {

Result find_path(const Problem& problem, const FindOptions& options, const Monitor& monitor) {
  const Recipe recipe = recommended(problem, options);
  if (!recipe.initializer)
    throw InputError("a ring has no default first path: call find_path(problem, initializer, solver) with one");
  FindOptions chosen = options;
  for (const auto& step : recipe.post_processors) {
    const bool given = std::any_of(options.post_processors.begin(), options.post_processors.end(),
                                   [&](const auto& other) { return other && other->name() == step->name(); });
    if (!given) chosen.post_processors.push_back(step);
  }
  return find_path(with_kernel(problem), *recipe.initializer, *recipe.solver, chosen, monitor);
}

}  // namespace leastcost
