// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/mesh/length_search.hpp>
#include <leastcost/problems/straighten/straighten.hpp>

namespace leastcost {

struct GeodesicOptions {
  MetricRoot metric = {};   ///< lengths |A d|; none: Euclidean
  StopPredicate stop = {};  ///< true: return the best so far; empty: never
  /// First paths tried, each straightened and the shortest result kept. 1: over edges and diagonals; 2: over edges
  /// alone as well (mean excess over the shortest path halved, twice the time).
  int routes = 2;
  bool flips = true;                         ///< StraightenOptions::flips
  const EdgeLandmarks* landmarks = nullptr;  ///< LengthSearchOptions::landmarks
};

/// A geodesic of a mesh, and the route that it was straightened from.
struct Geodesic {
  EdgePath first;       ///< of the route that was kept; its outcome tells why when no path was found
  Straightened result;  ///< empty path unless found()
  bool found() const { return first.found(); }  ///< whether there is a path
};

/// Short geodesics between two points: graph paths as first guesses, straightened exactly, the best kept. Locally
/// shortest always; that it is the shortest of all is likely, never proven. Reusable: a query costs what it visits. One
/// object per thread; the mesh must outlive it. Throws InputError as straighten() does.
class GeodesicSearch {
 public:
  explicit GeodesicSearch(const TriangleMesh& mesh) : mesh_(&mesh), graph_(mesh) {}

  /// The graph path alone, over edges and, where asked for, diagonals.
  EdgePath first_path(const SurfacePoint& source, const SurfacePoint& target, const LengthSearchOptions& options) {
    return graph_.shortest(source, target, options);
  }
  /// A straightened shortest route between two points of the surface.
  Geodesic shortest(const SurfacePoint& source, const SurfacePoint& target, const GeodesicOptions& options = {});

 private:
  const TriangleMesh* mesh_;
  LengthSearch graph_;
};

}  // namespace leastcost
