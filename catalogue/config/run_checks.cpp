// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/config/run_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <leastcost/catalogue/plugins/abilities.hpp>
#include <leastcost/problems/obstacles/has_walls.hpp>
#include "catalogue/config/choice_options.hpp"
#include "catalogue/config/config_defaults.hpp"
#include "catalogue/config/config_facts.hpp"
#include "catalogue/config/raster_reading.hpp"
#include "catalogue/plugins/external_plugin.hpp"
#include "catalogue/plugins/kinds.hpp"
#include "catalogue/registry/registry.hpp"
#include "catalogue/yaml/scalars.hpp"
#include "catalogue/yaml/suggest.hpp"

namespace leastcost {
namespace {

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
  if (config.wants_trajectory())
    refuse("output.trajectory", "a trajectory is for runs of one path, not for pairs: remove it");
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
  const bool asked = config.ends_from == EndsFrom::configuration;
  if (asked && ends != nullptr && ends->value.is_block() && ends->value.find("source") == nullptr)
    loaded.errors.error(ends->place, "missing key 'source' in ends: Start of the path; in a ring, its fixed point.");
  const bool target = ends != nullptr && ends->value.find("target") != nullptr;
  if (config.ring && target) {
    loaded.errors.error(
        ends->place,
        "a ring (path.ring: true) has no target: remove one of the two; a source alone is a fixed point of the ring");
  } else if (asked && !config.ring && ends != nullptr && ends->value.is_block() && !target) {
    loaded.errors.error(ends->place, "missing key 'target' in ends: End of the path.");
  } else if (asked && !config.ring && ends == nullptr && loaded.tree.is_block()) {
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
    if (!is_type(step, {"taut"})) continue;
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
    if (is_type(step, {"refract"}))
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
    if (is_type(choice, {"refract_cells", "cell_graph"}) && !reads_cells(config))
      loaded.errors.error(
          place_of(loaded.tree, choice.path),
          fmt::format("'{}' needs a cost map that is constant in each cell: cost: {{type: cost_map, file: .., "
                      "interpolation: cells}}",
                      choice.plugin->type));
}

/// A domain that is handed over among its own obstacles takes no others.
void check_walls(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  if (find_ability<HasWalls>(external_object<ConstraintManifold>(config.manifold)) == nullptr) return;
  for (const char* key : {"obstacles", "robot", "clearance"})
    if (loaded.tree.find(key) != nullptr)
      loaded.errors.error(place_of(loaded.tree, key),
                          fmt::format("'{}': the manifold is handed over among obstacles of its own: remove this key, "
                                      "or hand over the manifold without them",
                                      key));
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
  if (!is_type(config.manifold, {"euclidean"})) return;  // terrain has its own box
  const int dimension = whole_option(config.manifold, "dimension");
  if (dimension != 2 && dimension != 3) refuse("works in two and three dimensions only: remove it");
  if (is_type(config.cost, {"cost_map"})) return;  // a map has its own box, too
  const ConfigNode options = options_as_tree(config.manifold);
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
  if (config.robot && !config.ring) return;
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

void check_and_complete(LoadedConfig& loaded) {
  fill_defaults(loaded.config);
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
  check_walls(loaded);
  check_needs(loaded, loaded.config.initializer);
  check_needs(loaded, loaded.config.solver);
  for (const PluginChoice& choice : loaded.config.family.initializers) check_needs(loaded, choice);
  for (const PluginChoice& choice : loaded.config.post_process.value_or(PluginList{})) check_needs(loaded, choice);
}

}  // namespace leastcost
