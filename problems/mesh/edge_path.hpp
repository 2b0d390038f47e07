// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <leastcost/problems/mesh/surface_path.hpp>

/// What searches along the edges of a mesh are asked, and what they answer.
namespace leastcost {

/// Cost of the straight move a -> b, >= 0. +infinity: not passable. May be asymmetric.
using MoveCost = std::function<double(const Eigen::Vector3d& a, const Eigen::Vector3d& b)>;
/// Lower bound of the cost from p to the target: admissible and consistent, bound(a) <= cost(a, b) + bound(b).
using CostBound = std::function<double(const Eigen::Vector3d& p)>;
/// True: give up. Asked now and then.
using StopPredicate = std::function<bool()>;

struct EdgePathOptions {
  CostBound lower_bound = {};  ///< empty: Dijkstra; given: A*
  StopPredicate stop = {};     ///< empty: never
  /// Also moves from a vertex straight across one edge to the vertex opposite (in the unfolding of the two faces,
  /// where that is convex): about half the metrication error of edges alone, at twice the moves. Costs are evaluated
  /// on the two straight pieces.
  bool diagonals = false;
};

/// Why a search along edges ended.
enum class EdgePathOutcome { found, different_components, no_finite_route, stopped };

/// A path along edges.
struct EdgePath {
  EdgePathOutcome outcome = EdgePathOutcome::stopped;     ///< why the search ended
  double cost = std::numeric_limits<double>::infinity();  ///< sum over its edges
  std::vector<std::int32_t> vertices;  ///< in between: without an end, unless the end is itself a vertex
  SurfacePath path;                    ///< the same from end to end, face by face; empty unless found
  std::int32_t settled = 0;            ///< vertices whose least cost became known
  std::int32_t source_component_size = 0, target_component_size = 0;  ///< vertices
  bool found() const { return outcome == EdgePathOutcome::found; }    ///< whether there is a path
  /// One sentence for an InitializationError; empty when found.
  std::string failure() const;
};

}  // namespace leastcost
