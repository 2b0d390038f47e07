// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/run/space_view.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace leastcost::app {
namespace {

SpaceView view_from(const Eigen::Vector3d& direction, const Eigen::Vector3d& up) {
  SpaceView view;
  const Eigen::Vector3d right = up.cross(direction).normalized();
  view.axes.row(0) = right;
  view.axes.row(1) = direction.cross(right);
  view.axes.row(2) = direction;
  return view;
}

/// From the middle of the surface to that of the path, in sizes of the surface.
Eigen::Vector3d lean(const TriangleSoup& surface, const Points& path) {
  if (surface.vertices.empty()) return Eigen::Vector3d::Zero();
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : surface.vertices) box.extend(x);
  return (path.rowwise().mean() - box.center()) / std::max(box.diagonal().norm(), 1e-300);
}

/// Diagonal of the path's picture; how large it is seen.
double size_seen(const SpaceView& view, const Points& path) {
  const Points seen = view.axes.topRows(2) * path;
  return (seen.rowwise().maxCoeff() - seen.rowwise().minCoeff()).norm();
}

}  // namespace

DepthMap::DepthMap(const TriangleSoup& surface, const SpaceView& view, int pixels)
    : view_(view),
      pixels_(pixels),
      depth_(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels),
             -std::numeric_limits<double>::infinity()) {
  if (surface.triangles.empty()) return;
  std::vector<Eigen::Vector3d> seen;
  seen.reserve(surface.vertices.size());
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : surface.vertices) {
    seen.emplace_back(view.axes * x);
    box.extend(seen.back());
  }
  origin_ = box.min();
  pixel_ = std::max(box.diagonal().head<2>().maxCoeff() / (pixels - 1), 1e-300);
  for (const auto& [a, b, c] : surface.triangles)
    draw(seen[static_cast<std::size_t>(a)], seen[static_cast<std::size_t>(b)], seen[static_cast<std::size_t>(c)]);
}

void DepthMap::draw(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector2d u = (b - a).head<2>(), v = (c - a).head<2>();
  const double area = u[0] * v[1] - u[1] * v[0];
  if (area == 0) return;
  const auto first = [&](Index i) {
    return static_cast<int>(std::floor((std::min({a[i], b[i], c[i]}) - origin_[i]) / pixel_));
  };
  const auto last = [&](Index i) {
    return static_cast<int>(std::ceil((std::max({a[i], b[i], c[i]}) - origin_[i]) / pixel_));
  };
  for (int j = std::max(0, first(1)); j <= std::min(pixels_ - 1, last(1)); ++j) {
    for (int i = std::max(0, first(0)); i <= std::min(pixels_ - 1, last(0)); ++i) {
      const Eigen::Vector2d p = origin_.head<2>() + pixel_ * Eigen::Vector2d(i, j) - a.head<2>();
      const double s = (p[0] * v[1] - p[1] * v[0]) / area, t = (u[0] * p[1] - u[1] * p[0]) / area;
      if (s < -0.01 || t < -0.01 || s + t > 1.01) continue;
      double& depth =
          depth_[static_cast<std::size_t>(j) * static_cast<std::size_t>(pixels_) + static_cast<std::size_t>(i)];
      depth = std::max(depth, a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2]));
    }
  }
}

bool DepthMap::sees(const Eigen::Vector3d& x) const {
  const Eigen::Vector3d p = view_.axes * x;
  const int i = static_cast<int>(std::lround((p[0] - origin_[0]) / pixel_)),
            j = static_cast<int>(std::lround((p[1] - origin_[1]) / pixel_));
  if (i < 0 || j < 0 || i >= pixels_ || j >= pixels_) return true;
  return p[2] >= depth_[static_cast<std::size_t>(j) * static_cast<std::size_t>(pixels_) + static_cast<std::size_t>(i)] -
                     2 * pixel_;
}

TriangleSoup squares(const Surfels& surfels) {
  TriangleSoup out;
  for (std::size_t i = 0; i < surfels.positions.size(); ++i) {
    const Eigen::Vector3d& n = surfels.normals[i];
    const Eigen::Vector3d a = 0.6 * surfels.spacing * n.unitOrthogonal(), b = n.cross(a);
    const int first = static_cast<int>(out.vertices.size());
    for (const Eigen::Vector3d& corner :
         {Eigen::Vector3d(a + b), Eigen::Vector3d(a - b), Eigen::Vector3d(-a - b), Eigen::Vector3d(b - a)})
      out.vertices.emplace_back(surfels.positions[i] + corner);
    out.triangles.push_back({first, first + 1, first + 2});
    out.triangles.push_back({first, first + 2, first + 3});
  }
  return out;
}

SpaceView choose_view(const TriangleSoup& surface, const Points& path, const Eigen::Vector3d& up) {
  constexpr int kAround = 14, kPixels = 96;
  const Eigen::Vector3d any = std::abs(up[0]) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  const Eigen::Vector3d e1 = (any - any.dot(up) * up).normalized(), e2 = up.cross(e1);
  const Eigen::Vector3d extent = path.rowwise().maxCoeff() - path.rowwise().minCoeff();
  const double size = std::max(extent.norm(), 1e-300);
  const Index step = std::max<Index>(1, path.cols() / 80);
  const Eigen::Vector3d towards_path = lean(surface, path);
  SpaceView best;
  double best_score = -1e300;
  // Degrees above the horizon, and how much they are liked.
  constexpr std::array<std::array<double, 2>, 3> kElevations = {{{28, 0.06}, {50, 0.03}, {8, 0}}};
  for (const auto& [elevation, liking] : kElevations) {
    for (int k = 0; k < kAround; ++k) {
      const double turn = 2 * std::numbers::pi * (k + 0.3) / kAround, rise = elevation * std::numbers::pi / 180;
      const SpaceView view =
          view_from(std::cos(rise) * (std::cos(turn) * e1 + std::sin(turn) * e2) + std::sin(rise) * up, up);
      const DepthMap depths(surface, view, kPixels);
      double seen = 0, all = 0;
      for (Index i = 0; i < path.cols(); i += step, ++all) seen += depths.sees(path.col(i)) ? 1 : 0;
      // What is seen counts most, then how large, and from which side of the surface.
      const double score =
          seen / all + 0.5 * size_seen(view, path) / size + 0.8 * towards_path.dot(view.direction()) + liking;
      if (score <= best_score) continue;
      best_score = score;
      best = view;
    }
  }
  return best;
}

}  // namespace leastcost::app
