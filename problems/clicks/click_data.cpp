// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/clicks/click_data.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include <leastcost/problems/obstacles/has_walls.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {
namespace {

/// Nothing but the length of a move.
bool costs_length(const Problem& problem) {
  const auto* cost = find_ability<HasConstantMetric>(*problem.cost);
  return cost != nullptr && cost->metric().rows() == problem.manifold->dimensions().ambient &&
         cost->metric().isIdentity(0);
}

ClickedMesh clicked(const TriangleMesh& mesh) {
  ClickedMesh out;
  if (mesh.face_count() > kMostClickedTriangles) {
    out.too_large = mesh.face_count();
    return out;
  }
  bool renumbered = false;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    out.vertices.insert(out.vertices.end(), mesh.position(v).begin(), mesh.position(v).end());
    out.numbers.push_back(mesh.file_vertex(v));
    renumbered = renumbered || out.numbers.back() != v;
  }
  if (!renumbered) out.numbers.clear();
  for (const auto& face : mesh.faces()) out.triangles.insert(out.triangles.end(), face.begin(), face.end());
  return out;
}

/// Nothing where an obstacle is a capsule: the page makes balls and polygons.
std::optional<ClickedPlan> clicked(const HasRounds& walls) {
  constexpr double kFar = std::numeric_limits<double>::max();
  ClickedPlan out;
  int before = -1;
  for (const Round& round : walls.rounds({Eigen::Vector2d(-kFar, -kFar), Eigen::Vector2d(kFar, kFar)})) {
    if (round.obstacle != before) {
      before = round.obstacle;
      out.counts.push_back(0);
      out.required.push_back(round.radius);
    }
    ++out.counts.back();
    out.corners.insert(out.corners.end(), {round.center[0], round.center[1]});
  }
  if (std::count(out.counts.begin(), out.counts.end(), 2) > 0) return std::nullopt;
  const int obstacles = static_cast<int>(out.counts.size());
  if (obstacles <= kMostClickedObstacles) return out;
  out = {};
  out.too_large = obstacles;
  return out;
}

}  // namespace

ClickData click_data(const Problem& problem) {
  ClickData out;
  const ConstraintManifold& domain = *problem.manifold;
  if (!costs_length(problem)) return out;
  const auto* walled = find_ability<HasWalls>(domain);
  if (const auto* on_mesh = find_ability<HasMesh>(domain); on_mesh != nullptr) {
    if (walled == nullptr && domain.dimensions().ambient == 3) out.mesh = clicked(on_mesh->mesh());
    return out;
  }
  if (walled == nullptr || domain.dimensions().ambient != 2 || find_ability<HasChart>(domain) != nullptr) return out;
  const auto* discs = find_ability<HasRounds>(walled->walls());
  if (discs == nullptr) return out;
  out.plan = clicked(*discs);
  if (!out.plan) return out;
  if (const auto* box = find_ability<HasBox>(domain)) {
    out.plan->lower = box->box_lower();
    out.plan->upper = box->box_upper();
  }
  return out;
}

}  // namespace leastcost
