// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/costs/lagrangian/lagrangian_hull.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace leastcost {
namespace {

constexpr int kDirections = 128;
constexpr double kTurn = 2 * std::numbers::pi, kStepAngle = kTurn / kDirections;

double cross_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a[0] * b[1] - a[1] * b[0]; }

/// The curve F(x, v) = 1, point by point, anticlockwise; empty where F is not positive in some direction.
std::vector<Eigen::Vector2d> indicatrix(const Formula& f, const Point<double, 2>& x) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(kDirections);
  for (int i = 0; i < kDirections; ++i) {
    const Eigen::Vector2d u(std::cos(i * kStepAngle), std::sin(i * kStepAngle));
    const std::array<double, 4> xv = {x[0], x[1], u[0], u[1]};
    const double value = f(std::span<const double>(xv));
    if (!(value > 0) || !std::isfinite(value)) return {};
    points.emplace_back(u / value);
  }
  return points;
}

/// Corners of the convex hull of a curve around the origin, as positions on it, from its farthest point on, which is
/// the last as well, a turn later.
std::vector<int> hull_corners(const std::vector<Eigen::Vector2d>& points) {
  int first = 0;
  for (int i = 1; i < kDirections; ++i)
    if (points[static_cast<std::size_t>(i)].norm() > points[static_cast<std::size_t>(first)].norm()) first = i;
  const auto at = [&](int i) { return points[static_cast<std::size_t>(i % kDirections)]; };
  std::vector<int> corners;
  for (int i = first; i <= first + kDirections; ++i) {
    while (corners.size() >= 2 &&
           !(cross_of(at(corners.back()) - at(corners[corners.size() - 2]), at(i) - at(corners.back())) > 0))
      corners.pop_back();
    corners.push_back(i);
  }
  return corners;
}

/// The common tangent near an edge of the hull; the edge itself where Newton's method finds none.
LagrangianGap refined(const Formula& f, const Point<double, 2>& x, const LagrangianGap& edge) {
  constexpr int kSteps = 20;
  constexpr double kLargest = kStepAngle / 2;
  LagrangianGap gap = edge;
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::Vector2d defect = tangent_defect<double>(f, x, gap.from, gap.to);
    const Eigen::Vector2d step = tangent_jacobian(f, x, gap).inverse() * defect;
    if (!step.allFinite()) return edge;
    const double size = step.cwiseAbs().maxCoeff(), part = size > kLargest ? kLargest / size : 1;
    gap.from -= part * step[0];
    gap.to -= part * step[1];
    if (size <= 1e-13) break;
  }
  const bool near = std::abs(gap.from - edge.from) < 2 * kStepAngle && std::abs(gap.to - edge.to) < 2 * kStepAngle;
  return near && gap.from < gap.to ? gap : edge;
}

}  // namespace

Eigen::Matrix2d tangent_jacobian(const Formula& f, const Point<double, 2>& x, const LagrangianGap& gap) {
  // F_v = F u + F_t w with u = (cos t, sin t) and w across it; its derivative in t is (F + F_tt) w.
  const auto stiffness = [&](double t) {
    using S = Dual<double, 1>;
    const AngularSlope<S> a = angular_slope<S>(f, {S(x[0]), S(x[1])}, S(t, {1.0}));
    return a.value.value + a.slope.d[0];
  };
  const double a = stiffness(gap.from), b = stiffness(gap.to);
  Eigen::Matrix2d jacobian;
  jacobian << -a * std::sin(gap.from), b * std::sin(gap.to), a * std::cos(gap.from), -b * std::cos(gap.to);
  return jacobian;
}

std::optional<LagrangianGap> gap_around(const Formula& f, const Point<double, 2>& x, double angle) {
  const std::vector<Eigen::Vector2d> points = indicatrix(f, x);
  if (points.empty()) return std::nullopt;
  const std::vector<int> corners = hull_corners(points);
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    if (corners[i + 1] == corners[i] + 1) continue;
    const LagrangianGap edge{corners[i] * kStepAngle, corners[i + 1] * kStepAngle};
    const double turned = edge.from + std::remainder(angle - edge.from, kTurn);
    const double own = turned < edge.from - kTurn / 4 ? turned + kTurn : turned;
    if (own < edge.from - 2 * kStepAngle || own > edge.to + 2 * kStepAngle) continue;
    const LagrangianGap gap = refined(f, x, edge);
    if (gap.from < own && own < gap.to) return gap;
  }
  return std::nullopt;
}

}  // namespace leastcost
