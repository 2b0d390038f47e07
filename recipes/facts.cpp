// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/recipes/facts.hpp>

#include <limits>
#include <typeinfo>
#include <vector>

#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/cost/starts_straight.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include <leastcost/framework/problem/has_graph.hpp>
#include <leastcost/problems/chart/seams.hpp>
#include <leastcost/problems/drawing/draws_poses.hpp>
#include <leastcost/problems/layers/has_layers.hpp>
#include <leastcost/problems/level_set/has_level_set.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include <leastcost/problems/obstacles/has_walls.hpp>
#include <leastcost/problems/raster/has_voids.hpp>
#include "problems/cells/has_cost_cells.hpp"

namespace leastcost {
namespace {

/// Under what is laid over it: obstacles, say.
const ConstraintManifold& underlying(const ConstraintManifold& domain) {
  const ConstraintManifold* inner = &domain;
  while (const ConstraintManifold* next = inner->decorated(typeid(void))) inner = next;
  return *inner;
}

/// R^d or a box in it: coordinates are places, all of them apart from one another.
bool is_euclidean(const ConstraintManifold& domain) {
  const Dimensions d = domain.dimensions();
  return underlying(domain).shape() == Shape::flat && d.coordinate == d.ambient && d.tangent == d.ambient &&
         find_ability<HasChart>(domain) == nullptr && find_ability<HasSeams>(domain) == nullptr &&
         find_ability<HasBox>(domain) != nullptr && find_ability<DrawsPoses>(domain) == nullptr;
}

bool is_unbounded(const ConstraintManifold& domain) {
  const auto* box = find_ability<HasBox>(domain);
  return box == nullptr || (box->box_lower().array().isInf().all() && box->box_upper().array().isInf().all());
}

/// A multiple of the length, the same in all directions.
bool is_length(const SegmentCost& cost) {
  const auto* constant = find_ability<HasConstantMetric>(cost);
  if (constant == nullptr) return false;
  const Eigen::MatrixXd metric = constant->metric();
  return metric.isApprox(metric(0, 0) * Eigen::MatrixXd::Identity(metric.rows(), metric.cols()));
}

/// In space all obstacles have to be convex and the domain unbounded: the string does not know the sides of a box.
bool pulls_tight(const Problem& problem, const ProblemFacts& facts) {
  const auto* among = find_ability<HasWalls>(*problem.manifold);
  if (among == nullptr || facts.ring || !facts.euclidean || !facts.length) return false;
  const Walls& walls = among->walls();
  if (facts.coordinates == 2) return find_ability<HasRounds>(walls) != nullptr;
  std::vector<SupportPlane> planes;
  const auto* convex = find_ability<HasSupportPlanes>(walls);
  return convex != nullptr && facts.coordinates == 3 && facts.unbounded &&
         convex->planes(problem.source.u, problem.source.u, std::numeric_limits<double>::infinity(), planes);
}

}  // namespace

void add_facts(const ConstraintManifold& domain, ProblemFacts& facts) {
  facts.obstacles = find_ability<HasWalls>(domain) != nullptr;
  facts.robot = find_ability<DrawsPoses>(domain) != nullptr;
  facts.euclidean = is_euclidean(domain);
  facts.unbounded = facts.euclidean && is_unbounded(domain);
  facts.terrain = find_ability<HasVoids>(domain) != nullptr;
  facts.chart = find_ability<HasChart>(domain) != nullptr;
  facts.mesh = find_ability<HasMesh>(domain) != nullptr;
  facts.occupancy = facts.mesh && domain.dimensions().ambient == 2;
  facts.graph = find_ability<HasGraph>(domain) != nullptr;
  facts.level_set = find_ability<HasLevelSet>(domain) != nullptr;
  facts.coordinates = domain.dimensions().coordinate;
}

void add_facts(const SegmentCost& cost, ProblemFacts& facts) {
  facts.constant_metric = find_ability<HasConstantMetric>(cost) != nullptr;
  facts.length = is_length(cost);
  facts.layers = find_ability<HasLayers>(cost) != nullptr;
  facts.cells = find_ability<HasCostCells>(cost) != nullptr;
  facts.field = !facts.constant_metric && !facts.layers && find_ability<StartsStraight>(cost) == nullptr;
}

ProblemFacts facts_of(const Problem& problem) {
  ProblemFacts facts;
  facts.ring = problem.ring || problem.based;
  add_facts(*problem.manifold, facts);
  add_facts(*problem.cost, facts);
  facts.pulls_tight = pulls_tight(problem, facts);
  return facts;
}

}  // namespace leastcost
