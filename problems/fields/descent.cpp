// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/fields/descent.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/mesh/edge_graph.hpp>
#include "problems/mesh/surface_walk.hpp"

namespace leastcost {
namespace {

/// Crossings nearer to a vertex than this part of their edge are that vertex.
constexpr double kSnap = 1e-9;

std::size_t slot(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Where a descent goes next: a straight piece inside `face` to `place`, at `slope` (fall of the field per length).
struct Fall {
  double slope = 0;
  std::int32_t face = -1;
  SurfacePoint place;
};

class Tracer {
 public:
  Tracer(const TriangleMesh& mesh, std::span<const double> values) : mesh_(&mesh), values_(values) {}

  double value(const Place& p) const {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double weight = p.where.barycentric[static_cast<Eigen::Index>(k)];
      if (weight > 0) sum += weight * values_[slot(mesh_->face(p.where.face)[k])];
    }
    return sum;
  }

  /// The steepest way down from a place; slope 0: it is a minimum.
  Fall steepest(const Place& from, std::span<const std::int32_t> faces) const {
    Fall best;
    for (const std::int32_t f : faces) {
      along_sides(from, f, best);
      into_face(from, f, best);
    }
    return best;
  }

 private:
  /// To the corners of the face that share an edge with the place.
  void along_sides(const Place& from, std::int32_t f, Fall& best) const {
    const SurfacePoint here = point_on_face(*mesh_, f, from.position);
    for (int k = 0; k < 3; ++k) {
      const std::int32_t v = mesh_->face(f)[slot(k)];
      const bool joined = from.vertex >= 0 ? v != from.vertex : here.barycentric[k] > kSnap;
      if (!joined) continue;
      const double length = (mesh_->position(v) - from.position).norm();
      const double slope = (value(from) - values_[slot(v)]) / length;
      if (!(length > 0) || !(slope > best.slope)) continue;
      best = {slope, f, {f, Eigen::Vector3d::Unit(k)}};
    }
  }

  /// Straight down inside the face, where that leads into it.
  void into_face(const Place& from, std::int32_t f, Fall& best) const {
    const auto& v = mesh_->face(f);
    const Eigen::Vector3d e1 = mesh_->position(v[1]) - mesh_->position(v[0]);
    const Eigen::Vector3d e2 = mesh_->position(v[2]) - mesh_->position(v[0]);
    const Eigen::Vector3d normal = e1.cross(e2);
    const double area = normal.squaredNorm();
    if (!(area > 0)) return;
    const double u1 = values_[slot(v[1])] - values_[slot(v[0])], u2 = values_[slot(v[2])] - values_[slot(v[0])];
    const Eigen::Vector3d gradient = (u1 * e2.cross(normal) + u2 * normal.cross(e1)) / area;
    const double slope = gradient.norm();
    if (!(slope > best.slope) || !std::isfinite(slope)) return;
    // Barycentric coordinates along the descent.
    Eigen::Vector3d rate;
    rate[1] = -gradient.dot(e2.cross(normal)) / area;
    rate[2] = -gradient.dot(normal.cross(e1)) / area;
    rate[0] = -rate[1] - rate[2];
    SurfacePoint here = point_on_face(*mesh_, f, from.position);
    double reach = std::numeric_limits<double>::infinity();
    int side = -1;
    for (int k = 0; k < 3; ++k) {
      if (!(rate[k] < 0)) continue;
      if (here.barycentric[k] <= kSnap) return;  // straight out of the face
      const double t = here.barycentric[k] / -rate[k];
      if (t < reach) reach = t, side = k;
    }
    if (side < 0) return;
    here.barycentric += reach * rate;
    here.barycentric[side] = 0;
    for (int k = 0; k < 3; ++k)
      if (here.barycentric[k] < kSnap) here.barycentric[k] = 0;
    here.barycentric /= here.barycentric.sum();
    best = {slope, f, here};
  }

  const TriangleMesh* mesh_;
  std::span<const double> values_;
};

/// Appends the shortest path along edges from where the path has stopped.
bool finish_by_edges(const TriangleMesh& mesh, const Place& from, const SurfacePoint& source, SurfacePath& path) {
  EdgeGraphSearch search(mesh);
  const EdgePath rest = search.shortest(
      from.where, source, [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (b - a).norm(); });
  if (!rest.found()) return false;
  for (std::size_t i = 0; i < rest.path.faces.size(); ++i)
    append_point(path, rest.path.points[i + 1], rest.path.faces[i]);
  return true;
}

}  // namespace

Descent descend(const TriangleMesh& mesh, std::span<const double> values, const SurfacePoint& start,
                const SurfacePoint& source) {
  if (values.size() != slot(mesh.vertex_count()))
    throw InputError("descent: " + std::to_string(values.size()) + " values for " +
                     std::to_string(mesh.vertex_count()) + " vertices; give one per vertex");
  const Tracer tracer(mesh, values);
  const Place goal = place_of(mesh, source);
  Place here = place_of(mesh, start);
  Descent result;
  result.path.points.push_back(here.position);
  std::vector<std::int32_t> faces;
  const long most = 4L * mesh.face_count() + 16;  // of a descent that falls; rounding could go in circles
  double height = tracer.value(here);
  for (long i = 0;; ++i) {
    const std::int32_t shared = common_face_of(mesh, here, goal);
    if (shared >= 0) {
      append_point(result.path, goal.position, shared);
      return result;
    }
    faces_at(mesh, here, faces);
    const Fall fall = i < most ? tracer.steepest(here, faces) : Fall{};
    const Place next = fall.slope > 0 ? place_of(mesh, fall.place) : here;
    const double lower = tracer.value(next);
    if (!(fall.slope > 0) || !(lower < height)) {
      result.by_edges = true;
      if (!finish_by_edges(mesh, here, source, result.path)) result.path = {};
      return result;
    }
    append_point(result.path, next.position, fall.face);
    here = next;
    height = lower;
  }
}

}  // namespace leastcost
