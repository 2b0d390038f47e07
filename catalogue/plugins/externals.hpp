// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <variant>

#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/path/kernel.hpp>
#include <leastcost/framework/problem/initializer.hpp>
#include <leastcost/framework/problem/post_processor.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

/// An object that the caller has made.
using ExternalObject = std::variant<std::shared_ptr<const ConstraintManifold>, std::shared_ptr<const Obstacle>,
                                    std::shared_ptr<const Robot>, std::shared_ptr<const SegmentCost>,
                                    std::shared_ptr<const Kernel>, std::shared_ptr<const Initializer>,
                                    std::shared_ptr<const Solver>, std::shared_ptr<const PostProcessor>>;

/// Objects by the names under which a configuration asks for them: `cost: {type: external, name: chute}`. They take
/// part in a run as if the configuration had described them: checks, default methods and proofs are those of the
/// objects.
using Externals = std::map<std::string, ExternalObject, std::less<>>;

}  // namespace leastcost
