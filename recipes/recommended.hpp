// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/problem/initializer.hpp>
#include <leastcost/framework/problem/post_processor.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/recipes/methods.hpp>

namespace leastcost {

/// The methods that are recommended for a problem.
struct Recipe {
  std::shared_ptr<const Initializer> initializer;                     ///< null for a ring, which has no default
  std::shared_ptr<const Solver> solver;                               ///< moves the points to the minimum
  std::vector<std::shared_ptr<const PostProcessor>> post_processors;  ///< the proof over all paths comes last
  std::vector<std::string> why;  ///< of first path, solver, post-processors and proof: "solver: newton, because .."
  bool one_way = false;          ///< nothing looks beside a straight first path (sees_one_way)
};

/// Why these post-processors: "post-processors: trace, because ..; straighten, because .."
std::string why_curve(const std::vector<CurveMethod>& steps);

/// The problem, with the kernel exp(s^2) - 1 if it has none.
Problem with_kernel(Problem problem);

/// Decided by what the objects of the problem are (facts_of), and by `options.certificate`: whether a proof over all
/// paths is wanted. A configuration asks the same rules (methods.hpp) with what the types of its parts say. Throws
/// InputError for a problem whose parts do not fit; the kernel may be missing.
Recipe recommended(const Problem& problem, const FindOptions& options = {});

}  // namespace leastcost
