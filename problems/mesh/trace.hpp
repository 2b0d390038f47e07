// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/problems/mesh/surface_path.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// How the segments of a chain were brought onto the surface.
struct TraceReport {
  int direct = 0;     ///< both ends on one face (VFCS Fig. 5, case 1)
  int walked = 0;     ///< walk towards the projected end (case 2)
  int cut = 0;        ///< cutting plane through both ends (VFCS 4.4.3, last equation)
  int connected = 0;  ///< both failed (other sheet, border in between): shortest edge path
};

struct TracedPath {
  SurfacePath path;
  std::vector<std::size_t> chain_points;  ///< path.points[chain_points[i]] is point i of the chain
  TraceReport report;
};

/// A chain of surface points -> a polyline on the surface through all of them, connected face by face (VFCS 4.4.3).
/// Uses no orientation of faces. Throws InputError when two neighbours of the chain lie in different components.
/// Throws Interrupted after the deadline.
TracedPath trace_chain(const TriangleMesh& mesh, std::span<const SurfacePoint> chain, const Deadline& deadline = {});

}  // namespace leastcost
