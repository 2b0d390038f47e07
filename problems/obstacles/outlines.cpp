// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/obstacles/outlines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace leastcost {
namespace {

constexpr int kPointsOfCircle = 64;
constexpr std::size_t kMost = 2000;  ///< obstacles in a picture

/// What lies `off` from the corners and edges of a polygon: a closed polyline, round at its outward corners.
Points outline(const Eigen::MatrixXd& corners, double off) {
  const Eigen::Index m = corners.cols();
  const auto normal = [&](Eigen::Index i) {  // outward, of the edge after corner i
    const Eigen::Vector2d edge = corners.col((i + 1) % m) - corners.col(i % m);
    return std::atan2(-edge.x(), edge.y());
  };
  std::vector<Eigen::Vector2d> points;
  const auto arc = [&](const Eigen::Vector2d& corner, double from, double angle) {
    const int pieces = 1 + static_cast<int>(std::abs(angle) * kPointsOfCircle / (2 * std::numbers::pi));
    for (int k = 0; k <= pieces; ++k) {
      const double at = from + angle * k / pieces;
      points.emplace_back(corner + off * Eigen::Vector2d(std::cos(at), std::sin(at)));
    }
  };
  for (Eigen::Index i = 0; i < m; ++i) {
    if (off == 0) {
      points.emplace_back(corners.col(i));
    } else if (m == 1) {
      arc(corners.col(0), 0, 2 * std::numbers::pi);
    } else {
      const double before = normal(i + m - 1), turn = std::remainder(normal(i) - before, 2 * std::numbers::pi);
      arc(corners.col(i), before, m == 2 ? std::numbers::pi : turn);  // half round the ends of a segment
    }
  }
  points.push_back(points.front());
  Points line(2, static_cast<Index>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) line.col(static_cast<Index>(k)) = points[k];
  return line;
}

}  // namespace

void draw_outlines(const std::vector<std::shared_ptr<const Obstacle>>& obstacles, double clearance, Drawing& out) {
  if (obstacles.empty()) return;
  if (obstacles.front()->core_bounds().dim() != 2) {
    out.notes.emplace_back("obstacles in space are not drawn");
    return;
  }
  std::size_t count = 0;
  for (const auto& obstacle : obstacles) {
    const Eigen::MatrixXd corners = obstacle->corners();
    if (corners.cols() == 0) out.notes.push_back(obstacle->name() + " is not drawn");
    if (corners.cols() == 0 || !obstacle->drawn() || ++count > kMost) continue;
    out.obstacles.push_back(outline(corners, obstacle->radius()));
    if (clearance > 0) out.margins.push_back(outline(corners, obstacle->radius() + clearance));
  }
  if (count > kMost)
    out.notes.push_back("of " + std::to_string(count) + " obstacles " + std::to_string(kMost) + " are drawn");
}

}  // namespace leastcost
