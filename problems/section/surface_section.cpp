// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "problems/mesh/surface_walk.hpp"
#include "problems/section/plane_section.hpp"

namespace leastcost {
namespace {

/// Normal of the plane through a and b that contains the mean of the normals there; zero when there is no such plane.
Eigen::Vector3d section_normal(const TriangleMesh& mesh, const Place& a, const Place& b) {
  const Eigen::Vector3d chord = b.position - a.position;
  const Eigen::Vector3d na = mesh.smooth_normal(a.where), nb = mesh.smooth_normal(b.where);
  const Eigen::Vector3d mean = na.dot(nb) < 0 ? Eigen::Vector3d(na - nb) : Eigen::Vector3d(na + nb);
  const Eigen::Vector3d normal = mean.cross(chord);
  return normal.norm() > 1e-9 * chord.norm() ? Eigen::Vector3d(normal.normalized()) : Eigen::Vector3d::Zero();
}

/// Follows the section out of a through halfedge h until a face of b. False: border, or longer than `longest`.
bool follow(const TriangleMesh& mesh, const PlaneSection& section, const Place& a, std::int32_t h, const Place& b,
            std::span<const std::int32_t> goal_faces, double longest, SurfacePath& path, double& length) {
  path.points.assign(1, a.position);
  path.faces.clear();
  length = 0;
  for (std::int32_t steps = 0; steps < mesh.face_count(); ++steps) {
    const Eigen::Vector3d p = section.crossing(h), previous = path.points.back();
    length += (p - previous).norm();
    append_point(path, p, h / 3);
    const std::int32_t entry = mesh.across(h);
    if (entry < 0 || length > longest) return false;
    if (std::find(goal_faces.begin(), goal_faces.end(), entry / 3) != goal_faces.end()) {
      length += (b.position - p).norm();
      append_point(path, b.position, entry / 3);
      return length <= longest;
    }
    h = section.exit(entry);
  }
  return false;
}

}  // namespace

bool follow_section(const TriangleMesh& mesh, const Place& a, const Place& b, double longest, SurfacePath& path) {
  const Eigen::Vector3d normal = section_normal(mesh, a, b);
  if (normal.isZero(0)) return false;
  const PlaneSection section(mesh, a.position, normal);
  std::vector<std::int32_t> start_faces, goal_faces;
  faces_at(mesh, a, start_faces);
  faces_at(mesh, b, goal_faces);
  SurfacePath best, candidate;
  for (const std::int32_t f : start_faces) {
    for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
      const bool on_a = a.vertex >= 0 ? mesh.tail(h) == a.vertex || mesh.head(h) == a.vertex
                                      : a.edge >= 0 && (h == a.edge || h == mesh.across(a.edge));
      double length = 0;
      if (on_a || !section.crosses(h)) continue;
      if (!follow(mesh, section, a, h, b, goal_faces, longest, candidate, length)) continue;
      longest = length;
      std::swap(best, candidate);
    }
  }
  for (std::size_t i = 0; i < best.faces.size(); ++i) append_point(path, best.points[i + 1], best.faces[i]);
  return !best.faces.empty();
}

}  // namespace leastcost
