// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/trajectory/blended_path.hpp"

#include <algorithm>
#include <cmath>

namespace leastcost {

Eigen::VectorXd PathPiece::place(double s) const {
  const double t = s - from;
  return at + t * (slope + t / 2 * bend);
}

BlendedPath::BlendedPath(const Points& points, const Eigen::VectorXd& blends) {
  const Index d = points.rows(), moves = points.cols() - 1;
  const Points ways = points.rightCols(moves) - points.leftCols(moves);
  const Eigen::VectorXd lengths = ways.colwise().norm();
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(d);
  double before = 0;  // of the segment that begins: what the last parabola took of it
  double s = 0;
  for (Index i = 0; i < moves; ++i) {
    const Eigen::VectorXd way = ways.col(i) / lengths[i];
    const bool last = i + 1 == moves;
    const double half = last ? 0 : blends[i] * std::min(lengths[i], lengths[i + 1]) / 2;
    const double straight = lengths[i] - before - half;
    if (straight > 0) {  // nothing is left where both corners take their halves
      pieces_.push_back({s, s + straight, points.col(i) + before * way, way, still});
      s += straight;
    }
    if (last) break;
    const Eigen::VectorXd next = ways.col(i + 1) / lengths[i + 1];
    corners_.push_back(static_cast<Index>(pieces_.size()));
    pieces_.push_back({s, s + 2 * half, points.col(i + 1) - half * way, way, (next - way) / (2 * half)});
    s += 2 * half;
    before = half;
  }
}

/// Of the parabola with the control points a, p, b, t of the way along it: it is t^2 |a - 2p + b| from a place of the
/// segment a p, and t^2 of b's distance from its line; and so from the other end.
double BlendedPath::deviation() const {
  double farthest = 0;
  for (const Index i : corners_) {
    const PathPiece& piece = pieces_[static_cast<std::size_t>(i)];
    const double half = piece.length() / 2;
    const Eigen::VectorXd next = piece.direction(piece.to);
    double off = half * (next - piece.slope).norm() / 4;
    const double cosine = next.dot(piece.slope);
    if (cosine >= 0) off = std::min(off, half * (next - cosine * piece.slope).norm() / 4);  // feet on the segments
    farthest = std::max(farthest, off);
  }
  return farthest;
}

}  // namespace leastcost
