// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>

/// Small surfaces with known facts, for tests.
namespace leastcost::test {

inline void add_polygon(PolygonSoup& soup, std::initializer_list<std::int32_t> corners) {
  if (soup.polygon_begin.empty()) soup.polygon_begin.push_back(0);
  soup.corners.insert(soup.corners.end(), corners);
  soup.polygon_begin.push_back(static_cast<std::int32_t>(soup.corners.size()));
}

/// [-1/2, 1/2]^3 as six quads; vertex bits 0, 1, 2 are the signs of x, y, z. Outward orientation.
inline PolygonSoup cube() {
  PolygonSoup soup;
  for (int v = 0; v < 8; ++v) soup.positions.emplace_back((v & 1) - 0.5, ((v >> 1) & 1) - 0.5, ((v >> 2) & 1) - 0.5);
  add_polygon(soup, {0, 2, 3, 1});
  add_polygon(soup, {4, 5, 7, 6});
  add_polygon(soup, {0, 1, 5, 4});
  add_polygon(soup, {2, 6, 7, 3});
  add_polygon(soup, {0, 4, 6, 2});
  add_polygon(soup, {1, 3, 7, 5});
  return soup;
}

/// |x| + |y| + |z| = 1, outward orientation.
inline PolygonSoup octahedron() {
  PolygonSoup soup;
  for (int axis = 0; axis < 3; ++axis) {
    soup.positions.push_back(Eigen::Vector3d::Unit(axis));
    soup.positions.push_back(-Eigen::Vector3d::Unit(axis));
  }
  for (int octant = 0; octant < 8; ++octant) {
    const int x = octant & 1, y = 2 + ((octant >> 1) & 1), z = 4 + ((octant >> 2) & 1);
    const bool outward = (octant & 1) + ((octant >> 1) & 1) + ((octant >> 2) & 1) == 0 || x + y + z == 8;
    if (outward) {
      add_polygon(soup, {x, y, z});
    } else {
      add_polygon(soup, {x, z, y});
    }
  }
  return soup;
}

/// The triangles of a mesh as a soup, to build variants of it.
inline PolygonSoup soup_of(const TriangleMesh& mesh) {
  PolygonSoup soup;
  soup.positions = mesh.positions();
  for (const auto& [a, b, c] : mesh.faces()) add_polygon(soup, {a, b, c});
  return soup;
}

/// The unit sphere: an octahedron, subdivided `levels` times and projected.
inline PolygonSoup sphere(int levels) {
  PolygonSoup soup = soup_of(TriangleMesh(octahedron(), {false, levels}));
  for (Eigen::Vector3d& p : soup.positions) p.normalize();
  return soup;
}

/// The image of an m x n grid of quads over [0, 1]^2 under `position`, each cut along a diagonal.
template <class Position>
PolygonSoup sheet(int m, int n, Position position) {
  PolygonSoup soup;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j)
      soup.positions.emplace_back(position(static_cast<double>(i) / m, static_cast<double>(j) / n));
  const auto vertex = [&](int i, int j) { return i * (n + 1) + j; };
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      add_polygon(soup, {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      add_polygon(soup, {vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return soup;
}

enum class Closing { kOpen, kRound, kTwisted };

/// A grid of m x n quads whose columns close as u says (kTwisted: v reversed) and whose rows close or not. Positions
/// are those of a torus, of a band around it with half twists; a Klein bottle crosses itself, which adjacency must not
/// mind.
inline PolygonSoup grid(int m, int n, Closing u, bool v_closes) {
  PolygonSoup soup;
  const int columns = u == Closing::kOpen ? m + 1 : m;
  const int rows = v_closes ? n : n + 1;
  const double pi = std::numbers::pi;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double around = 2 * pi * i / (u == Closing::kOpen ? 2.0 * m : m);
      const double twist = u == Closing::kTwisted ? around / 2 : 0;
      const double s = v_closes ? 0 : 2.0 * j / n - 1;
      const Eigen::Vector2d section = v_closes ? Eigen::Vector2d(std::cos(2 * pi * j / n), std::sin(2 * pi * j / n))
                                               : Eigen::Vector2d(s * std::cos(twist), s * std::sin(twist));
      soup.positions.emplace_back((3 + section.x()) * std::cos(around), (3 + section.x()) * std::sin(around),
                                  section.y());
    }
  }
  const auto vertex = [&](int i, int j) {
    if (v_closes) j %= n;
    if (i == columns && u == Closing::kTwisted) j = v_closes ? (n - j) % n : n - j;
    return (i % columns) * rows + j;
  };
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < n; ++j)
      add_polygon(soup, {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
  }
  return soup;
}

inline double area_of(const TriangleMesh& mesh, std::int32_t f) {
  const auto& [a, b, c] = mesh.face(f);
  return 0.5 * (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a)).norm();
}

inline double area_of(const TriangleMesh& mesh) {
  double sum = 0;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) sum += area_of(mesh, f);
  return sum;
}

}  // namespace leastcost::test
