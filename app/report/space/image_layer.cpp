// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/space/image_layer.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "problems/drawing/solids.hpp"

namespace leastcost::app {
namespace {

using Eigen::Vector3d;

using Corners = std::array<Vector3d, 3>;

const Vector3d& corner(const TriangleSoup& surface, std::size_t triangle, std::size_t k) {
  return surface.vertices[static_cast<std::size_t>(surface.triangles[triangle][k])];
}

/// Normals at the corners of every triangle: the mean of those around its vertex, but for what lies beyond a crease.
std::vector<Corners> smooth_normals(const TriangleSoup& surface) {
  std::vector<Vector3d> flat, weighted;
  std::vector<std::size_t> first(surface.vertices.size() + 1, 0);  // of the triangles around each vertex
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Vector3d& a = corner(surface, t, 0);
    weighted.emplace_back((corner(surface, t, 1) - a).cross(corner(surface, t, 2) - a));
    flat.emplace_back(weighted.back().normalized());
    for (const int v : surface.triangles[t]) ++first[static_cast<std::size_t>(v) + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::size_t> around(3 * surface.triangles.size()), next(first.begin(), first.end() - 1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const int v : surface.triangles[t]) around[next[static_cast<std::size_t>(v)]++] = t;
  std::vector<Corners> all(surface.triangles.size());
  for (std::size_t t = 0; t < all.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(surface.triangles[t][k]);
      Vector3d sum = Vector3d::Zero();
      for (std::size_t i = first[v]; i < first[v + 1]; ++i)
        if (flat[around[i]].dot(flat[t]) > kCrease) sum += weighted[around[i]];
      all[t][k] = sum.normalized();
    }
  return all;
}

/// The weights of the corners of a triangle at a place of the view.
Vector3d weights(const Corners& seen, const Eigen::Vector2d& at) {
  const Eigen::Vector2d u = (seen[1] - seen[0]).head<2>(), v = (seen[2] - seen[0]).head<2>(),
                        p = at - seen[0].head<2>();
  const double area = u[0] * v[1] - u[1] * v[0];
  if (area == 0) return {1, 0, 0};
  const double s = (p[0] * v[1] - p[1] * v[0]) / area, t = (u[0] * p[1] - u[1] * p[0]) / area;
  return {1 - s - t, s, t};
}

}  // namespace

LayerOfImage::LayerOfImage(const ImageLayer& layer, const SpaceView& view)
    : layer_(&layer), view_(view), normals_(smooth_normals(layer.surface)) {
  turned_.triangles = layer.surface.triangles;
  for (const Vector3d& x : layer.surface.vertices) {
    turned_.vertices.emplace_back(view.axes * x);
    box_.extend(Eigen::Vector2d(turned_.vertices.back().head<2>()));
  }
}

LayerInBand LayerOfImage::look(const PixelGrid& grid) const {
  PixelGrid part = grid;
  const auto pixel = [&](double x, Eigen::Index i, int most) {
    return static_cast<int>(std::clamp((x - grid.origin[i]) / grid.pixel, 0.0, static_cast<double>(most)));
  };
  if (box_.isEmpty()) return {0, 0, 0, {}};
  const int left = pixel(box_.min()[0], 0, grid.columns), bottom = pixel(box_.min()[1], 1, grid.rows);
  part.columns = std::min(grid.columns, pixel(box_.max()[0], 0, grid.columns) + 2) - left;
  part.rows = std::min(grid.rows, pixel(box_.max()[1], 1, grid.rows) + 2) - bottom;
  if (part.columns <= 0 || part.rows <= 0) return {0, 0, 0, {}};
  part.origin += grid.pixel * Eigen::Vector2d(left, bottom);
  const DepthMap map(turned_, SpaceView{}, part, layer_->one_sided);
  std::vector<SeenSample> out(static_cast<std::size_t>(part.columns) * static_cast<std::size_t>(part.rows));
  std::size_t next = 0;
  for (int row = 0; row < part.rows; ++row)
    for (int column = 0; column < part.columns; ++column, ++next) {
      const int number = map.triangle(column, row);
      if (number < 0) continue;
      const auto t = static_cast<std::size_t>(number);
      const Vector3d &a = corner(turned_, t, 0), &b = corner(turned_, t, 1), &c = corner(turned_, t, 2);
      const Vector3d w = weights({a, b, c}, part.origin + part.pixel * Eigen::Vector2d(column, row));
      const Vector3d normal = view_.axes * (w[0] * normals_[t][0] + w[1] * normals_[t][1] + w[2] * normals_[t][2]);
      const bool from_behind = (b - a).cross(c - a)[2] < 0;
      out[next] = {map.depth(column, row), (from_behind ? -normal : normal).normalized()};
    }
  return {left, bottom, part.columns, std::move(out)};
}

}  // namespace leastcost::app
