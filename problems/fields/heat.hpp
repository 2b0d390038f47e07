// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <leastcost/problems/mesh/surface_path.hpp>

namespace leastcost {

struct HeatOptions {
  double time = 1;       ///< of the heat flow, in squared mean edge lengths; > 0
  bool delaunay = true;  ///< flips the edges intrinsically first; without, distances get worse on finer meshes
  std::function<bool()> stop = {};  ///< asked between the stages; true: throws Interrupted; empty: never
};

/// The heat method (Crane, Weischedel and Wardetzky 2013) on the intrinsic Delaunay triangulation of a mesh (Sharp,
/// Soliman and Crane 2019): heat flows from the source for a short time, its gradient made of unit length is integrated
/// to distances. Two sparse systems are factored once (Eigen's LDL'), each source then costs two substitutions.
/// Distances are approximate and may lie on either side of the exact ones. Borders: no heat leaves (Neumann). Made once
/// per mesh; const afterwards and shared by threads.
class HeatDistances {
 public:
  /// Throws InputError where an edge has three or more faces or the mesh has no area, OptionError when time <= 0.
  explicit HeatDistances(const TriangleMesh& mesh, const HeatOptions& options = {});
  ~HeatDistances();
  HeatDistances(HeatDistances&&) noexcept;
  HeatDistances& operator=(HeatDistances&&) noexcept;

  /// Length units, one per vertex; infinite in other components.
  std::vector<double> from(const SurfacePoint& source) const;
  /// Edges that were flipped.
  std::int64_t flips() const;

 private:
  struct Systems;
  std::unique_ptr<const Systems> systems_;
};

/// The same for one source.
std::vector<double> heat_distances(const TriangleMesh& mesh, const SurfacePoint& source,
                                   const HeatOptions& options = {});

}  // namespace leastcost
