// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/drawing/solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace leastcost {
namespace {

using Eigen::Vector3d;
using Points3 = std::vector<Vector3d>;

constexpr double kFlat = 1e-7;  ///< of the size: what is thinner has no inside

template <class Measure>
std::size_t farthest(const Points3& points, const Measure& measure) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (measure(points[i]) > measure(points[best])) best = i;
  return best;
}

struct Face {
  std::array<int, 3> corners;
  Vector3d normal;
  double offset = 0;
};

Face face_of(const Points3& points, int a, int b, int c) {
  const auto at = [&](int i) -> const Vector3d& { return points[static_cast<std::size_t>(i)]; };
  const Vector3d normal = (at(b) - at(a)).cross(at(c) - at(a)).normalized();
  return {{a, b, c}, normal, normal.dot(at(a))};
}

/// Takes the faces that see a point out, and joins what borders on them to it.
void take_in(const Points3& points, int point, double slack, std::vector<Face>& faces) {
  const Vector3d& x = points[static_cast<std::size_t>(point)];
  std::set<std::pair<int, int>> edges;  // of the faces that go, in their direction
  std::vector<Face> kept;
  for (const Face& face : faces) {
    if (face.normal.dot(x) <= face.offset + slack) {
      kept.push_back(face);
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) edges.emplace(face.corners[k], face.corners[(k + 1) % 3]);
  }
  for (const auto& [a, b] : edges)
    if (edges.count({b, a}) == 0) kept.push_back(face_of(points, a, b, point));
  faces = std::move(kept);
}

}  // namespace

void append(TriangleSoup& out, const TriangleSoup& more) {
  const auto first = static_cast<int>(out.vertices.size());
  out.vertices.insert(out.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const auto& [a, b, c] : more.triangles) out.triangles.push_back({first + a, first + b, first + c});
}

TriangleSoup capsule_surface(const Vector3d& from, const Vector3d& to, double radius, int around) {
  const int rings = std::max(2, around / 4);  // of each half ball, without its pole
  const Vector3d along = to - from, axis = along.norm() > 0 ? Vector3d(along.normalized()) : Vector3d::UnitZ();
  const Vector3d e1 = axis.unitOrthogonal(), e2 = axis.cross(e1);
  TriangleSoup out;
  const auto ring = [&](const Vector3d& center, double height) {
    const double wide = std::sqrt(std::max(0.0, 1 - height * height));
    for (int k = 0; k < around; ++k) {
      const double at = 2 * std::numbers::pi * k / around;
      out.vertices.emplace_back(center + radius * (height * axis + wide * (std::cos(at) * e1 + std::sin(at) * e2)));
    }
  };
  out.vertices.emplace_back(from - radius * axis);
  for (int i = rings - 1; i >= 0; --i) ring(from, -std::sin(std::numbers::pi / 2 * i / rings));
  for (int i = 0; i < rings; ++i) ring(to, std::sin(std::numbers::pi / 2 * i / rings));
  out.vertices.emplace_back(to + radius * axis);
  const int last = static_cast<int>(out.vertices.size()) - 1;
  const auto at = [&](int i, int k) { return 1 + i * around + k % around; };
  for (int k = 0; k < around; ++k) {
    out.triangles.push_back({0, at(0, k + 1), at(0, k)});
    out.triangles.push_back({last, at(2 * rings - 1, k), at(2 * rings - 1, k + 1)});
    for (int i = 0; i + 1 < 2 * rings; ++i) {
      out.triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
      out.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
    }
  }
  return out;
}

TriangleSoup hull_surface(Points3 points) {
  if (points.size() < 3) return {};
  const std::size_t a = farthest(points, [](const Vector3d& x) { return -x[0]; });
  const std::size_t b = farthest(points, [&](const Vector3d& x) { return (x - points[a]).norm(); });
  const Vector3d line = points[b] - points[a];
  const double size = line.norm();
  const std::size_t c = farthest(points, [&](const Vector3d& x) { return line.cross(x - points[a]).norm(); });
  const Vector3d across = line.cross(points[c] - points[a]);
  if (!(across.norm() > kFlat * size * size)) return {};
  const Vector3d normal = across.normalized();
  const auto height = [&](const Vector3d& x) { return normal.dot(x - points[a]); };
  const std::size_t d = farthest(points, [&](const Vector3d& x) { return std::abs(height(x)); });
  if (!(std::abs(height(points[d])) > kFlat * size)) {
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) points.emplace_back(points[i] + 10 * kFlat * size * normal);
    return hull_surface(std::move(points));
  }
  std::array<int, 4> first = {static_cast<int>(a), static_cast<int>(b), static_cast<int>(c), static_cast<int>(d)};
  if (height(points[d]) > 0) std::swap(first[1], first[2]);
  const auto [i, j, k, l] = first;
  std::vector<Face> faces = {face_of(points, i, j, k), face_of(points, i, l, j), face_of(points, j, l, k),
                             face_of(points, k, l, i)};
  constexpr double kSlack = 1e-10;
  for (std::size_t p = 0; p < points.size(); ++p) take_in(points, static_cast<int>(p), kSlack * size, faces);
  TriangleSoup out;
  out.vertices = std::move(points);
  for (const Face& face : faces) out.triangles.push_back(face.corners);
  return out;
}

TriangleSoup plane_in_box(const Vector3d& normal, double offset, const Eigen::AlignedBox3d& box) {
  const Vector3d n = normal.normalized(), e1 = n.unitOrthogonal(), e2 = n.cross(e1);
  const Vector3d foot = box.center() - (normal.dot(box.center()) - offset) / normal.norm() * n;
  const double far = 2 * box.diagonal().norm();
  Points3 corners = {foot + far * (e1 + e2), foot + far * (e2 - e1), foot - far * (e1 + e2), foot + far * (e1 - e2)};
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (const double side : {-1.0, 1.0}) {  // Sutherland, Hodgman 1974
      const auto outside = [&](const Vector3d& x) { return side > 0 ? x[i] - box.max()[i] : box.min()[i] - x[i]; };
      Points3 kept;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vector3d &p = corners[k], &q = corners[(k + 1) % corners.size()];
        if (outside(p) <= 0) kept.push_back(p);
        if ((outside(p) <= 0) != (outside(q) <= 0))
          kept.emplace_back(p + outside(p) / (outside(p) - outside(q)) * (q - p));
      }
      corners = std::move(kept);
    }
  }
  TriangleSoup out;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    out.triangles.push_back({0, static_cast<int>(k), static_cast<int>(k) + 1});
  out.vertices = std::move(corners);
  return out;
}

}  // namespace leastcost
