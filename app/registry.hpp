// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "app/plugin.hpp"
#include "framework/initializer.hpp"
#include "framework/kernel.hpp"
#include "framework/manifold.hpp"
#include "framework/post_processor.hpp"
#include "framework/segment_cost.hpp"
#include "framework/solver.hpp"

namespace leastcost::app {

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

/// Everything that a configuration can name: one registration line per plug-in, in registry.cpp.
const std::vector<PluginKind>& plugin_kinds();

/// The kind with this name or plural; null when there is none.
const PluginKind* find_kind(std::string_view name);
/// The same for a name that is known to exist.
const PluginKind& kind(std::string_view name);
/// The plug-in of a kind, null when there is none.
const PluginEntry* find_plugin(const PluginKind& kind, std::string_view type);
/// All types of a kind, in the order of registration.
std::vector<std::string> types_of(const PluginKind& kind);

}  // namespace leastcost::app
