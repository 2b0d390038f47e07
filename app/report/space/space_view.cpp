// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/space/space_view.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "problems/drawing/thinned.hpp"

namespace leastcost::app {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Two directions of the horizon: the first one that of x, or of y if x is the vertical.
std::array<Eigen::Vector3d, 2> horizon(const Eigen::Vector3d& up) {
  const Eigen::Vector3d any = std::abs(up[0]) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  const Eigen::Vector3d e1 = (any - any.dot(up) * up).normalized();
  return {e1, up.cross(e1)};
}

/// For choosing a side from which to look at a cloud, a thousand points are enough.
TriangleSoup few_squares(const Surfels& surfels) {
  const std::size_t step = surfels.positions.size() / 1000 + 1;
  Surfels few;
  for (std::size_t i = 0; i < surfels.positions.size(); i += step) {
    few.positions.push_back(surfels.positions[i]);
    few.normals.push_back(surfels.normals[i]);
  }
  few.spacing = surfels.spacing * std::sqrt(static_cast<double>(step));
  return squares(few);
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

std::vector<Eigen::Vector3d> in_view(const TriangleSoup& surface, const SpaceView& view) {
  std::vector<Eigen::Vector3d> seen;
  seen.reserve(surface.vertices.size());
  for (const Eigen::Vector3d& x : surface.vertices) seen.emplace_back(view.axes * x);
  return seen;
}

}  // namespace

DepthMap::DepthMap(const TriangleSoup& surface, const SpaceView& view, int pixels) : view_(view) {
  if (surface.triangles.empty()) return;
  const std::vector<Eigen::Vector3d> seen = in_view(surface, view);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : seen) box.extend(x);
  grid_.origin = box.min().head<2>();
  grid_.pixel = std::max(box.diagonal().head<2>().maxCoeff() / (pixels - 1), 1e-300);
  grid_.columns = 1 + static_cast<int>(std::ceil(box.diagonal()[0] / grid_.pixel * (1 - 1e-12)));
  grid_.rows = 1 + static_cast<int>(std::ceil(box.diagonal()[1] / grid_.pixel * (1 - 1e-12)));
  draw_all(surface, seen, false);
}

DepthMap::DepthMap(const TriangleSoup& surface, const SpaceView& view, const PixelGrid& grid, bool one_sided)
    : view_(view), grid_(grid) {
  draw_all(surface, in_view(surface, view), one_sided);
}

void DepthMap::draw_all(const TriangleSoup& surface, const std::vector<Eigen::Vector3d>& seen, bool one_sided) {
  depth_.assign(index(0, grid_.rows), -std::numeric_limits<double>::infinity());
  front_.assign(depth_.size(), -1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto at = [&](std::size_t k) -> const Eigen::Vector3d& {
      return seen[static_cast<std::size_t>(surface.triangles[t][k])];
    };
    if (one_sided && (at(1) - at(0)).cross(at(2) - at(0))[2] <= 0) continue;
    draw(static_cast<int>(t), at(0), at(1), at(2));
  }
}

void DepthMap::draw(int number, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector2d u = (b - a).head<2>(), v = (c - a).head<2>();
  const double area = u[0] * v[1] - u[1] * v[0];
  if (area == 0) return;
  // An edge belongs to both of its triangles, up to a small part of a pixel.
  const double slack = std::min(0.01, 0.1 * grid_.pixel * std::max(u.norm(), v.norm()) / std::abs(area));
  constexpr double kFar = 1e6;  // pixels: beyond any grid
  const auto first = [&](Index i) {
    const double at = (std::min({a[i], b[i], c[i]}) - grid_.origin[i]) / grid_.pixel;
    return static_cast<int>(std::floor(std::clamp(at, -kFar, kFar)));
  };
  const auto last = [&](Index i) {
    const double at = (std::max({a[i], b[i], c[i]}) - grid_.origin[i]) / grid_.pixel;
    return static_cast<int>(std::ceil(std::clamp(at, -kFar, kFar)));
  };
  // Its coordinates s and t, and the depth, are linear along a row: the row meets it between two pixels.
  const double ds = grid_.pixel * v[1] / area, dt = -grid_.pixel * u[1] / area;
  const double deeper = ds * (b[2] - a[2]) + dt * (c[2] - a[2]);
  const double left = std::max(0, first(0)), right = std::min(grid_.columns - 1, last(0));
  for (int j = std::max(0, first(1)); j <= std::min(grid_.rows - 1, last(1)); ++j) {
    const Eigen::Vector2d p = grid_.origin + grid_.pixel * Eigen::Vector2d(0, j) - a.head<2>();
    const double s = (p[0] * v[1] - p[1] * v[0]) / area, t = (u[0] * p[1] - u[1] * p[0]) / area;
    double begin = left, end = right;
    const auto keep = [&](double at_first, double slope) {  // where at_first + i slope is not negative
      if (slope > 0) begin = std::max(begin, -at_first / slope);
      if (slope < 0) end = std::min(end, -at_first / slope);
      if (slope == 0 && at_first < 0) end = -1;
    };
    keep(s + slack, ds);
    keep(t + slack, dt);
    keep(1 + slack - s - t, -ds - dt);
    if (!(begin <= end)) continue;
    const double depth_left = a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2]);
    for (int i = static_cast<int>(std::ceil(begin)); i <= static_cast<int>(std::floor(end)); ++i) {
      const double depth = depth_left + i * deeper;
      if (!(depth > depth_[index(i, j)])) continue;
      depth_[index(i, j)] = depth;
      front_[index(i, j)] = number;
    }
  }
}

bool DepthMap::sees(const Eigen::Vector3d& x) const {
  constexpr double kSlack = 4;  // pixels: ground seen at 20 degrees is three of them deeper in the next one
  const Eigen::Vector3d p = view_.axes * x;
  const int i = static_cast<int>(std::lround((p[0] - grid_.origin[0]) / grid_.pixel)),
            j = static_cast<int>(std::lround((p[1] - grid_.origin[1]) / grid_.pixel));
  if (i < 0 || j < 0 || i >= grid_.columns || j >= grid_.rows) return true;
  return p[2] >= depth_[index(i, j)] - kSlack * grid_.pixel;
}

TriangleSoup squares(const Surfels& surfels, double half_side) {
  TriangleSoup out;
  for (std::size_t i = 0; i < surfels.positions.size(); ++i) {
    const Eigen::Vector3d& n = surfels.normals[i];
    const Eigen::Vector3d a = half_side * surfels.spacing * n.unitOrthogonal(), b = n.cross(a);
    const int first = static_cast<int>(out.vertices.size());
    for (const Eigen::Vector3d& corner :
         {Eigen::Vector3d(a + b), Eigen::Vector3d(a - b), Eigen::Vector3d(-a - b), Eigen::Vector3d(b - a)})
      out.vertices.emplace_back(surfels.positions[i] + corner);
    out.triangles.push_back({first, first + 1, first + 2});
    out.triangles.push_back({first, first + 2, first + 3});
  }
  return out;
}

SpaceView view_from(const Angles& angles, const Eigen::Vector3d& up) {
  const auto [e1, e2] = horizon(up);
  const double turn = angles.azimuth * kDegree, rise = angles.elevation * kDegree;
  SpaceView view;  // also from straight above
  view.axes.row(0) = -std::sin(turn) * e1 + std::cos(turn) * e2;
  view.axes.row(2) = std::cos(rise) * (std::cos(turn) * e1 + std::sin(turn) * e2) + std::sin(rise) * up;
  view.axes.row(1) = view.axes.row(2).cross(view.axes.row(0));
  return view;
}

Angles angles_of(const SpaceView& view, const Eigen::Vector3d& up) {
  const auto [e1, e2] = horizon(up);
  const Eigen::Vector3d right = view.axes.row(0), direction = view.direction();
  const double turn = std::round(std::atan2(-right.dot(e1), right.dot(e2)) / kDegree);
  return {turn < 0 ? turn + 360 : turn, std::round(std::asin(std::clamp(direction.dot(up), -1.0, 1.0)) / kDegree)};
}

SpaceView choose_view(const Scene& scene) {
  constexpr int kAround = 14, kPixels = 96;
  constexpr std::size_t kTriangles = 1200;
  const Points& path = scene.lines.path;
  const TriangleSoup surface =
      scene.surface.triangles.empty() ? few_squares(scene.surfels) : thinned(scene.surface, Points(3, 0), kTriangles);
  const Eigen::Vector3d extent = path.rowwise().maxCoeff() - path.rowwise().minCoeff();
  const double size = std::max(extent.norm(), 1e-300);
  const Index step = std::max<Index>(1, path.cols() / 80);
  const Eigen::Vector3d towards_path = lean(surface, path);
  struct Candidate {
    SpaceView view;
    double large, side, liking;
    std::size_t number;
    /// What is seen counts most, then how large, and from which side of the surface.
    double score(double part_seen) const { return part_seen + large + side + liking; }
  };
  std::vector<Candidate> candidates;
  // Degrees above the horizon, and how much they are liked: from below only where much more of the path is seen there.
  constexpr std::array<std::array<double, 2>, 4> kElevations = {{{28, 0.06}, {50, 0.03}, {8, 0}, {-28, -0.3}}};
  for (const auto& [elevation, liking] : kElevations) {
    for (int k = 0; k < kAround; ++k) {
      const SpaceView view = view_from({360 * (k + 0.3) / kAround, elevation}, scene.up);
      candidates.push_back({view, 0.5 * size_seen(view, path) / size, 0.8 * towards_path.dot(view.direction()), liking,
                            candidates.size()});
    }
  }
  // The best ones first, if all of the path is seen: most of the others need no picture.
  const auto most = [](const Candidate& c) { return std::isfinite(c.score(1)) ? c.score(1) : 0; };
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](const Candidate& a, const Candidate& b) { return most(a) > most(b); });
  const Candidate* best = &candidates.front();
  double best_score = -1e300;
  for (const Candidate& c : candidates) {
    if (c.score(1) < best_score) break;
    const DepthMap depths(surface, c.view, kPixels);
    double seen = 0, all = 0;
    for (Index i = 0; i < path.cols(); i += step, ++all) seen += depths.sees(path.col(i)) ? 1 : 0;
    const double score = c.score(seen / all);
    if (score < best_score || (score == best_score && c.number > best->number)) continue;
    best_score = score;
    best = &c;
  }
  return best->view;
}

}  // namespace leastcost::app
