// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <leastcost/problems/mesh/surface_path.hpp>

namespace leastcost {

/// A way down a field.
struct Descent {
  SurfacePath path;       ///< from `start` to `source`; empty where the field leads nowhere
  bool by_edges = false;  ///< the field had a minimum of its own: the rest follows the shortest edges
};

/// The path of steepest descent of a distance field, linear on each face, from a point down to the source of the field.
/// Where the descent of two faces meets in an edge it follows the edge. A connected path on the mesh whatever the
/// values are. Throws InputError when there is not one value per vertex.
Descent descend(const TriangleMesh& mesh, std::span<const double> values, const SurfacePoint& start,
                const SurfacePoint& source);

}  // namespace leastcost
