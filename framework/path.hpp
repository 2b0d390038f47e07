// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace leastcost {

using Eigen::Index;
using Points = Eigen::MatrixXd;  ///< one column per point

/// Where on a piecewise domain a point is: the triangle of a mesh, kNoSite elsewhere. A position on an edge does not
/// say which face it belongs to, and the site makes the next projection O(1).
using Site = std::int32_t;
inline constexpr Site kNoSite = -1;

/// What a solver moves: points in the coordinates of the manifold.
/// Open: d x (n + 2), first and last column fixed (VFCS 3.2). Ring: d x n, all columns free, closed by the move from
/// the last column to the first. `sites` has one entry per column, or none where the domain has no sites.
struct CoordinatePath {
  Points u;
  std::vector<Site> sites;
  bool ring = false;

  Index free_begin() const { return ring ? 0 : 1; }
  Index free_count() const { return ring ? u.cols() : u.cols() - 2; }
  Index segment_count() const { return ring ? u.cols() : u.cols() - 1; }
  Site site(Index column) const { return sites.empty() ? kNoSite : sites[static_cast<std::size_t>(column)]; }
};

/// What a cost sees: points in the ambient space, d x (N + 1) for N segments. In a ring the last column is the image
/// of the first. A view: it owns nothing. The two path types cannot be mixed up.
struct AmbientPath {
  Eigen::Map<const Points> x;
  std::span<const Site> sites;
  bool ring = false;

  Index segment_count() const { return x.cols() - 1; }
};

}  // namespace leastcost
