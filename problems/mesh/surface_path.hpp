// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// A polyline that lies on a triangle mesh: segment i runs from points[i] to points[i + 1] inside faces[i], so
/// consecutive points share a face, and interior points lie on edges or vertices unless they were asked for.
struct SurfacePath {
  std::vector<Eigen::Vector3d> points;  ///< m + 1 positions
  std::vector<std::int32_t> faces;      ///< m faces
};

/// A with M = A' A, for lengths sqrt(d' M d) = |A d| in a constant metric tensor M; none: Euclidean.
using MetricRoot = std::optional<Eigen::Matrix3d>;

/// Vertex v as a point of one of its faces.
SurfacePoint vertex_point(const TriangleMesh& mesh, std::int32_t v);
/// The vertex that p is (barycentric coordinate 1 within 1e-12), or -1.
std::int32_t vertex_at(const TriangleMesh& mesh, const SurfacePoint& p);
/// Barycentric coordinates of the point of face f nearest to p (p on the face: its own), also on needles.
SurfacePoint point_on_face(const TriangleMesh& mesh, std::int32_t f, const Eigen::Vector3d& p);

/// source -> vertices -> target along edges; an end off the vertices shares a face with its neighbour in the list. The
/// list may be empty (ends on one face) and may repeat an end that is a vertex. Throws InputError where two neighbours
/// share no face.
SurfacePath path_from_vertices(const TriangleMesh& mesh, const SurfacePoint& source,
                               std::span<const std::int32_t> vertices, const SurfacePoint& target);

/// Length units of the metric.
double path_length(const SurfacePath& path, const MetricRoot& metric = {});

/// `count` >= 2 points equally spaced by length, the path's own ends first and last.
std::vector<SurfacePoint> resample(const TriangleMesh& mesh, const SurfacePath& path, int count,
                                   const MetricRoot& metric = {});

/// The same path backwards.
SurfacePath reversed(const SurfacePath& path);

/// Largest distance, in mesh diameters, of a segment's end from the segment's face. Valid paths: <= 1e-12.
/// +infinity for a path whose counts do not fit or whose face numbers do not exist.
double distance_off_faces(const TriangleMesh& mesh, const SurfacePath& path);
/// Every segment lies in its face, hence consecutive faces share the point between them: distance_off_faces <= 1e-12.
bool lies_on(const TriangleMesh& mesh, const SurfacePath& path);

}  // namespace leastcost
