// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// q(s) = at + (s - from) slope + (s - from)^2 / 2 bend for from <= s <= to: a straight piece, or a parabola.
struct PathPiece {
  double from = 0, to = 0;  ///< lengths of the polyline from its beginning
  Eigen::VectorXd at, slope, bend;

  double length() const { return to - from; }
  Eigen::VectorXd place(double s) const;
  Eigen::VectorXd direction(double s) const { return slope + (s - from) * bend; }
};

/// A polyline whose corners are rounded by parabolas, so that something with inertia can follow it without stopping:
/// q' is continuous, and no longer than 1. At a corner the parabola leaves the polyline as far before it as it joins it
/// again behind it; it stays in the triangle of these two places and the corner. Of a chord polygon around a disc
/// that it touches the rounding touches the disc and does not enter it.
class BlendedPath {
 public:
  /// `points`: d x m, m >= 2, no two neighbours equal. `blends`: for each of the m - 2 corners the part of the half of
  /// the shorter of its segments that is rounded, 0 < blend <= 1.
  BlendedPath(const Points& points, const Eigen::VectorXd& blends);

  const std::vector<PathPiece>& pieces() const { return pieces_; }
  double length() const { return pieces_.back().to; }
  /// The parabola of corner 0 .. m - 3.
  const PathPiece& corner(Index i) const {
    return pieces_[static_cast<std::size_t>(corners_[static_cast<std::size_t>(i)])];
  }
  /// No place of the curve is farther from the polyline.
  double deviation() const;

 private:
  std::vector<PathPiece> pieces_;
  std::vector<Index> corners_;  ///< numbers of their pieces
};

}  // namespace leastcost
