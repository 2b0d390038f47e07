// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "app/report/run/space_view.hpp"
#include "catalogue/inputs/png_image.hpp"

namespace leastcost::app {
namespace {

constexpr int kSamples = 2;      ///< of a pixel, in each direction
constexpr double kCrease = 0.5;  ///< cosine: a sharper edge stays one

using Corners = std::array<Eigen::Vector3d, 3>;

const Eigen::Vector3d& corner(const TriangleSoup& surface, std::size_t triangle, std::size_t k) {
  return surface.vertices[static_cast<std::size_t>(surface.triangles[triangle][k])];
}

/// Normals at the corners of every triangle: the mean of those around its vertex, but for what lies beyond a crease.
std::vector<Corners> smooth_normals(const TriangleSoup& surface) {
  std::vector<Eigen::Vector3d> flat, weighted;
  std::vector<std::size_t> first(surface.vertices.size() + 1, 0);  // of the triangles around each vertex
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Eigen::Vector3d& a = corner(surface, t, 0);
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
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t i = first[v]; i < first[v + 1]; ++i)
        if (flat[around[i]].dot(flat[t]) > kCrease) sum += weighted[around[i]];
      all[t][k] = sum.normalized();
    }
  return all;
}

/// The weights of the corners of a triangle at a place of the view.
Eigen::Vector3d weights(const Corners& seen, const Eigen::Vector2d& at) {
  const Eigen::Vector2d u = (seen[1] - seen[0]).head<2>(), v = (seen[2] - seen[0]).head<2>(),
                        p = at - seen[0].head<2>();
  const double area = u[0] * v[1] - u[1] * v[0];
  if (area == 0) return {1, 0, 0};
  const double s = (p[0] * v[1] - p[1] * v[0]) / area, t = (u[0] * p[1] - u[1] * p[0]) / area;
  return {1 - s - t, s, t};
}

}  // namespace

ShadedImage shaded_image(const TriangleSoup& surface, const SpaceView& view, int pixels) {
  constexpr int kWhite = 255;
  const DepthMap map(surface, view, kSamples * std::max(1, pixels));
  const std::vector<Corners> normals = smooth_normals(surface);
  std::vector<Eigen::Vector3d> seen;
  seen.reserve(surface.vertices.size());
  for (const Eigen::Vector3d& x : surface.vertices) seen.emplace_back(view.axes * x);
  const auto colour = [&](int column, int row) -> std::array<int, 3> {
    const int number = column < map.columns() && row < map.rows() ? map.triangle(column, row) : -1;
    if (number < 0) return {kWhite, kWhite, kWhite};
    const auto t = static_cast<std::size_t>(number);
    const auto at = [&](std::size_t k) { return seen[static_cast<std::size_t>(surface.triangles[t][k])]; };
    const Eigen::Vector3d w = weights({at(0), at(1), at(2)}, map.middle(column, row));
    const Eigen::Vector3d normal = view.axes * (w[0] * normals[t][0] + w[1] * normals[t][1] + w[2] * normals[t][2]);
    const bool from_behind = (at(1) - at(0)).cross(at(2) - at(0))[2] < 0;
    return colour_of_light(lightness((from_behind ? -normal : normal).normalized()));
  };
  const int width = (map.columns() + kSamples - 1) / kSamples, height = (map.rows() + kSamples - 1) / kSamples;
  std::vector<std::uint8_t> rgb;
  rgb.reserve(std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int row = height - 1; row >= 0; --row)
    for (int column = 0; column < width; ++column) {
      std::array<int, 3> sum{};
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const std::array<int, 3> one = colour(kSamples * column + k % kSamples, kSamples * row + k / kSamples);
        for (std::size_t i = 0; i < 3; ++i) sum[i] += one[i];
      }
      for (const int value : sum) rgb.push_back(static_cast<std::uint8_t>(value / (kSamples * kSamples)));
    }
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(map.pixel() / 2), lower = map.middle(0, 0) - half;
  return {png_of_rgb(rgb, width, height), {lower, lower + kSamples * map.pixel() * Eigen::Vector2d(width, height)}};
}

}  // namespace leastcost::app
