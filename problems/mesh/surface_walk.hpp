// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include <leastcost/problems/mesh/surface_path.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// A surface point together with what it lies on: a vertex, the inside of an edge, or the inside of a face.
struct Place {
  SurfacePoint where;  ///< coordinates below 1e-12 set to zero
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::int32_t vertex = -1;  ///< or -1
  std::int32_t edge = -1;    ///< halfedge of where.face, or -1
};
Place place_of(const TriangleMesh& mesh, const SurfacePoint& p);

/// All faces that a place lies on.
void faces_at(const TriangleMesh& mesh, const Place& place, std::vector<std::int32_t>& faces);
/// A face that both lie on, or -1.
std::int32_t common_face_of(const TriangleMesh& mesh, const Place& a, const Place& b);

/// Appends a point and the face that the piece before it lies in; a repeated point is dropped.
void append_point(SurfacePath& path, const Eigen::Vector3d& p, std::int32_t face);

/// Walks from a towards the projection of b on the plane of each face (VFCS Fig. 5, case 2). False, with what was
/// appended to be discarded: b's projection lies inside a face that b is not on, or the walk met a border.
bool walk_towards(const TriangleMesh& mesh, const Place& a, const Place& b, SurfacePath& path);

/// Follows the section of the surface with the plane through a and b that contains the mean normal (VFCS 4.4.3, last
/// equation), whichever way round is shorter; false when the section from a does not reach b within `longest` (length).
bool follow_section(const TriangleMesh& mesh, const Place& a, const Place& b, double longest, SurfacePath& path);

}  // namespace leastcost
