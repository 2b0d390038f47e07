// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/distance/winding_number.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr std::ptrdiff_t kLeaf = 8;  ///< most triangles of a leaf
/// Radii of a group from where on it is a dipole: the next term is a few percent of a group's share.
constexpr double kFar = 3;

}  // namespace

WindingNumber::WindingNumber(const TriangleMesh& mesh, const std::vector<char>& turned)
    : tree_(turned_triangles(mesh, turned), kLeaf, std::identity{}, dipole) {}

std::vector<WindingNumber::Triangle> WindingNumber::turned_triangles(const TriangleMesh& mesh,
                                                                     const std::vector<char>& turned) {
  std::vector<Triangle> triangles;
  triangles.reserve(static_cast<std::size_t>(mesh.face_count()));
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.face(f);
    triangles.push_back({mesh.position(a), mesh.position(b), mesh.position(c)});
    if (!turned.empty() && turned[static_cast<std::size_t>(f)] != 0)
      std::swap(triangles.back()[1], triangles.back()[2]);
  }
  return triangles;
}

WindingNumber::Dipole WindingNumber::dipole(std::span<const Triangle> triangles) {
  Dipole all;
  Vector3d low = triangles[0][0], high = low;
  double weight = 0;
  for (const Triangle& t : triangles) {
    const Vector3d area = (t[1] - t[0]).cross(t[2] - t[0]) / 2;
    const double size = area.norm();
    all.area += area;
    all.centre += size * (t[0] + t[1] + t[2]) / 3;
    weight += size;
    for (const Vector3d& p : t) low = low.cwiseMin(p).eval(), high = high.cwiseMax(p).eval();
  }
  all.centre = weight > 0 ? Vector3d(all.centre / weight) : Vector3d((low + high) / 2);
  for (const Triangle& t : triangles)
    for (const Vector3d& p : t) all.radius = std::max(all.radius, (p - all.centre).norm());
  return all;
}

double WindingNumber::at(const Vector3d& x) const {
  double angle = 0;
  const auto near = [&](const Dipole& group) {
    const Vector3d way = group.centre - x;
    const double distance = way.norm();
    if (!(distance > kFar * group.radius)) return true;
    angle += group.area.dot(way) / (distance * distance * distance);
    return false;
  };
  tree_.visit(near, [&](std::int32_t first, std::int32_t last) {
    for (std::int32_t i = first; i < last; ++i) {
      const Triangle& t = tree_.items()[static_cast<std::size_t>(i)];
      const Vector3d a = t[0] - x, b = t[1] - x, c = t[2] - x;
      const double la = a.norm(), lb = b.norm(), lc = c.norm();
      angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
  });
  return angle / (4 * std::numbers::pi);
}

}  // namespace leastcost
