// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/end_point.hpp"

namespace leastcost {
namespace {

constexpr double kPositionError = 8;  // roundings of the largest coordinate: three products and two sums
constexpr double kAtVertex = 1e-12;   // barycentric, as of vertex_at

/// The vertex that a place in a face with corners at one place is at: between these corners. -1: it is at none.
std::int32_t vertex_of_needle(const HalfEdges& mesh, const SurfacePoint& p) {
  for (const std::int32_t v : mesh.mesh().face(p.face)) {
    double weight = 0;
    for (int k = 0; k < 3; ++k)
      if (mesh.position(mesh.tail(3 * p.face + k)) == mesh.position(v)) weight += p.barycentric[k];
    if (weight >= 1 - kAtVertex) return v;
  }
  return -1;
}

}  // namespace

EndPoint end_point(const HalfEdges& mesh, const SurfacePoint& p) {
  const Place place = place_of(mesh.mesh(), p);
  EndPoint end;
  end.position = place.position;
  end.vertex = place.vertex;
  if (end.vertex < 0 && mesh.is_needle(p.face)) end.vertex = vertex_of_needle(mesh, p);
  if (end.vertex >= 0) {
    end.position = mesh.position(end.vertex);
    return end;
  }
  end.edge = place.edge;
  faces_at(mesh.mesh(), place, end.faces);  // three and more on an edge where sheets meet
  end.error = kPositionError * kRoundingOf<double> * mesh.reach();
  return end;
}

}  // namespace leastcost
