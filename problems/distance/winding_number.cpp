// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/distance/winding_number.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr std::int32_t kLeaf = 8;  ///< most triangles of a leaf
constexpr double kFar =
    3;  ///< radii of a group from where on it is a dipole: the next term is a few percent of a group's share
constexpr std::size_t kMostOpen = 64;

}  // namespace

WindingNumber::WindingNumber(const TriangleMesh& mesh, const std::vector<char>& turned) {
  triangles_.reserve(static_cast<std::size_t>(mesh.face_count()));
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.face(f);
    Triangle t{{mesh.position(a), mesh.position(b), mesh.position(c)}};
    if (!turned.empty() && turned[static_cast<std::size_t>(f)] != 0) std::swap(t.corner[1], t.corner[2]);
    triangles_.push_back(t);
  }
  build(0, mesh.face_count());
}

std::int32_t WindingNumber::build(std::int32_t first, std::int32_t count) {
  const auto index = static_cast<std::int32_t>(nodes_.size());
  nodes_.emplace_back();
  Node node;
  node.first = first;
  node.count = count;
  const auto begin = triangles_.begin() + first, end = begin + count;
  Vector3d low = begin->corner[0], high = low;
  double weight = 0;
  for (auto t = begin; t != end; ++t) {
    const Vector3d area = (t->corner[1] - t->corner[0]).cross(t->corner[2] - t->corner[0]) / 2;
    const double size = area.norm();
    node.dipole += area;
    node.centre += size * (t->corner[0] + t->corner[1] + t->corner[2]) / 3;
    weight += size;
    for (const Vector3d& p : t->corner) low = low.cwiseMin(p).eval(), high = high.cwiseMax(p).eval();
  }
  node.centre = weight > 0 ? Vector3d(node.centre / weight) : Vector3d((low + high) / 2);
  for (auto t = begin; t != end; ++t)
    for (const Vector3d& p : t->corner) node.radius = std::max(node.radius, (p - node.centre).norm());
  if (count > kLeaf) {
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const std::int32_t half = count / 2;  // the depth is log2 of the number of faces
    std::nth_element(begin, begin + half, end, [axis](const Triangle& s, const Triangle& t) {
      return s.corner[0][axis] + s.corner[1][axis] + s.corner[2][axis] <
             t.corner[0][axis] + t.corner[1][axis] + t.corner[2][axis];
    });
    build(first, half);
    node.second = build(first + half, count - half);
  }
  nodes_[static_cast<std::size_t>(index)] = node;
  return index;
}

double WindingNumber::at(const Vector3d& x) const {
  double angle = 0;
  std::array<std::int32_t, kMostOpen> open{};
  std::size_t size = 1;
  while (size > 0) {
    const std::int32_t at = open[--size];
    const Node& node = nodes_[static_cast<std::size_t>(at)];
    const Vector3d way = node.centre - x;
    const double distance = way.norm();
    if (distance > kFar * node.radius) {
      angle += node.dipole.dot(way) / (distance * distance * distance);
    } else if (node.second >= 0) {
      open[size++] = node.second;
      open[size++] = at + 1;
    } else {
      for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
        const Triangle& t = triangles_[static_cast<std::size_t>(i)];
        const Vector3d a = t.corner[0] - x, b = t.corner[1] - x, c = t.corner[2] - x;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
      }
    }
  }
  return angle / (4 * std::numbers::pi);
}

}  // namespace leastcost
