// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/problems/mesh/edge_path.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// Shortest path along mesh edges. Keeps its memory between queries, so that a query costs what it visits and not the
/// size of the mesh. One object per thread; the mesh must outlive it.
class EdgeGraphSearch {
 public:
  explicit EdgeGraphSearch(const TriangleMesh& mesh);
  ~EdgeGraphSearch();
  EdgeGraphSearch(EdgeGraphSearch&&) noexcept;
  EdgeGraphSearch& operator=(EdgeGraphSearch&&) noexcept;

  /// An end at a vertex is that vertex; any other end is connected to the corners of its face, and straight to the
  /// other end where both lie on one face. `cost` is evaluated once per move that may make something cheaper.
  EdgePath shortest(const SurfacePoint& source, const SurfacePoint& target, const MoveCost& cost,
                    const EdgePathOptions& options = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace leastcost
