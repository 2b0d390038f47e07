// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include <leastcost/framework/problem/initializer.hpp>

namespace leastcost {

/// Ability of a domain: edges join points that lie on it, so that first paths can be searched along them (VFCS 5.1) and
/// the number of their vertices is a number of points that fits the data (`points: auto`).
class HasGraph {
 public:
  static constexpr std::string_view kAbility = "graph";
  virtual ~HasGraph() = default;
  /// The least-cost path along edges between the ends of the problem, whose domain this is; its `graph_vertices` are
  /// set. Throws InitializationError, Interrupted.
  virtual FirstPath least_cost_edges(const Problem& problem, const Monitor& monitor) const = 0;
};

}  // namespace leastcost
