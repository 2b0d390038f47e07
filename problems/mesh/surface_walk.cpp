// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/surface_walk.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace leastcost {
namespace {

constexpr double kZero = 1e-12;  // barycentric
constexpr int kIdleSteps = 64;   // steps without length, around vertices, before a walk gives up

std::int32_t corner_of(const TriangleMesh& mesh, std::int32_t face, std::int32_t v) {
  const std::array<std::int32_t, 3>& c = mesh.face(face);
  return c[0] == v ? 0 : c[1] == v ? 1 : c[2] == v ? 2 : -1;
}

/// Barycentric coordinates of the projection of p on the plane of a face; false where the face has no plane.
bool project(const TriangleMesh& mesh, std::int32_t face, const Eigen::Vector3d& p, Eigen::Vector3d& barycentric) {
  const std::array<std::int32_t, 3>& c = mesh.face(face);
  const Eigen::Vector3d& a = mesh.position(c[0]);
  const Eigen::Vector3d ab = mesh.position(c[1]) - a, ac = mesh.position(c[2]) - a, ap = p - a;
  const Eigen::Vector3d normal = ab.cross(ac);
  const double squared = normal.squaredNorm();
  if (!(squared > 0)) return false;
  barycentric[1] = ap.cross(ac).dot(normal) / squared;
  barycentric[2] = ab.cross(ap).dot(normal) / squared;
  barycentric[0] = 1 - barycentric[1] - barycentric[2];
  return true;
}

/// The same place as seen from another face that it lies on.
SurfacePoint seen_from(const TriangleMesh& mesh, const Place& place, std::int32_t face) {
  SurfacePoint p{face, Eigen::Vector3d::Zero()};
  for (int k = 0; k < 3; ++k) {
    const std::int32_t corner = corner_of(mesh, face, mesh.face(place.where.face)[static_cast<std::size_t>(k)]);
    if (corner >= 0) p.barycentric[corner] = place.where.barycentric[k];
  }
  return p;
}

/// A straight step inside one face.
struct Step {
  Place exit;
  double progress = 0;  // cosine between the step and the direction to the goal; below zero: none
};

/// How well a face serves to go from a place on it towards b: the step to the face's boundary, in the direction of b's
/// projection. No progress where that direction leaves the face at once or ends inside it.
Step step_through(const TriangleMesh& mesh, const Place& from, std::int32_t face, const Place& b) {
  Step step;
  step.progress = -1;
  Eigen::Vector3d goal;
  if (!project(mesh, face, b.position, goal)) return step;
  const SurfacePoint start = face == from.where.face ? from.where : seen_from(mesh, from, face);
  const Eigen::Vector3d delta = goal - start.barycentric;
  double reach = 1;
  int side = -1;
  for (int k = 0; k < 3; ++k) {
    if (delta[k] >= 0) continue;
    if (start.barycentric[k] <= 0 && delta[k] < -kZero) return step;  // straight out of the face
    const double t = start.barycentric[k] / -delta[k];
    if (t < reach) reach = t, side = k;
  }
  if (side < 0) return step;
  SurfacePoint exit{face, start.barycentric + reach * delta};
  exit.barycentric[side] = 0;
  step.exit = place_of(mesh, exit);
  const Eigen::Vector3d d = mesh.point({face, goal}) - from.position, to_goal = b.position - from.position;
  step.progress = d.norm() / std::max(to_goal.norm(), std::numeric_limits<double>::min());
  return step;
}

/// Around a vertex the goal's projection may lie outside of every face's corner; then along the edge nearest to it.
Step step_along_edge(const TriangleMesh& mesh, const Place& from, const Place& b) {
  Step step;
  if (from.vertex < 0) return step;
  const Eigen::Vector3d to_goal = (b.position - from.position).normalized();
  for (const std::int32_t w : mesh.neighbours(from.vertex)) {
    const Eigen::Vector3d edge = mesh.position(w) - from.position;
    const double progress = edge.norm() > 0 ? edge.dot(to_goal) / edge.norm() : 0.0;
    // The end of the edge must be nearer to the goal than its beginning.
    if (progress <= step.progress || edge.dot(2 * (b.position - from.position) - edge) <= 0) continue;
    for (const std::int32_t f : mesh.faces_of_vertex(w)) {
      if (corner_of(mesh, f, from.vertex) < 0) continue;
      SurfacePoint p{f, Eigen::Vector3d::Zero()};
      p.barycentric[corner_of(mesh, f, w)] = 1;
      step = {place_of(mesh, p), progress};
      break;
    }
  }
  return step;
}

}  // namespace

Place place_of(const TriangleMesh& mesh, const SurfacePoint& p) {
  Place place;
  place.where = p;
  int zeros = 0, zero = -1, one = -1;
  for (int k = 0; k < 3; ++k) {
    if (p.barycentric[k] <= kZero) {
      place.where.barycentric[k] = 0;
      ++zeros;
      zero = k;
    } else {
      one = k;
    }
  }
  place.where.barycentric /= place.where.barycentric.sum();
  if (zeros == 2) {
    place.vertex = mesh.face(p.face)[static_cast<std::size_t>(one)];
    place.where.barycentric[one] = 1;
    place.position = mesh.position(place.vertex);
    return place;
  }
  if (zeros == 1) place.edge = 3 * p.face + (zero + 1) % 3;
  place.position = mesh.point(place.where);
  return place;
}

void faces_at(const TriangleMesh& mesh, const Place& place, std::vector<std::int32_t>& faces) {
  faces.clear();
  if (place.vertex >= 0) {
    const std::span<const std::int32_t> around = mesh.faces_of_vertex(place.vertex);
    faces.assign(around.begin(), around.end());
  } else if (place.edge >= 0) {
    for (const std::int32_t f : mesh.faces_of_vertex(mesh.tail(place.edge)))
      if (corner_of(mesh, f, mesh.head(place.edge)) >= 0) faces.push_back(f);
  } else {
    faces.push_back(place.where.face);
  }
}

std::int32_t common_face_of(const TriangleMesh& mesh, const Place& a, const Place& b) {
  if (a.where.face == b.where.face) return a.where.face;
  if (a.vertex < 0 && a.edge < 0 && b.vertex < 0 && b.edge < 0) return -1;
  std::vector<std::int32_t> of_a, of_b;
  faces_at(mesh, a, of_a);
  faces_at(mesh, b, of_b);
  for (const std::int32_t f : of_a)
    if (std::find(of_b.begin(), of_b.end(), f) != of_b.end()) return f;
  return -1;
}

void append_point(SurfacePath& path, const Eigen::Vector3d& p, std::int32_t face) {
  if (p == path.points.back()) return;
  path.points.push_back(p);
  path.faces.push_back(face);
}

bool walk_towards(const TriangleMesh& mesh, const Place& a, const Place& b, SurfacePath& path) {
  std::vector<std::int32_t> goal_faces, faces;
  faces_at(mesh, b, goal_faces);
  const auto is_goal = [&goal_faces](std::int32_t f) {
    return std::find(goal_faces.begin(), goal_faces.end(), f) != goal_faces.end();
  };
  Place here = a;
  std::int32_t came_from = -1;
  for (int idle = 0; idle < kIdleSteps;) {
    faces_at(mesh, here, faces);
    Step best;
    for (const std::int32_t f : faces) {
      if (is_goal(f)) {
        append_point(path, b.position, f);
        return true;
      }
      if (f == came_from) continue;
      Step step = step_through(mesh, here, f, b);
      if (step.progress > best.progress) best = step;
    }
    const Step along = step_along_edge(mesh, here, b);
    if (along.progress > best.progress) best = along;
    if (best.progress <= 0) return false;
    const double before = (here.position - b.position).squaredNorm(),
                 after = (best.exit.position - b.position).squaredNorm();
    if (after >= before) ++idle;  // rounding only: exactly, every step comes nearer
    came_from = best.exit.vertex >= 0 ? -1 : best.exit.where.face;
    append_point(path, best.exit.position, best.exit.where.face);
    here = best.exit;
  }
  return false;
}

}  // namespace leastcost
