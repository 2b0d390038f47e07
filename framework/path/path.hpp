// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

using Eigen::Index;
using Points = Eigen::MatrixXd;  ///< one column per point

/// The diagonal of the box around points, in their units: the scale beside which a length is small.
double extent_of(const Points& points);

/// Where on a piecewise domain a point is: the triangle of a mesh, kNoSite elsewhere. A position on an edge does not
/// say which face it belongs to, and the site makes the next projection O(1).
using Site = std::int32_t;
/// Of points that are in no face, cell or patch.
inline constexpr Site kNoSite = -1;

/// A seam of a chart as a map on its universal cover: u -> sign * u + shift, coordinate by coordinate, names the same
/// point of the domain. A shift for a cylinder, a shift with a flip for a Moebius strip. Empty: the identity.
struct SeamMap {
  Eigen::VectorXd sign, shift;  ///< entry by entry: u becomes sign * u + shift; empty: nothing changes

  bool identity() const { return shift.size() == 0; }  ///< whether nothing changes
  /// The coordinates of u on the other side of the seam.
  Eigen::VectorXd apply(const Eigen::VectorXd& u) const {
    return identity() ? u : Eigen::VectorXd(sign.cwiseProduct(u) + shift);
  }
  /// The coordinates before apply().
  Eigen::VectorXd undo(const Eigen::VectorXd& u) const {
    return identity() ? u : Eigen::VectorXd(sign.cwiseProduct(u - shift));
  }
};

/// What a solver moves: points in the coordinates of the manifold.
/// Open: d x (n + 2), first and last column fixed (VFCS 3.2). Ring: d x n, all columns free, closed by the move from
/// the last column to the image of the first under `closing`. `sites` has one entry per column, or none where the
/// domain has no sites.
struct CoordinatePath {
  Points u;                 ///< coordinates, a column for each point
  std::vector<Site> sites;  ///< of every point; empty: none have one
  bool ring = false;        ///< whether the last point is followed by the first
  SeamMap closing = {};     ///< of a ring that crosses seams: which image of its first point it closes on

  Index free_begin() const { return ring ? 0 : 1; }                       ///< column of the first point that may move
  Index free_count() const { return ring ? u.cols() : u.cols() - 2; }     ///< number of points that may move
  Index segment_count() const { return ring ? u.cols() : u.cols() - 1; }  ///< number of moves between neighbours
  /// Column i; in a ring also one turn before and after, on the universal cover: -cols <= i < 2 cols.
  Eigen::VectorXd column(Index i) const {
    if (i < 0) return closing.undo(u.col(i + u.cols()));
    if (i >= u.cols()) return closing.apply(u.col(i - u.cols()));
    return u.col(i);
  }
  /// Of a point; kNoSite: none.
  Site site(Index column) const { return sites.empty() ? kNoSite : sites[static_cast<std::size_t>(column)]; }
};

/// What a cost sees: points in the ambient space, d x (N + 1) for N segments. In a ring the last column is the image
/// of the first. A view: it owns nothing. The two path types cannot be mixed up.
struct AmbientPath {
  Eigen::Map<const Points> x;   ///< places in the ambient space, a column for each point
  std::span<const Site> sites;  ///< of every point; empty: none have one
  bool ring = false;            ///< closed: the last point is the first one again
  /// Of a part of a longer path: whether its first and its last column are no ends of that path.
  bool begins_inside = false, ends_inside = false;

  Index segment_count() const { return x.cols() - 1; }  ///< number of moves between neighbours
  /// Whether the first and the last column are ends of an open path, which derivatives treat as constants.
  bool begin_fixed() const { return !ring && !begins_inside; }
  bool end_fixed() const { return !ring && !ends_inside; }  ///< whether the last point does not move
  /// `count` segments from segment `begin` on.
  AmbientPath part(Index begin, Index count) const {
    return {{x.data() + begin * x.rows(), x.rows(), count + 1},
            sites.empty() ? sites : sites.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(count + 1)),
            ring,
            begins_inside || begin > 0,
            ends_inside || begin + count < segment_count()};
  }
};

}  // namespace leastcost
