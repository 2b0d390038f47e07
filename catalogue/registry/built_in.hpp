// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <iterator>
#include <utility>
#include <vector>

#include "catalogue/plugins/kinds.hpp"

/// What the library has for configurations, kind by kind: one entry for each plug-in, in the file of its kind.
namespace leastcost::built_in {

const std::vector<ManifoldPlugin>& manifolds();
const std::vector<ObstaclePlugin>& obstacles();
const std::vector<RobotPlugin>& robots();
const std::vector<CostPlugin>& costs();
const std::vector<KernelPlugin>& kernels();
const std::vector<InitializerPlugin>& initializers();
const std::vector<SolverPlugin>& solvers();
const std::vector<PostProcessorPlugin>& post_processors();

/// Those of this library, then those of the optional ones.
template <class P>
std::vector<P> with_those_of_libraries(std::vector<P> own, std::vector<P> others) {
  std::move(others.begin(), others.end(), std::back_inserter(own));
  return own;
}

}  // namespace leastcost::built_in
