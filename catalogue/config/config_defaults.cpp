// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/config/config_defaults.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/initializers/eikonal.hpp>
#include <leastcost/recipes/facts.hpp>
#include "catalogue/config/choice_options.hpp"
#include "catalogue/config/config_facts.hpp"
#include "catalogue/config/raster_reading.hpp"
#include "catalogue/plugins/external_plugin.hpp"
#include "catalogue/plugins/kinds.hpp"
#include "catalogue/registry/registry.hpp"

namespace leastcost {
namespace {

constexpr const char* kDefaultCost = "euclidean";

PluginChoice default_plugin(const char* kind_name, const char* type, const std::string& path) {
  return choose(*find_plugin(kind(kind_name), type), path);
}

/// The default of a path that is only straightened, and proved: its class is then more often that of the shortest.
void go_over_diagonals(PluginChoice& dijkstra) {
  static_cast<OptionsOf<DijkstraOptions>&>(*dijkstra.options).value.diagonals = true;
}

void fall_back(PluginChoice& eikonal) {
  static_cast<OptionsOf<EikonalOptions>&>(*eikonal.options).value.fallback = true;
}

/// The domain that a configuration names; null where it describes one.
const ConstraintManifold* object_at(const ConfigNode& tree, std::string_view key, const Externals& externals) {
  const ConfigNode* type = node_at(tree, std::string(key) + ".type");
  const ConfigNode* name = node_at(tree, std::string(key) + ".name");
  if (type == nullptr || name == nullptr || type->text != kExternal) return nullptr;
  const auto found = externals.find(name->text);
  if (found == externals.end()) return nullptr;
  const auto* domain = std::get_if<std::shared_ptr<const ConstraintManifold>>(&found->second);
  return domain == nullptr ? nullptr : domain->get();
}

/// How many points a robot needs depends on how thin its parts are and how far they go: not a number for all of them.
void count_points_of_robot(ConfigNode& tree) {
  const ConfigEntry* robot = tree.find("robot");
  const ConfigNode* ring = node_at(tree, "path.ring");
  if (robot == nullptr || node_at(tree, "path.points") != nullptr || (ring != nullptr && ring->text == "true")) return;
  const Place place = robot->place;
  if (tree.find("path") == nullptr) {
    ConfigNode block;
    block.kind = ConfigNode::Kind::block;
    block.place = place;
    tree.entries.push_back({"path", place, block});
  }
  ConfigNode& path = tree.find("path")->value;
  if (path.is_block()) path.entries.push_back({"points", place, scalar_node("auto")});
}

/// A space has as many dimensions as its box.
void take_dimension_of_box(ConfigNode& tree) {
  ConfigEntry* manifold = tree.find("manifold");
  const ConfigNode* type = node_at(tree, "manifold.type");
  if (manifold == nullptr || type == nullptr || type->text != "euclidean" ||
      node_at(tree, "manifold.dimension") != nullptr)
    return;
  for (const char* side : {"manifold.lower", "manifold.upper"}) {
    const ConfigNode* numbers = node_at(tree, side);
    if (numbers == nullptr || !numbers->is_list() || numbers->items.empty()) continue;
    manifold->value.entries.push_back(
        {"dimension", manifold->place, scalar_node(std::to_string(numbers->items.size()))});
    manifold->value.entries.back().value.place = numbers->place;
    return;
  }
}

}  // namespace

void fill_defaults(RunConfig& config) {
  if (!config.cost) config.cost = default_plugin("cost", kDefaultCost, "cost");
  choose_interpolation(config);
  const bool default_first = !config.initializer, default_steps = !config.post_process;
  const ProblemFacts facts = facts_of(config);
  const auto fill = [&](const char* part, std::string_view type, PluginChoice& choice) {
    if (!choice && !type.empty()) choice = default_plugin(part, std::string(type).c_str(), part);
  };
  fill("kernel", "expm1_square", config.kernel);
  fill("initializer", word_of(recommended_first_path(facts)), config.initializer);
  if (default_first && is_type(config.initializer, {"eikonal"})) fall_back(config.initializer);
  const bool exact = default_steps && (makes_exact_curves(facts) || proves_shortest(config));
  if (exact && !config.solver && default_first && facts.mesh && !facts.occupancy) go_over_diagonals(config.initializer);
  fill("solver", word_of(recommended_solver(facts, exact)), config.solver);
  if (!default_steps) return;
  PluginList& steps = config.post_process.emplace();
  for (const CurveMethod method : recommended_curve(facts))
    steps.push_back(default_plugin("post_processor", std::string(word_of(method)).c_str(),
                                   "post_process." + std::to_string(steps.size())));
}

void complete_types(ConfigNode& tree, const Externals& externals) {
  count_points_of_robot(tree);
  take_dimension_of_box(tree);
  const auto text_at = [&](std::string_view path) {
    const ConfigNode* node = node_at(tree, path);
    return node != nullptr && node->is_scalar() ? node->text : std::string();
  };
  const std::string type = text_at("manifold");
  const PluginEntry* manifold = find_plugin(kind("manifold"), type.empty() ? text_at("manifold.type") : type);
  const ConstraintManifold* object = object_at(tree, "manifold", externals);
  if (manifold == nullptr && object == nullptr) return;  // an error of its own
  const std::string cost = tree.find("cost") == nullptr ? kDefaultCost : text_at("cost"),
                    cost_type = cost.empty() ? text_at("cost.type") : cost;
  const ConfigNode* point = node_at(tree, "ends.source.point");
  if (point == nullptr) point = node_at(tree, "ends.source.lonlat");
  const std::string interpolation = text_at("cost.interpolation");
  const bool by_default = (interpolation.empty() || interpolation == "auto") && tree.find("solver") == nullptr &&
                          tree.find("post_process") == nullptr && tree.find("clearance") == nullptr;
  ProblemFacts facts = facts_of_types(manifold, cost_type);
  if (object != nullptr) add_facts(*object, facts);
  facts.ring = text_at("path.ring") == "true";
  facts.obstacles = facts.obstacles || tree.find("obstacles") != nullptr;
  facts.robot = facts.robot || tree.find("robot") != nullptr;
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

}  // namespace leastcost
