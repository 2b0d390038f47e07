// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/triangle_mesh.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

[[noreturn]] void fail(const std::string& source, const std::string& message) {
  throw InputError((source.empty() ? std::string("mesh") : source) + ": " + message);
}

/// Slack for barycentric coordinates given by hand, dimensionless.
constexpr double kBarycentricSlack = 1e-6;

}  // namespace

Eigen::Vector3d TriangleMesh::point(const SurfacePoint& p) const {
  const std::array<std::int32_t, 3>& corners = face(p.face);
  return p.barycentric[0] * position(corners[0]) + p.barycentric[1] * position(corners[1]) +
         p.barycentric[2] * position(corners[2]);
}

std::span<const std::int32_t> TriangleMesh::faces_of_vertex(std::int32_t v) const {
  const std::size_t i = static_cast<std::size_t>(v);
  const std::size_t first = static_cast<std::size_t>(vertex_face_begin_[i]);
  return {vertex_faces_.data() + first, static_cast<std::size_t>(vertex_face_begin_[i + 1]) - first};
}

std::span<const std::int32_t> TriangleMesh::neighbours(std::int32_t v) const {
  const std::size_t i = static_cast<std::size_t>(v);
  const std::size_t first = static_cast<std::size_t>(neighbour_begin_[i]);
  return {neighbours_.data() + first, static_cast<std::size_t>(neighbour_begin_[i + 1]) - first};
}

Eigen::Vector3d TriangleMesh::face_normal(std::int32_t f) const {
  const std::array<std::int32_t, 3>& corners = face(f);
  const Eigen::Vector3d a = position(corners[1]) - position(corners[0]);
  const Eigen::Vector3d b = position(corners[2]) - position(corners[0]);
  const Eigen::Vector3d area = a.cross(b);
  const double norm = area.norm();
  // Below this the cross product is rounding of the differences: no direction in it.
  const double noise = 4 * std::numeric_limits<double>::epsilon() * a.norm() * b.norm();
  return norm > noise ? Eigen::Vector3d(area / norm) : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

Eigen::Vector3d TriangleMesh::smooth_normal(const SurfacePoint& p) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::int32_t k = 0; k < 3; ++k) {
    const std::int32_t code = corner_fan_[static_cast<std::size_t>(3 * p.face + k)];
    const double side = code % 2 == 0 ? 1.0 : -1.0;
    sum += side * p.barycentric[k] * fan_normals_[static_cast<std::size_t>(code / 2)];
  }
  const double norm = sum.norm();
  return norm > 0 ? Eigen::Vector3d(sum / norm) : face_normal(p.face);
}

std::int32_t TriangleMesh::vertex_of_file(std::int32_t v) const {
  if (v < 0 || v >= file_vertex_count()) {
    fail(source_, "vertex " + std::to_string(v) + " does not exist; the file has vertices 0 to " +
                      std::to_string(file_vertex_count() - 1));
  }
  return vertex_of_file_[static_cast<std::size_t>(v)];
}

SurfacePoint TriangleMesh::locate(std::int32_t file_face, const Eigen::Vector3d& barycentric) const {
  if (file_face >= 0 && file_face < file_face_count()) {
    const std::size_t p = static_cast<std::size_t>(file_face);
    const std::int32_t count = base_begin_[p + 1] - base_begin_[p];
    if (count > 1) {
      fail(source_, "face " + std::to_string(file_face) + " is a polygon that was cut into " + std::to_string(count) +
                        " triangles, so barycentric coordinates are ambiguous; give a vertex or a position");
    }
  }
  return locate(FilePoint{file_face, 0, {-1, -1, -1}, barycentric});
}

SurfacePoint TriangleMesh::locate(const FilePoint& p) const {
  const std::string name = "face " + std::to_string(p.face);
  if (p.face < 0 || p.face >= file_face_count()) {
    fail(source_, name + " does not exist; the file has faces 0 to " + std::to_string(file_face_count() - 1));
  }
  const std::int32_t first = base_begin_[static_cast<std::size_t>(p.face)];
  const std::int32_t count = base_begin_[static_cast<std::size_t>(p.face) + 1] - first;
  if (count == 0) fail(source_, name + " is degenerate (fewer than three different corners) and was left out");
  if (p.fan < 0 || p.fan >= count) {
    fail(source_, name + " has " + std::to_string(count) + " triangles; there is no number " + std::to_string(p.fan));
  }
  const Eigen::Vector3d& b = p.barycentric;
  if (!b.allFinite() || b.minCoeff() < -kBarycentricSlack || std::abs(b.sum() - 1) > kBarycentricSlack) {
    fail(source_, "barycentric coordinates " + point_text(b, 9) + " on " + name +
                      " must not be negative and must have sum 1; their sum is " + told_apart(b.sum(), 1).first);
  }
  return locate_in_base(first + p.fan, b);
}

SurfacePoint TriangleMesh::locate_in_base(std::int32_t base, Eigen::Vector3d barycentric) const {
  barycentric = barycentric.cwiseMax(0.0).eval();
  const double sum = barycentric.sum();
  // Dividing by a sum that is 1 to rounding would only add rounding to exact coordinates.
  if (std::abs(sum - 1) > 4 * std::numeric_limits<double>::epsilon()) barycentric /= sum;
  SurfacePoint result{base, barycentric};
  for (int level = 0; level < subdivisions_; ++level) {
    Eigen::Vector3d& b = result.barycentric;
    Eigen::Index corner = 0;
    if (b.maxCoeff(&corner) >= 0.5) {
      b *= 2;
      b[corner] -= 1;
      result.face = 4 * result.face + static_cast<std::int32_t>(corner);
    } else {
      b = (1 - 2 * b.array()).matrix().eval();
      result.face = 4 * result.face + 3;
    }
  }
  return result;
}

TriangleMesh::FilePoint TriangleMesh::in_file(const SurfacePoint& p) const {
  Eigen::Vector3d b = p.barycentric;
  for (int level = 0; level < subdivisions_; ++level) {
    const std::int32_t child = (p.face >> (2 * level)) % 4;
    if (child < 3) {
      b *= 0.5;
      b[child] += 0.5;
    } else {
      b = (0.5 * (1 - b.array())).matrix().eval();
    }
  }
  const std::int32_t base = base_of(p.face);
  const std::int32_t polygon = base_file_face_[static_cast<std::size_t>(base)];
  return {polygon, base - base_begin_[static_cast<std::size_t>(polygon)],
          base_file_vertices_[static_cast<std::size_t>(base)], b};
}

}  // namespace leastcost
