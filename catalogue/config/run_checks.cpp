// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/config/run_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/initializers/eikonal.hpp>
#include <leastcost/recipes/methods.hpp>
#include "catalogue/options/options_writer.hpp"
#include "catalogue/plugins/abilities.hpp"
#include "catalogue/plugins/kinds.hpp"
#include "catalogue/registry/registry.hpp"
#include "catalogue/yaml/scalars.hpp"
#include "catalogue/yaml/suggest.hpp"

namespace leastcost {
namespace {

PluginChoice default_plugin(const char* kind_name, const char* type, const std::string& path) {
  return choose(*find_plugin(kind(kind_name), type), path);
}

bool is_one_of(std::string_view type, std::initializer_list<std::string_view> types) {
  return std::count(types.begin(), types.end(), type) > 0;
}

/// Costs that depend on the place, so that there may be locally least paths on several sides.
bool has_several_ways(std::string_view cost) {
  return is_one_of(cost, {"cost_map", "refractive_index", "metric_field", "walking", "zermelo", "formula", "sum",
                          "scaled", "clearance"});
}

/// What the types of a domain and a cost say to the recipes.
ProblemFacts facts_of_types(const PluginEntry* manifold, std::string_view cost) {
  const std::string_view domain = manifold != nullptr ? std::string_view(manifold->type) : "";
  const auto provides = [&](std::string_view ability) {
    return manifold != nullptr && std::count(manifold->provides.begin(), manifold->provides.end(), ability) > 0;
  };
  ProblemFacts facts;
  facts.euclidean = domain == "euclidean";
  facts.terrain = domain == "terrain";
  facts.chart = is_one_of(domain, {"terrain", "parametric", "earth"});
  facts.mesh = provides(HasMesh::kAbility);
  facts.occupancy = facts.mesh && domain != "mesh";
  facts.graph = provides(HasGraph::kAbility);
  facts.level_set = provides(HasLevelSet::kAbility);
  facts.field = has_several_ways(cost);
  return facts;
}

bool is(const PluginChoice& choice, std::initializer_list<std::string_view> types) {
  return choice && std::count(types.begin(), types.end(), choice.plugin->type) > 0;
}

/// The options of a plug-in, as a configuration would have them; those that are not given and have no default are left
/// out.
ConfigNode options_of(const PluginChoice& choice) {
  OptionsWriter writer;
  if (choice.options) choice.options->fields(writer);
  return writer.take();
}

/// A whole number among the options of a plug-in; 0 where it has none of this name.
int whole_option(const PluginChoice& choice, std::string_view name) {
  const ConfigNode options = options_of(choice);
  const ConfigEntry* entry = options.find(name);
  return entry == nullptr ? 0 : parse_int(entry->value).value.value_or(0);
}

/// The coordinates of points, where the ends say so, or of many pairs of ends their flat domain; else 0.
Eigen::Index coordinates(const RunConfig& config) {
  if (config.has_pairs()) return is(config.manifold, {"euclidean"}) ? whole_option(config.manifold, "dimension") : 0;
  if (config.source && config.source->lonlat) return 2;
  return config.source && config.source->point ? config.source->point->size() : 0;
}

/// Why paths cannot be pulled tight among the obstacles; empty: they can. Obstacles are told by their types.
std::string why_not_taut(const RunConfig& config) {
  if (config.ring) return "joins two ends, but a ring has none";
  if (config.robot) return "works for points, not for a robot";
  if (config.manifold && !is(config.manifold, {"euclidean"})) return "works in the plane and in space";
  if (config.obstacles.empty()) return "needs obstacles around which to pull the path";
  const Eigen::Index d = coordinates(config);
  if (d != 0 && d != 2 && d != 3) return "works in the plane and in space";
  for (const PluginChoice& obstacle : config.obstacles)
    if (obstacle && !is(obstacle, {"ball", "box"}) && (d == 3 || !is(obstacle, {"polygon", "map"})))
      return d == 3 ? "needs convex obstacles: balls or boxes"
                    : "needs obstacles that are balls, boxes, polygons or maps";
  return "";
}

/// A string in space knows obstacles only: one that the sides of a box would have to hold is a solver's.
bool is_unbounded(const PluginChoice& euclidean) {
  const ConfigNode options = options_of(euclidean);
  return options.find("lower") == nullptr && options.find("upper") == nullptr;
}

/// Among obstacles, under a cost that is a length.
bool plans_taut(const RunConfig& config) {
  return is(config.manifold, {"euclidean"}) && is(config.cost, {"euclidean"}) && coordinates(config) != 0 &&
         why_not_taut(config).empty() && (coordinates(config) == 2 || is_unbounded(config.manifold));
}

/// How a raster of costs is read; null: the cost is another one.
CostMapInterpolation* interpolation_of(const RunConfig& config) {
  if (!is(config.cost, {"cost_map"}) || !config.cost.options) return nullptr;
  return &static_cast<OptionsOf<CostMapOptions>&>(*config.cost.options).value.interpolation;
}

bool reads_cells(const RunConfig& config) {
  const auto* interpolation = interpolation_of(config);
  return interpolation != nullptr && *interpolation == CostMapInterpolation::cells;
}

/// In R^d without obstacles, where a path can be refracted at the sides of cells.
bool is_free(const RunConfig& config) {
  return !config.ring && !config.robot && config.obstacles.empty() && is(config.manifold, {"euclidean"});
}

/// Whether something is asked for that needs a smooth cost, or obstacles where there are no data.
bool asks_for_smooth(const RunConfig& config) { return config.solver || config.post_process || config.clearance > 0; }

/// A raster is read as it is where that can be solved.
void choose_interpolation(RunConfig& config) {
  auto* interpolation = interpolation_of(config);
  if (interpolation == nullptr || *interpolation != CostMapInterpolation::automatic) return;
  const bool cells = is_free(config) && whole_option(config.manifold, "dimension") == 2 && !asks_for_smooth(config);
  *interpolation = cells ? CostMapInterpolation::cells : CostMapInterpolation::smooth;
}

/// A first path that states no class: waypoints, other routes and the like are given for the sake of their class.
bool states_no_class(const PluginChoice& initializer) {
  if (!initializer) return true;
  if (is(initializer, {"eikonal", "grid", "rrt", "ompl"})) return true;
  if (initializer.plugin->type != "dijkstra" || !initializer.options) return false;
  return static_cast<const OptionsOf<DijkstraOptions>&>(*initializer.options).value.rank == 1;
}

ProblemFacts facts_of(const RunConfig& config) {
  const std::string_view cost = config.cost ? std::string_view(config.cost.plugin->type) : std::string_view();
  ProblemFacts facts = facts_of_types(config.manifold.plugin, cost);
  facts.ring = config.ring;
  facts.obstacles = !config.obstacles.empty();
  facts.robot = static_cast<bool>(config.robot);
  facts.coordinates = static_cast<int>(coordinates(config));
  facts.constant_metric = config.cost && config.cost.provides<HasConstantMetric>();
  facts.layers = config.cost && config.cost.provides<HasLayers>();
  facts.cells = reads_cells(config);
  facts.pulls_tight = plans_taut(config);
  return facts;
}

FirstPathFacts first_path_of(const RunConfig& config) {
  return {.straight = is(config.initializer, {"straight"}), .states_class = !states_no_class(config.initializer)};
}

}  // namespace

bool proves_shortest(const RunConfig& config) {
  return config.certificate.enabled && !config.family.wanted() &&
         proves_over_all_classes(facts_of(config), first_path_of(config), config.certificate.global);
}

bool sees_one_way(const RunConfig& config) {
  return !config.ring && !config.robot && config.obstacles.empty() && !config.family.wanted() && !brackets(config) &&
         !proves_shortest(config) && is(config.initializer, {"straight"}) && config.cost &&
         has_several_ways(config.cost.plugin->type);
}

bool brackets(const RunConfig& config) {
  return config.certificate.enabled && !proves_shortest(config) &&
         brackets_in_box(facts_of(config), config.certificate.global);
}

namespace {

/// The default of a path that is only straightened, and proved: its class is then more often that of the shortest.
void go_over_diagonals(PluginChoice& dijkstra) {
  static_cast<OptionsOf<DijkstraOptions>&>(*dijkstra.options).value.diagonals = true;
}

void fall_back(PluginChoice& eikonal) {
  static_cast<OptionsOf<EikonalOptions>&>(*eikonal.options).value.fallback = true;
}

/// The recipes choose; what they choose is written down as if it had been asked for.
void complete(RunConfig& config) {
  choose_interpolation(config);
  const bool default_first = !config.initializer, default_steps = !config.post_process;
  const ProblemFacts facts = facts_of(config);
  const auto fill = [&](const char* part, std::string_view type, PluginChoice& choice) {
    if (!choice && !type.empty()) choice = default_plugin(part, std::string(type).c_str(), part);
  };
  fill("kernel", "expm1_square", config.kernel);
  fill("initializer", word_of(recommended_first_path(facts)), config.initializer);
  if (default_first && is(config.initializer, {"eikonal"})) fall_back(config.initializer);
  const bool exact = default_steps && (makes_exact_curves(facts) || proves_shortest(config));
  if (exact && !config.solver && default_first && is(config.manifold, {"mesh"})) go_over_diagonals(config.initializer);
  fill("solver", word_of(recommended_solver(facts, exact)), config.solver);
  if (!default_steps) return;
  PluginList& steps = config.post_process.emplace();
  for (const CurveMethod method : recommended_curve(facts))
    steps.push_back(default_plugin("post_processor", std::string(word_of(method)).c_str(),
                                   "post_process." + std::to_string(steps.size())));
}

/// Whether it is something that costs have, not manifolds.
bool of_costs(const std::string& ability) {
  const auto& costs = kind("cost").entries;
  return std::any_of(costs.begin(), costs.end(),
                     [&](const PluginEntry* e) { return choose(*e, "").provides(ability); });
}

void check_needs(LoadedConfig& loaded, const PluginChoice& choice) {
  if (!choice || !loaded.config.manifold || !loaded.config.cost) return;
  for (const std::string& need : choice.plugin->needs) {
    const bool of_cost = of_costs(need);
    const PluginChoice& giver = of_cost ? loaded.config.cost : loaded.config.manifold;
    if (giver.provides(need)) continue;
    loaded.errors.error(place_of(loaded.tree, choice.path),
                        fmt::format("'{}' needs a {} with a {}, but '{}' has none", choice.plugin->type,
                                    of_cost ? "cost" : "manifold", need, giver.plugin->type));
  }
}

/// Pairs take the place of the two ends, and of what only one path can have.
void check_pairs(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  const auto refuse = [&loaded](const char* key, const char* reason) {
    loaded.errors.error(place_of(loaded.tree, key), reason);
  };
  if (!config.has_pairs()) {
    if (config.pair_tolerance)
      refuse("ends.tolerance", "'tolerance' in ends is only for pairs: for a single end, set it in source or target");
    if (config.pair_points)
      refuse("output.pair_points", "'pair_points' needs many pairs of ends: give ends.pairs, or remove it");
    return;
  }
  if (config.source || config.target) refuse("ends.pairs", "give either 'pairs' or 'source' and 'target', not both");
  if (config.ring) refuse("ends.pairs", "a ring (path.ring: true) has no ends: remove one of the two");
  if (!config.output_files.empty())
    refuse("output.files",
           "'files' is for runs of one path: remove it; runs of many pairs write paths.jsonl and result.json");
  if (config.waypoints.wanted())
    refuse("output.waypoints", "waypoints are for runs of one path, not for pairs: remove them");
}

void check_files_of_output(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  const Place place = place_of(loaded.tree, "output.files");
  const std::vector<std::string> known(kRunFiles.begin(), kRunFiles.end());
  for (const std::string& file : config.output_files)
    if (std::count(known.begin(), known.end(), file) == 0)
      loaded.errors.error(place, fmt::format("'files' has {}, which is not one of: {}{}", in_quotes(file),
                                             joined(known), did_you_mean(file, known)));
  if (config.output_files.empty() || !config.writes("report")) return;
  for (const char* needed : {"result", "path", "history", "scene", "config"})
    if (!config.writes(needed))
      loaded.errors.error(place, fmt::format("'files' has 'report', which also needs '{}': add it", needed));
}

void check_ends(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  check_pairs(loaded);
  if (config.has_pairs()) return;
  const ConfigEntry* ends = loaded.tree.find("ends");
  if (ends != nullptr && ends->value.is_block() && ends->value.find("source") == nullptr)
    loaded.errors.error(ends->place, "missing key 'source' in ends: Start of the path; in a ring, its fixed point.");
  const bool target = ends != nullptr && ends->value.find("target") != nullptr;
  if (config.ring && target) {
    loaded.errors.error(
        ends->place,
        "a ring (path.ring: true) has no target: remove one of the two; a source alone is a fixed point of the ring");
  } else if (!config.ring && ends != nullptr && ends->value.is_block() && !target) {
    loaded.errors.error(ends->place, "missing key 'target' in ends: End of the path.");
  } else if (!config.ring && ends == nullptr && loaded.tree.is_block()) {
    loaded.errors.error(loaded.place, "missing key 'ends': the source and target of the path, or path.ring: true");
  }
  if (!config.manifold) return;
  const bool has_vertices = config.manifold.provides<HasVertices>(), has_faces = config.manifold.provides<HasFaces>();
  for (const char* path : {"ends.source", "ends.target"}) {
    const std::optional<EndOptions>& end = std::string_view(path) == "ends.source" ? config.source : config.target;
    if (!end) continue;
    const bool fits = end->face ? has_faces : !end->vertex || has_vertices;
    if (fits) continue;
    loaded.errors.error(place_of(loaded.tree, std::string(path) + (end->vertex ? ".vertex" : ".face")),
                        fmt::format("'{}' has no {}: give the end as {{point: [..]}}{}", config.manifold.plugin->type,
                                    end->face ? HasFaces::kAbility : HasVertices::kAbility,
                                    has_vertices ? " or {vertex: .., a sample of the file}" : ""));
  }
}

/// The initializers that make rings on a manifold, for people: "plane_cut, waypoints or file".
std::string ring_initializers(const PluginChoice& manifold) {
  std::vector<std::string> fitting;
  for (const PluginEntry* entry : kind("initializer").entries) {
    const auto met = [&](const std::string& need) { return !manifold || manifold.provides(need); };
    if (choose(*entry, "").provides<MakesRings>() && std::all_of(entry->needs.begin(), entry->needs.end(), met))
      fitting.push_back(entry->type);
  }
  std::string text = fitting.front();
  for (std::size_t i = 1; i < fitting.size(); ++i) text += (i + 1 < fitting.size() ? ", " : " or ") + fitting[i];
  return text;
}

void check_family(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  const auto refuse = [&loaded](const char* key, const char* reason) {
    loaded.errors.error(place_of(loaded.tree, std::string("family.") + key), fmt::format("'{}' {}", key, reason));
  };
  if (config.family.windings > 0 && config.ring)
    refuse("windings", "tries images of the target, but a ring has none: give other first rings (family.initializers)");
  else if (config.family.windings > 0 && config.manifold && !config.manifold.provides<HasSeams>())
    refuse("windings", "needs a manifold with a chart with seams");
  if (config.family.bows > 0 && config.ring)
    refuse("bows", "bows the line between two ends, but a ring has none: give other first rings (family.initializers)");
  if (config.family.routes > 1 && config.ring)
    refuse("routes",
           "tries routes between two ends, but a ring has none: give other first rings (family.initializers)");
  else if (config.family.routes > 1 && config.manifold && !config.manifold.provides<HasGraph>())
    refuse("routes", "needs a manifold with a graph: a mesh or a point cloud");
  if (config.family.mirrored && config.ring)
    refuse("mirrored", "mirrors a path at its ends, but a ring has none: give other first rings (family.initializers)");
  if (!config.ring) return;
  for (const PluginChoice& choice : config.family.initializers)
    if (choice && !choice.provides<MakesRings>())
      loaded.errors.error(place_of(loaded.tree, choice.path),
                          fmt::format("'{}' joins two ends, but a ring has none: use {}", choice.plugin->type,
                                      ring_initializers(config.manifold)));
}

void check_ring(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  if (!config.ring) return;
  if (!config.initializer) {
    if (loaded.tree.find("initializer") == nullptr)
      loaded.errors.error(
          place_of(loaded.tree, "path.ring"),
          "a ring has no default first path: give an initializer: " + ring_initializers(config.manifold));
  } else if (!config.initializer.provides<MakesRings>()) {
    loaded.errors.error(place_of(loaded.tree, "initializer"),
                        fmt::format("'{}' joins two ends, but a ring has none: use {}", config.initializer.plugin->type,
                                    ring_initializers(config.manifold)));
  }
}

void check_taut(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  for (const PluginChoice& step : config.post_process.value_or(PluginList{})) {
    if (!is(step, {"taut"})) continue;
    const std::string why = why_not_taut(config);
    if (!why.empty()) loaded.errors.error(place_of(loaded.tree, step.path), "'taut' " + why);
    if (config.cost && !config.cost.provides<HasConstantMetric>())
      loaded.errors.error(
          place_of(loaded.tree, step.path),
          fmt::format("'taut' needs a cost with a constant metric, but '{}' has none", config.cost.plugin->type));
  }
}

void check_refract(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  if (!config.manifold || !config.cost || !config.cost.provides<HasLayers>() || is_free(config)) return;
  for (const PluginChoice& step : config.post_process.value_or(PluginList{}))
    if (is(step, {"refract"}))
      loaded.errors.error(
          place_of(loaded.tree, step.path),
          "'refract' works for paths between two ends in R^d or a box (euclidean), without obstacles or robots");
}

void check_cells(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  if (!config.manifold || !config.cost) return;
  if (reads_cells(config) && !is_free(config))
    loaded.errors.error(place_of(loaded.tree, "cost.interpolation"),
                        "'cells' works for paths between two ends in the plane or a box (euclidean), without obstacles "
                        "or robots: use interpolation: smooth");
  PluginList asking = config.post_process.value_or(PluginList{});
  asking.push_back(config.initializer);
  asking.insert(asking.end(), config.family.initializers.begin(), config.family.initializers.end());
  for (const PluginChoice& choice : asking)
    if (is(choice, {"refract_cells", "cell_graph"}) && !reads_cells(config))
      loaded.errors.error(
          place_of(loaded.tree, choice.path),
          fmt::format("'{}' needs a cost map that is constant in each cell: cost: {{type: cost_map, file: .., "
                      "interpolation: cells}}",
                      choice.plugin->type));
}

/// What a bracket of the globally least cost in a box needs, as far as a configuration shows it.
void check_bracket(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  if (!brackets(config)) return;
  const auto refuse = [&](const std::string& why) {
    loaded.errors.error(place_of(loaded.tree, "certificate.global"), "a proof over all paths in a box " + why);
  };
  if (config.ring) refuse("works for paths between two ends, but a ring has none: remove it");
  if (config.family.wanted()) refuse("finds the least cost, but a family lists other paths: remove one of the two");
  if (!is(config.manifold, {"euclidean"})) return;  // terrain has its own box
  const int dimension = whole_option(config.manifold, "dimension");
  if (dimension != 2 && dimension != 3) refuse("works in two and three dimensions only: remove it");
  const ConfigNode options = options_of(config.manifold);
  if (options.find("lower") == nullptr || options.find("upper") == nullptr)
    refuse("needs a box: give the manifold lower: [..] and upper: [..]");
}

void check_points(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  const Place place = place_of(loaded.tree, "path.points");
  constexpr int kFewestInRing = 3;
  if (config.ring && config.points.value_or(kFewestInRing) < kFewestInRing)
    loaded.errors.error(place, fmt::format("a ring needs at least {} points", kFewestInRing));
  if (config.points || !config.manifold || config.manifold.provides<HasGraph>()) return;
  loaded.errors.error(
      place,
      fmt::format(
          "'auto' takes the number of points from the first path along edges, but '{}' has no edges: give a number",
          config.manifold.plugin->type));
}

void check_waypoints(LoadedConfig& loaded) {
  const WaypointOptions& asked = loaded.config.waypoints;
  const Place place = place_of(loaded.tree, "output.waypoints");
  if (asked.count && asked.spacing)
    loaded.errors.error(place, "waypoints need either a 'count' or a 'spacing': remove one of the two");
  constexpr int kFewestInRing = 3;
  if (asked.count && loaded.config.ring && *asked.count < kFewestInRing)
    loaded.errors.error(place, fmt::format("'count' must be at least {} in a ring", kFewestInRing));
}

void check_name(LoadedConfig& loaded) {
  const std::string fault = name_fault(loaded.config.name);
  if (!fault.empty()) loaded.errors.error(place_of(loaded.tree, "name"), fault);
}

/// The program does not act on it; the tests do.
void check_expected_exit(LoadedConfig& loaded) {
  const ConfigEntry* note = loaded.tree.find("x-expect-exit");
  if (note == nullptr) return;
  constexpr std::array<int, 9> kCodes = {0, 1, 3, 4, 5, 6, 7, 8, 130};
  const Parsed<int> code = parse_int(note->value);
  if (code.value && std::count(kCodes.begin(), kCodes.end(), *code.value) > 0) return;
  loaded.errors.error(
      note->value.place,
      "'x-expect-exit' must be an exit code of a run: 0, 1, 3, 4, 5, 6, 7, 8 or 130 (" + found(note->value) + ")");
}

}  // namespace

std::string name_fault(const std::string& name) {
  const bool harmless = std::none_of(name.begin(), name.end(), [](char c) {
    return c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
  constexpr std::size_t kLongestName = 200;  // file systems stop at 255 bytes
  if (harmless && !name.empty() && name[0] != '.' && name.size() <= kLongestName) return "";
  return "'name' is used as a folder name: it must not be empty, begin with a dot, contain a slash or a control "
         "character, or have more than 200 bytes";
}

void complete_types(ConfigNode& tree) {
  const auto text_at = [&](std::string_view path) {
    const ConfigNode* node = node_at(tree, path);
    return node != nullptr && node->is_scalar() ? node->text : std::string();
  };
  const std::string type = text_at("manifold");
  const PluginEntry* manifold = find_plugin(kind("manifold"), type.empty() ? text_at("manifold.type") : type);
  if (manifold == nullptr) return;  // an error of its own
  const std::string cost = text_at("cost"), cost_type = cost.empty() ? text_at("cost.type") : cost;
  const ConfigNode* point = node_at(tree, "ends.source.point");
  if (point == nullptr) point = node_at(tree, "ends.source.lonlat");
  const std::string interpolation = text_at("cost.interpolation");
  const bool by_default = (interpolation.empty() || interpolation == "auto") && tree.find("solver") == nullptr &&
                          tree.find("post_process") == nullptr && tree.find("clearance") == nullptr;
  ProblemFacts facts = facts_of_types(manifold, cost_type);
  facts.ring = text_at("path.ring") == "true";
  facts.obstacles = tree.find("obstacles") != nullptr;
  facts.robot = tree.find("robot") != nullptr;
  facts.coordinates = point != nullptr ? static_cast<int>(point->items.size()) : 0;
  facts.cells = cost_type == "cost_map" && (by_default || interpolation == "cells");
  const std::array<std::pair<const char*, std::string>, 3> defaults = {
      {{"kernel", "expm1_square"},
       {"initializer", std::string(word_of(recommended_first_path(facts)))},
       {"solver", std::string(word_of(recommended_solver(facts, false)))}}};
  for (const auto& [part, standard] : defaults) {
    ConfigEntry* entry = tree.find(part);
    if (entry == nullptr || !entry->value.is_block() || standard.empty()) continue;
    const auto& options = entry->value.entries;
    const bool replaced =
        std::any_of(options.begin(), options.end(), [](auto& o) { return !o.value.place.origin.empty(); });
    if (!replaced || entry->value.find("type") != nullptr) continue;
    entry->value.entries.push_back({"type", entry->place, scalar_node(standard)});
  }
}

std::string word_on_interpolation(const LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  const ConfigNode* asked = node_at(loaded.tree, "cost.interpolation");
  if (interpolation_of(config) == nullptr || (asked != nullptr && asked->text != "auto")) return "";
  if (reads_cells(config))
    return "the cost map is constant in each cell (interpolation: cells); to interpolate between the values, use "
           "'smooth' or 'bilinear'";
  std::string word = "the cost map is interpolated smoothly (interpolation: smooth)";
  if (is_free(config) && whole_option(config.manifold, "dimension") == 2)
    for (const auto& [key, what] : {std::pair("solver", "a solver"), std::pair("post_process", "a post-processor"),
                                    std::pair("clearance", "a clearance")})
      if (loaded.tree.find(key) != nullptr)
        return word + ", because " + what + " is given; remove it to read the map as constant in each cell";
  return word;
}

void check_and_complete(LoadedConfig& loaded) {
  complete(loaded.config);
  check_name(loaded);
  check_expected_exit(loaded);
  check_ends(loaded);
  check_ring(loaded);
  check_family(loaded);
  check_points(loaded);
  check_waypoints(loaded);
  check_files_of_output(loaded);
  check_taut(loaded);
  check_refract(loaded);
  check_cells(loaded);
  check_bracket(loaded);
  check_needs(loaded, loaded.config.initializer);
  check_needs(loaded, loaded.config.solver);
  for (const PluginChoice& choice : loaded.config.family.initializers) check_needs(loaded, choice);
  for (const PluginChoice& choice : loaded.config.post_process.value_or(PluginList{})) check_needs(loaded, choice);
}

}  // namespace leastcost
