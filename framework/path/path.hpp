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
inline double extent_of(const Points& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

/// Where on a piecewise domain a point is: the triangle of a mesh, kNoSite elsewhere. A position on an edge does not
/// say which face it belongs to, and the site makes the next projection O(1).
using Site = std::int32_t;
inline constexpr Site kNoSite = -1;

/// A seam of a chart as a map on its universal cover: u -> sign * u + shift, coordinate by coordinate, names the same
/// point of the domain. A shift for a cylinder, a shift with a flip for a Moebius strip. Empty: the identity.
struct SeamMap {
  Eigen::VectorXd sign, shift;

  bool identity() const { return shift.size() == 0; }
  Eigen::VectorXd apply(const Eigen::VectorXd& u) const {
    return identity() ? u : Eigen::VectorXd(sign.cwiseProduct(u) + shift);
  }
  Eigen::VectorXd undo(const Eigen::VectorXd& u) const {
    return identity() ? u : Eigen::VectorXd(sign.cwiseProduct(u - shift));
  }
};

/// What a solver moves: points in the coordinates of the manifold.
/// Open: d x (n + 2), first and last column fixed (VFCS 3.2). Ring: d x n, all columns free, closed by the move from
/// the last column to the image of the first under `closing`. `sites` has one entry per column, or none where the
/// domain has no sites.
struct CoordinatePath {
  Points u;
  std::vector<Site> sites;
  bool ring = false;
  SeamMap closing = {};  ///< of a ring that crosses seams: which image of its first point it closes on

  Index free_begin() const { return ring ? 0 : 1; }
  Index free_count() const { return ring ? u.cols() : u.cols() - 2; }
  Index segment_count() const { return ring ? u.cols() : u.cols() - 1; }
  /// Column i; in a ring also one turn before and after, on the universal cover: -cols <= i < 2 cols.
  Eigen::VectorXd column(Index i) const {
    if (i < 0) return closing.undo(u.col(i + u.cols()));
    if (i >= u.cols()) return closing.apply(u.col(i - u.cols()));
    return u.col(i);
  }
  Site site(Index column) const { return sites.empty() ? kNoSite : sites[static_cast<std::size_t>(column)]; }
};

/// What a cost sees: points in the ambient space, d x (N + 1) for N segments. In a ring the last column is the image
/// of the first. A view: it owns nothing. The two path types cannot be mixed up.
struct AmbientPath {
  Eigen::Map<const Points> x;
  std::span<const Site> sites;
  bool ring = false;
  /// Of a part of a longer path: whether its first and its last column are no ends of that path.
  bool begins_inside = false, ends_inside = false;

  Index segment_count() const { return x.cols() - 1; }
  /// Whether the first and the last column are ends of an open path, which derivatives treat as constants.
  bool begin_fixed() const { return !ring && !begins_inside; }
  bool end_fixed() const { return !ring && !ends_inside; }
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
