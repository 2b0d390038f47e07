// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/run_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <leastcost/catalogue/registry/registry.hpp>
#include "catalogue/plugins/abilities.hpp"
#include "catalogue/yaml/scalars.hpp"

namespace leastcost {
namespace {

PluginChoice default_plugin(const char* kind_name, const char* type, const std::string& path) {
  return choose(*find_plugin(kind(kind_name), type), path);
}

void complete(RunConfig& config) {
  const bool mesh = config.manifold.provides<HasMesh>();
  const bool graph = config.manifold.provides<HasGraph>();
  if (!config.kernel) config.kernel = default_plugin("kernel", "expm1_square", "kernel");
  if (!config.initializer && !config.ring)
    config.initializer = default_plugin("initializer", graph ? "dijkstra" : "straight", "initializer");
  if (!config.solver) config.solver = default_plugin("solver", mesh ? "lbfgs" : "newton", "solver");
  if (config.post_process.given) return;
  config.post_process.given = true;
  if (config.manifold.provides<HasLevelSet>())
    config.post_process.choices.push_back(default_plugin("post_processor", "on_surface", "post_process.0"));
  if (mesh) config.post_process.choices.push_back(default_plugin("post_processor", "trace", "post_process.0"));
  if (mesh && config.cost.provides<HasConstantMetric>())
    config.post_process.choices.push_back(default_plugin("post_processor", "straighten", "post_process.1"));
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
                        fmt::format("'{}' needs a {} with a {}, which '{}' does not have", choice.plugin->type,
                                    of_cost ? "cost" : "manifold", need, giver.plugin->type));
  }
}

void check_ends(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  const ConfigEntry* ends = loaded.tree.find("ends");
  const bool target = ends != nullptr && ends->value.find("target") != nullptr;
  if (config.ring && target) {
    loaded.errors.error(ends->place,
                        "a ring (path.ring: true) has no ends: remove one of the two; the source alone is a fixed "
                        "point of the ring");
  } else if (!config.ring && ends != nullptr && ends->value.is_block() && !target) {
    loaded.errors.error(ends->place, "missing key 'target' in ends: Where the path ends.");
  } else if (!config.ring && ends == nullptr && loaded.tree.is_block()) {
    loaded.errors.error(loaded.place, "missing key 'ends': the source and target of the path, or path.ring: true");
  }
  if (!config.manifold) return;
  const bool has_vertices = config.manifold.provides<HasVertices>(), has_faces = config.manifold.provides<HasFaces>();
  for (const char* path : {"ends.source", "ends.target"}) {
    const EndOptions& end = std::string_view(path) == "ends.source" ? config.source : config.target;
    const bool fits = end.face >= 0 ? has_faces : end.vertex < 0 || has_vertices;
    if (fits) continue;
    loaded.errors.error(place_of(loaded.tree, std::string(path) + (end.vertex >= 0 ? ".vertex" : ".face")),
                        fmt::format("'{}' has no {}; an end on it is {{point: [..]}}{}", config.manifold.plugin->type,
                                    end.face < 0 ? HasVertices::kAbility : HasFaces::kAbility,
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
    refuse("windings", "lists images of the target, and a ring has none: give other first rings (family.initializers)");
  else if (config.family.windings > 0 && config.manifold && !config.manifold.provides<HasSeams>())
    refuse("windings", "needs a manifold with a chart with seams");
  if (config.family.bows > 0 && config.ring)
    refuse("bows", "bows the line between two ends, and a ring has none: give other first rings (family.initializers)");
  if (config.family.routes > 1 && config.ring)
    refuse("routes",
           "lists routes between two ends, and a ring has none: give other first rings (family.initializers)");
  else if (config.family.routes > 1 && config.manifold && !config.manifold.provides<HasGraph>())
    refuse("routes", "needs a manifold with a graph: a mesh or a point cloud");
  if (config.family.mirrored && config.ring)
    refuse("mirrored", "mirrors a path at its ends, and a ring has none: give other first rings (family.initializers)");
  if (!config.ring) return;
  for (const PluginChoice& choice : config.family.initializers.choices)
    if (choice && !choice.provides<MakesRings>())
      loaded.errors.error(place_of(loaded.tree, choice.path),
                          fmt::format("'{}' joins two ends and a ring has none: use {}", choice.plugin->type,
                                      ring_initializers(config.manifold)));
}

void check_ring(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  if (!config.ring) return;
  if (!config.initializer) {
    if (loaded.tree.find("initializer") == nullptr)
      loaded.errors.error(
          place_of(loaded.tree, "path.ring"),
          "a ring has no ends to start from: it needs an initializer: " + ring_initializers(config.manifold));
  } else if (!config.initializer.provides<MakesRings>()) {
    loaded.errors.error(place_of(loaded.tree, "initializer"),
                        fmt::format("'{}' joins two ends and a ring has none: use {}", config.initializer.plugin->type,
                                    ring_initializers(config.manifold)));
  }
}

void check_points(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  const Place place = place_of(loaded.tree, "path.points");
  constexpr int kFewestInRing = 3;
  if (config.ring && !config.points.automatic && config.points.count < kFewestInRing)
    loaded.errors.error(place, fmt::format("a ring needs at least {} points", kFewestInRing));
  if (!config.points.automatic || !config.manifold || config.manifold.provides<HasGraph>()) return;
  loaded.errors.error(
      place, fmt::format("'auto' takes the number of points from the first path along edges, and '{}' has none: "
                         "give a number",
                         config.manifold.plugin->type));
}

void check_name(LoadedConfig& loaded) {
  const std::string fault = name_fault(loaded.config.name);
  if (!fault.empty()) loaded.errors.error(place_of(loaded.tree, "name"), fault);
}

/// The program does not act on it; the tests do.
void check_expected_exit(LoadedConfig& loaded) {
  const ConfigEntry* note = loaded.tree.find("x-expect-exit");
  if (note == nullptr) return;
  constexpr std::array<int, 7> kCodes = {0, 1, 3, 4, 5, 6, 130};
  const Parsed<int> code = parse_int(note->value);
  if (code.value && std::count(kCodes.begin(), kCodes.end(), *code.value) > 0) return;
  loaded.errors.error(note->value.place, "'x-expect-exit' must be an exit code of a run: 0, 1, 3, 4, 5, 6 or 130 (" +
                                             found(note->value) + ")");
}

}  // namespace

std::string name_fault(const std::string& name) {
  const bool harmless = std::none_of(name.begin(), name.end(), [](char c) {
    return c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
  constexpr std::size_t kLongestName = 200;  // file systems stop at 255 bytes
  if (harmless && !name.empty() && name[0] != '.' && name.size() <= kLongestName) return "";
  return "'name' becomes a folder: it must not be empty, begin with a dot, contain a slash or a control character, "
         "or be longer than 200 bytes";
}

void check_and_complete(LoadedConfig& loaded) {
  complete(loaded.config);
  check_name(loaded);
  check_expected_exit(loaded);
  check_ends(loaded);
  check_ring(loaded);
  check_family(loaded);
  check_points(loaded);
  check_needs(loaded, loaded.config.initializer);
  check_needs(loaded, loaded.config.solver);
  for (const PluginChoice& choice : loaded.config.family.initializers.choices) check_needs(loaded, choice);
  for (const PluginChoice& choice : loaded.config.post_process.choices) check_needs(loaded, choice);
}

}  // namespace leastcost
