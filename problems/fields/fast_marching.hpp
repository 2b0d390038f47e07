// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <leastcost/problems/mesh/surface_path.hpp>

namespace leastcost {

struct FastMarchingOptions {
  std::int32_t target = -1;         ///< a vertex: march until its distance is known; -1: until all are
  std::function<bool()> stop = {};  ///< true: leave the rest infinite; empty: never
};

/// First-order fast marching on a mesh (Kimmel and Sethian 1998): distances from a point to all vertices, by plane
/// waves through two corners of a face. A corner whose angle is obtuse is divided by a virtual edge to the first vertex
/// that the unfolded faces behind it show there. Distances are approximate, of order one in the length of the edges,
/// and may lie on either side of the exact ones. Made once per mesh; const afterwards and shared by threads.
class FastMarching {
 public:
  explicit FastMarching(const TriangleMesh& mesh);
  ~FastMarching();
  FastMarching(FastMarching&&) noexcept;
  FastMarching& operator=(FastMarching&&) noexcept;

  /// Length units, one per vertex; infinite where no path leads.
  std::vector<double> distances(const SurfacePoint& source, const FastMarchingOptions& options = {}) const;

 private:
  struct Tables;
  std::unique_ptr<const Tables> tables_;
};

/// The same for one source.
std::vector<double> fast_marching_distances(const TriangleMesh& mesh, const SurfacePoint& source,
                                            const FastMarchingOptions& options = {});

}  // namespace leastcost
