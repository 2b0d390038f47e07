// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/straighten/straighten.hpp>

namespace leastcost {

struct StraightenedRing {
  SurfacePath path;           ///< first and last point are the same; empty when collapsed
  bool collapsed = false;     ///< the ring contracted to a point: no closed geodesic was met on the way
  double initial_length = 0;  ///< of the ring given, length units of the metric
  double final_length = 0;    ///< <= initial_length
  std::int64_t moves = 0;     ///< strips rerouted around a vertex
  std::int64_t flips = 0;     ///< flips that made the ring shorter
  bool finished = true;       ///< false: stopped early; the ring is valid but not straight yet
};

/// The locally shortest closed curve near a given one (first and last point the same), exactly (to rounding), with no
/// point held fixed: straighten() between vertices that the ring bends around, one of them the cut, each the cut in
/// turn, and a cyclic funnel where it bends around none. Homotopic to the given ring, over faces and vertices only;
/// `shortcuts`, which may leave that class, are not taken. `flips` take the ring out of the small dents of a noisy
/// mesh, never to a point. Throws InputError as straighten() does, and for a path that is not closed.
StraightenedRing straighten_ring(const TriangleMesh& mesh, const SurfacePath& ring,
                                 const StraightenOptions& options = {});

/// check_straight() of a closed path, its seam included; -infinity where first and last point differ.
double check_straight_ring(const TriangleMesh& mesh, const SurfacePath& ring, const MetricRoot& metric = {});

}  // namespace leastcost
