// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/config/config_facts.hpp"

#include <algorithm>

#include <leastcost/catalogue/plugins/abilities.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/obstacles/has_walls.hpp>
#include <leastcost/recipes/facts.hpp>
#include "catalogue/config/choice_options.hpp"
#include "catalogue/config/raster_reading.hpp"
#include "catalogue/plugins/external_plugin.hpp"

namespace leastcost {
namespace {

bool is_one_of(std::string_view type, std::initializer_list<std::string_view> types) {
  return std::count(types.begin(), types.end(), type) > 0;
}

/// Costs that depend on the place, so that there may be locally least paths on several sides.
bool has_several_ways(std::string_view cost) {
  return is_one_of(cost, {"cost_map", "refractive_index", "metric_field", "walking", "zermelo", "formula", "sum",
                          "scaled", "clearance"});
}

/// The coordinates of points, where the ends say so, or of many pairs of ends their flat domain; else 0.
Eigen::Index coordinates(const RunConfig& config) {
  if (const auto* domain = external_object<ConstraintManifold>(config.manifold)) return domain->dimensions().coordinate;
  if (config.has_pairs() || (config.ends_come_later() && !config.source))
    return is_flat(config.manifold) ? whole_option(config.manifold, "dimension") : 0;
  if (config.source && config.source->lonlat) return 2;
  return config.source && config.source->point ? config.source->point->size() : 0;
}

bool is_unbounded(const PluginChoice& euclidean) {
  const ConfigNode options = options_as_tree(euclidean);
  return options.find("lower") == nullptr && options.find("upper") == nullptr;
}

/// Among obstacles, under a cost that is a length. A string in space knows obstacles only: one that the sides of a box
/// would have to hold is a solver's.
bool plans_taut(const RunConfig& config, const ProblemFacts& facts) {
  return facts.euclidean && facts.length && facts.coordinates != 0 && why_not_taut(config).empty() &&
         (facts.coordinates == 2 || facts.unbounded);
}

/// What an object that stands for the domain keeps paths out of; null: nothing.
const Walls* walls_of(const PluginChoice& manifold) {
  const auto* among = find_ability<HasWalls>(external_object<ConstraintManifold>(manifold));
  return among == nullptr ? nullptr : &among->walls();
}

bool is_taut_around(const Walls& walls, Eigen::Index dimension) {
  return dimension == 2 ? find_ability<HasRounds>(walls) != nullptr : find_ability<HasSupportPlanes>(walls) != nullptr;
}

/// Whether a path can be pulled tight around it, in the plane or in space.
bool is_taut_around(const PluginChoice& obstacle, Eigen::Index dimension) {
  if (const auto* object = external_object<Obstacle>(obstacle)) return dimension == 2 || object->convex();
  return is_type(obstacle, {"ball", "box", "capsule"}) || (dimension != 3 && is_type(obstacle, {"polygon", "map"})) ||
         (dimension == 3 && is_type(obstacle, {"cone", "cylinder", "half_space", "octomap"}));
}

/// A first path that states no class: waypoints, other routes and the like are given for the sake of their class.
bool states_no_class(const PluginChoice& initializer) {
  if (!initializer) return true;
  if (is_type(initializer, {"eikonal", "grid", "rrt", "ompl"})) return true;
  if (initializer.plugin->type != "dijkstra" || !initializer.options) return false;
  return static_cast<const OptionsOf<DijkstraOptions>&>(*initializer.options).value.rank == 1;
}

}  // namespace

ProblemFacts facts_of_types(const PluginEntry* manifold, std::string_view cost) {
  const std::string_view domain = manifold != nullptr ? std::string_view(manifold->type) : "";
  const auto provides = [&](std::string_view ability) {
    return manifold != nullptr && std::count(manifold->provides.begin(), manifold->provides.end(), ability) > 0;
  };
  ProblemFacts facts;
  facts.euclidean = is_one_of(domain, {"euclidean", "robot"});
  facts.terrain = domain == "terrain";
  facts.chart = is_one_of(domain, {"terrain", "parametric", "earth"});
  facts.mesh = provides(HasMesh::kAbility);
  facts.occupancy = facts.mesh && domain != "mesh";
  facts.graph = provides(HasGraph::kAbility);
  facts.level_set = provides(HasLevelSet::kAbility);
  facts.field = has_several_ways(cost);
  return facts;
}

std::string why_not_taut(const RunConfig& config) {
  if (config.ring) return "joins two ends, but a ring has none";
  if (config.robot) return "works for points, not for a robot";
  if (config.manifold && !is_flat(config.manifold)) return "works in the plane and in space";
  const Walls* walls = walls_of(config.manifold);
  if (config.obstacles.empty() && walls == nullptr) return "needs obstacles around which to pull the path";
  const Eigen::Index d = coordinates(config);
  if (d != 0 && d != 2 && d != 3) return "works in the plane and in space";
  if (walls != nullptr && !is_taut_around(*walls, d)) return "needs obstacles that a path can be pulled tight around";
  for (const PluginChoice& obstacle : config.obstacles)
    if (obstacle && !is_taut_around(obstacle, d))
      return d == 3 ? "needs convex obstacles: balls, boxes, capsules, cones, cylinders, half-spaces or octomaps"
                    : "needs obstacles that are balls, boxes, capsules, polygons or maps";
  return "";
}

ProblemFacts facts_of(const RunConfig& config) {
  const std::string_view cost = config.cost ? std::string_view(config.cost.plugin->type) : std::string_view();
  ProblemFacts facts = facts_of_types(config.manifold.plugin, cost);
  facts.unbounded = facts.euclidean && is_unbounded(config.manifold);
  facts.constant_metric = config.cost && config.cost.provides<HasConstantMetric>();
  facts.length = is_type(config.cost, {"euclidean"});
  facts.layers = config.cost && config.cost.provides<HasLayers>();
  facts.cells = reads_cells(config);
  if (const auto* domain = external_object<ConstraintManifold>(config.manifold)) add_facts(*domain, facts);
  if (const auto* object = external_object<SegmentCost>(config.cost)) add_facts(*object, facts);
  facts.ring = config.ring;
  facts.obstacles = facts.obstacles || !config.obstacles.empty();
  facts.robot = facts.robot || config.robot;
  facts.coordinates = static_cast<int>(coordinates(config));
  facts.pulls_tight = plans_taut(config, facts);
  return facts;
}

FirstPathFacts first_path_of(const RunConfig& config) {
  return {.straight = is_type(config.initializer, {"straight"}), .states_class = !states_no_class(config.initializer)};
}

GlobalProof asked_proof(const RunConfig& config) {
  return config.certificate.enabled ? config.certificate.global : GlobalProof(GlobalOff{});
}

bool proves_shortest(const RunConfig& config) {
  return !config.family.wanted() &&
         proves_over_all_classes(facts_of(config), first_path_of(config), asked_proof(config));
}

bool sees_one_way(const RunConfig& config) {
  return !config.family.wanted() && sees_one_way(facts_of(config), first_path_of(config), asked_proof(config));
}

bool brackets(const RunConfig& config) {
  return !proves_shortest(config) && brackets_in_box(facts_of(config), asked_proof(config));
}

}  // namespace leastcost
