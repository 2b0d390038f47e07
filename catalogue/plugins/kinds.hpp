// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>

#include <leastcost/framework/initializer.hpp>
#include <leastcost/framework/kernel.hpp>
#include <leastcost/framework/manifold.hpp>
#include <leastcost/framework/post_processor.hpp>
#include <leastcost/framework/segment_cost.hpp>
#include <leastcost/framework/solver.hpp>

#include "catalogue/plugins/plugin.hpp"

namespace leastcost {

using KernelPlugin = Plugin<std::shared_ptr<const Kernel>>;
using CostPlugin = Plugin<std::shared_ptr<const SegmentCost>>;
using ManifoldPlugin = Plugin<std::shared_ptr<const ConstraintManifold>>;
using InitializerPlugin = Plugin<std::shared_ptr<const Initializer>>;
using SolverPlugin = Plugin<std::shared_ptr<const Solver>>;
using PostProcessorPlugin = Plugin<std::shared_ptr<const PostProcessor>>;

/// Abilities that plug-ins provide and need, see PluginEntry.
inline constexpr std::string_view kMesh = "mesh";
inline constexpr std::string_view kSurface = "surface";  ///< two-dimensional, in R^3
inline constexpr std::string_view kSeams = "chart with seams";
inline constexpr std::string_view kGraph = "graph";  ///< edges between points that lie on the domain
inline constexpr std::string_view kConstantMetric = "constant metric";
inline constexpr std::string_view kEmbedded = "smooth embedding";  ///< curved, given in its ambient space
inline constexpr std::string_view kGrid = "distance grid";         ///< takes a while to make
inline constexpr std::string_view kRing = "ring";                  ///< an initializer that makes closed paths

}  // namespace leastcost
