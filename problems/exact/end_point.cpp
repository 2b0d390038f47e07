// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/end_point.hpp"

namespace leastcost {
namespace {

constexpr double kPositionError = 8;  // roundings of the largest coordinate: three products and two sums

}  // namespace

EndPoint end_point(const HalfEdges& mesh, const SurfacePoint& p) {
  const Place place = place_of(mesh.mesh(), p);
  EndPoint end;
  end.position = place.position;
  end.vertex = place.vertex;
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
