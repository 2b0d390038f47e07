// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/smooth_polyline.hpp"

#include <algorithm>

namespace leastcost {
namespace {

/// Weights of the four points at 0, 1, 2, 3 for the cubic through them at t.
Eigen::Vector4d cubic_weights(double t) {
  const double a = t, b = t - 1, c = t - 2, d = t - 3;
  return {-b * c * d / 6, a * c * d / 2, -a * b * d / 2, a * b * c / 6};
}

}  // namespace

Eigen::MatrixXd smooth_polyline(const Eigen::Ref<const Eigen::MatrixXd>& points, const Eigen::AlignedBoxXd& box) {
  constexpr Eigen::Index kMoves = 4096, kMostPieces = 64;
  const Eigen::Index segments = points.cols() - 1;
  if (points.cols() < 4) return points;
  const Eigen::Index pieces = std::clamp<Eigen::Index>(kMoves / segments, 4, kMostPieces);
  Eigen::MatrixXd out(points.rows(), segments * pieces + 1);
  for (Eigen::Index i = 0; i < segments; ++i) {
    const Eigen::Index first = std::clamp<Eigen::Index>(i - 1, 0, points.cols() - 4);
    for (Eigen::Index k = 0; k < pieces; ++k) {
      const double t = static_cast<double>(i - first) + static_cast<double>(k) / static_cast<double>(pieces);
      const Eigen::VectorXd x = points.middleCols(first, 4) * cubic_weights(t);
      out.col(i * pieces + k) = x.cwiseMax(box.min()).cwiseMin(box.max());
    }
  }
  out.leftCols(1) = points.leftCols(1);
  out.rightCols(1) = points.rightCols(1);
  return out;
}

}  // namespace leastcost
