// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include <leastcost/problems/mesh/surface_path.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

struct StraightenOptions {
  MetricRoot metric = {};      ///< lengths |A d|; none: Euclidean
  std::function<bool()> stop;  ///< true: return the best so far; empty: never
  /// Tries the other side of vertices of positive curvature near the straightened path and keeps what is shorter
  /// (docs/numerics.md Sec. 5.3).
  bool flips = false;
  /// Replaces long strips by straight shots over the unfolded surface where that is shorter, before moving them vertex
  /// by vertex: an edge path on a fine mesh is a few sweeps from straight instead of one sweep per row of vertices. A
  /// shot may pass a bump on its other side. Without shortcuts and flips the result is in the class of the given path.
  bool shortcuts = true;
};

/// A path after straightening.
struct Straightened {
  SurfacePath path;           ///< locally shortest, where it was not stopped
  double initial_length = 0;  ///< of the path given, length units of the metric
  double final_length = 0;    ///< <= initial_length
  std::int64_t moves = 0;     ///< strips rerouted around a vertex
  std::int64_t flips = 0;     ///< flips that made the path shorter
  bool finished = true;       ///< false: stopped early; the path is valid but not straight yet
};

/// The locally shortest polyhedral path near a given one, exactly (to rounding): unfolds the strip of faces, pulls the
/// string, moves the strip to the other side of every vertex where that side has an angle below pi, until none has.
/// Borders are obstacles, vertices between two fans fixed points. No step makes the path longer.
/// Throws InputError when a strip or fan that it needs contains an edge with three or more faces (named by the file's
/// vertex numbers): which way the path goes on there is not defined.
Straightened straighten(const TriangleMesh& mesh, const SurfacePath& path, const StraightenOptions& options = {});

/// How straight a path is, judged from its points and faces alone: the smallest of all side angles minus pi, over all
/// interior points, or 0 when none is below pi. Side angles at a vertex count where that side is surface; at a point
/// on an edge or in a face both sides count, in the unfolding, points closer than 1e-6 diameters taken together. What
/// rounding of the points' coordinates can make of an angle is not held against the path. A locally shortest path has
/// >= -1e-9; what is no connected path on the mesh, crosses an edge with three or more faces, or runs along an edge
/// without length (weld the mesh), has -infinity.
double check_straight(const TriangleMesh& mesh, const SurfacePath& path, const MetricRoot& metric = {});

}  // namespace leastcost
