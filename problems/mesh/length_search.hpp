// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <leastcost/problems/mesh/edge_path.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

class EdgeLandmarks;

struct LengthSearchOptions {
  MetricRoot metric = {};   ///< lengths |A d|; none: Euclidean
  StopPredicate stop = {};  ///< true: give up; empty: never
  /// Also moves from a vertex straight across one edge to the vertex opposite, as EdgePathOptions::diagonals.
  bool diagonals = false;
  /// Further lower bounds, of this mesh under this metric; null: the straight line alone. They must outlive the search.
  const EdgeLandmarks* landmarks = nullptr;
};

/// What EdgeGraphSearch does, for the length in one constant metric: A* without a call per move, several times as
/// quick. Moves are compared by their lengths in floats, so that another path may be shorter by 1e-7 of its length.
/// Keeps the moves of vertices that it came to, about 110 bytes each. One object per thread; the mesh must outlive it.
class LengthSearch {
 public:
  explicit LengthSearch(const TriangleMesh& mesh);
  ~LengthSearch();
  LengthSearch(LengthSearch&&) noexcept;
  LengthSearch& operator=(LengthSearch&&) noexcept;

  /// The shortest path along edges between two points of the surface.
  EdgePath shortest(const SurfacePoint& source, const SurfacePoint& target, const LengthSearchOptions& options = {});
  /// Lengths of the shortest routes over edges and diagonals from a vertex to all others, right to 1e-7; infinite where
  /// there is none. Length units of the metric. After a stop they are upper bounds.
  std::vector<double> lengths_from(std::int32_t vertex, const LengthSearchOptions& options = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace leastcost
