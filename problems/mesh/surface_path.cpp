// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/surface_path.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

constexpr double kVertexTolerance = 1e-12;  // barycentric
constexpr double kOnFace = 1e-12;           // mesh diameters

bool has_corner(const TriangleMesh& mesh, std::int32_t f, std::int32_t v) {
  const std::array<std::int32_t, 3>& c = mesh.face(f);
  return c[0] == v || c[1] == v || c[2] == v;
}

[[noreturn]] void no_common_face(const TriangleMesh& mesh, const std::string& a, std::int32_t b) {
  throw InputError("path along edges: " + a + " and vertex " + std::to_string(mesh.file_vertex(b)) +
                   " share no face; an edge must join consecutive vertices");
}

std::int32_t face_with(const TriangleMesh& mesh, std::int32_t a, std::int32_t b) {
  for (const std::int32_t f : mesh.faces_of_vertex(a))
    if (has_corner(mesh, f, b)) return f;
  no_common_face(mesh, "vertex " + std::to_string(mesh.file_vertex(a)), b);
}

/// Face for the piece between an end of the path and vertex v.
std::int32_t face_at_end(const TriangleMesh& mesh, const SurfacePoint& end, std::int32_t v) {
  const std::int32_t at = vertex_at(mesh, end);
  if (at >= 0) return at == v ? end.face : face_with(mesh, at, v);
  if (!has_corner(mesh, end.face, v))
    no_common_face(mesh, "a point of face " + std::to_string(mesh.file_face(end.face)), v);
  return end.face;
}

/// The face that both ends lie on; ends at vertices may name any of their faces.
std::int32_t common_face(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  const std::int32_t va = vertex_at(mesh, a), vb = vertex_at(mesh, b);
  if (vb >= 0) return face_at_end(mesh, a, vb);
  if (va >= 0) return face_at_end(mesh, b, va);
  if (a.face != b.face) throw InputError("path along edges: no vertex between two ends on different faces");
  return a.face;
}

Eigen::Vector3d end_position(const TriangleMesh& mesh, const SurfacePoint& p) {
  const std::int32_t v = vertex_at(mesh, p);
  return v >= 0 ? mesh.position(v) : mesh.point(p);
}

/// Distance of p from the closed triangle f.
double distance_to_face(const TriangleMesh& mesh, std::int32_t f, const Eigen::Vector3d& p) {
  const SurfacePoint q = point_on_face(mesh, f, p);
  return (mesh.point(q) - p).norm();
}

/// Parameter of the point of segment [a, b] nearest to p, in [0, 1].
double nearest_on_segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p) {
  const Eigen::Vector3d e = b - a;
  const double squared = e.squaredNorm();
  return squared > 0 ? std::clamp((p - a).dot(e) / squared, 0.0, 1.0) : 0.0;
}

/// The nearest point of the three sides: also right where the face has no area.
Eigen::Vector3d nearest_on_sides(const std::array<Eigen::Vector3d, 3>& x, const Eigen::Vector3d& p) {
  double best = std::numeric_limits<double>::infinity();
  Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3;
    const double t = nearest_on_segment(x[k], x[l], p);
    const double distance = (x[k] + t * (x[l] - x[k]) - p).squaredNorm();
    if (distance >= best) continue;
    best = distance;
    barycentric.setZero();
    barycentric[k] = 1 - t;
    barycentric[l] = t;
  }
  return barycentric;
}

double metric_norm(const Eigen::Vector3d& d, const MetricRoot& metric) {
  return metric ? (*metric * d).norm() : d.norm();
}

}  // namespace

SurfacePoint vertex_point(const TriangleMesh& mesh, std::int32_t v) {
  SurfacePoint p;
  p.face = mesh.faces_of_vertex(v).front();
  for (int k = 0; k < 3; ++k) p.barycentric[k] = mesh.face(p.face)[static_cast<std::size_t>(k)] == v ? 1.0 : 0.0;
  return p;
}

std::int32_t vertex_at(const TriangleMesh& mesh, const SurfacePoint& p) {
  int corner = 0;
  if (p.barycentric.maxCoeff(&corner) < 1 - kVertexTolerance) return -1;
  return mesh.face(p.face)[static_cast<std::size_t>(corner)];
}

SurfacePoint point_on_face(const TriangleMesh& mesh, std::int32_t f, const Eigen::Vector3d& p) {
  if (f < 0 || f >= mesh.face_count())
    throw InputError("a point of the path lies on face " + std::to_string(f) + ", but the mesh has " +
                     std::to_string(mesh.face_count()) + ": project it (project_end) first");
  std::array<Eigen::Vector3d, 3> x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = mesh.position(mesh.face(f)[k]);
  const Eigen::Vector3d normal = (x[1] - x[0]).cross(x[2] - x[0]);
  const double area = normal.squaredNorm();
  SurfacePoint q{f, Eigen::Vector3d::Zero()};
  if (area > 0) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d& b = x[(k + 1) % 3];
      const Eigen::Vector3d& c = x[(k + 2) % 3];
      q.barycentric[k] = (b - p).cross(c - p).dot(normal) / area;
    }
    q.barycentric /= q.barycentric.sum();
    if (q.barycentric.minCoeff() >= 0) return q;
  }
  q.barycentric = nearest_on_sides(x, p);
  return q;
}

SurfacePath path_from_vertices(const TriangleMesh& mesh, const SurfacePoint& source,
                               std::span<const std::int32_t> vertices, const SurfacePoint& target) {
  SurfacePath path;
  path.points.push_back(end_position(mesh, source));
  const auto add = [&path](const Eigen::Vector3d& p, std::int32_t face) {
    path.points.push_back(p);
    path.faces.push_back(face);
  };
  const std::int32_t from = vertex_at(mesh, source), to = vertex_at(mesh, target);
  if (vertices.empty()) {
    if (from < 0 || from != to) add(end_position(mesh, target), common_face(mesh, source, target));
    return path;
  }
  if (vertices.front() != from) add(mesh.position(vertices.front()), face_at_end(mesh, source, vertices.front()));
  for (std::size_t i = 1; i < vertices.size(); ++i)
    if (vertices[i] != vertices[i - 1]) add(mesh.position(vertices[i]), face_with(mesh, vertices[i - 1], vertices[i]));
  if (vertices.back() != to) add(end_position(mesh, target), face_at_end(mesh, target, vertices.back()));
  return path;
}

double path_length(const SurfacePath& path, const MetricRoot& metric) {
  double sum = 0;
  for (std::size_t i = 0; i < path.faces.size(); ++i) sum += metric_norm(path.points[i + 1] - path.points[i], metric);
  return sum;
}

std::vector<SurfacePoint> resample(const TriangleMesh& mesh, const SurfacePath& path, int count,
                                   const MetricRoot& metric) {
  if (path.faces.empty() || count < 2) throw InputError("resampling needs a path with a segment and at least 2 points");
  const double total = path_length(path, metric);
  std::vector<SurfacePoint> samples;
  samples.reserve(static_cast<std::size_t>(count));
  samples.push_back(point_on_face(mesh, path.faces.front(), path.points.front()));
  std::size_t segment = 0;
  double before = 0, length = metric_norm(path.points[1] - path.points[0], metric);
  for (int i = 1; i + 1 < count; ++i) {
    const double goal = total * i / (count - 1);
    while (before + length < goal && segment + 1 < path.faces.size()) {
      before += length;
      ++segment;
      length = metric_norm(path.points[segment + 1] - path.points[segment], metric);
    }
    const double t = length > 0 ? std::clamp((goal - before) / length, 0.0, 1.0) : 0.0;
    const Eigen::Vector3d p = path.points[segment] + t * (path.points[segment + 1] - path.points[segment]);
    samples.push_back(point_on_face(mesh, path.faces[segment], p));
  }
  samples.push_back(point_on_face(mesh, path.faces.back(), path.points.back()));
  return samples;
}

SurfacePath reversed(const SurfacePath& path) {
  SurfacePath back = path;
  std::reverse(back.points.begin(), back.points.end());
  std::reverse(back.faces.begin(), back.faces.end());
  return back;
}

double distance_off_faces(const TriangleMesh& mesh, const SurfacePath& path) {
  if (path.points.size() != path.faces.size() + 1) return std::numeric_limits<double>::infinity();
  double worst = 0;
  for (std::size_t i = 0; i < path.faces.size(); ++i) {
    const std::int32_t f = path.faces[i];
    if (f < 0 || f >= mesh.face_count()) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, distance_to_face(mesh, f, path.points[i]));
    worst = std::max(worst, distance_to_face(mesh, f, path.points[i + 1]));
  }
  return worst / mesh.diameter();
}

bool lies_on(const TriangleMesh& mesh, const SurfacePath& path) { return distance_off_faces(mesh, path) <= kOnFace; }

}  // namespace leastcost
