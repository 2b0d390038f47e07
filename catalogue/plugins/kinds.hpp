// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/path/kernel.hpp>
#include <leastcost/framework/problem/initializer.hpp>
#include <leastcost/framework/problem/post_processor.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/robots/robot.hpp>

#include "catalogue/plugins/plugin.hpp"

namespace leastcost {

using KernelPlugin = Plugin<std::shared_ptr<const Kernel>>;
using CostPlugin = Plugin<std::shared_ptr<const SegmentCost>>;
using ManifoldPlugin = Plugin<std::shared_ptr<const ConstraintManifold>>;
using InitializerPlugin = Plugin<std::shared_ptr<const Initializer>>;
using SolverPlugin = Plugin<std::shared_ptr<const Solver>>;
using ObstaclePlugin = Plugin<std::vector<std::shared_ptr<const Obstacle>>>;  // one entry may be many: a map
using RobotPlugin = Plugin<std::shared_ptr<const Robot>>;
using PostProcessorPlugin = Plugin<std::shared_ptr<const PostProcessor>>;

}  // namespace leastcost
