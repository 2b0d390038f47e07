// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/config/raster_reading.hpp"

#include <utility>

#include <leastcost/problems/costs/cost_map.hpp>
#include "catalogue/config/choice_options.hpp"
#include "catalogue/plugins/external_plugin.hpp"
#include "problems/cells/has_cost_cells.hpp"

namespace leastcost {
namespace {

/// How a raster of costs is read; null: the cost is another one.
CostMapInterpolation* interpolation_of(const RunConfig& config) {
  if (!is_type(config.cost, {"cost_map"}) || !config.cost.options) return nullptr;
  return &static_cast<OptionsOf<CostMapOptions>&>(*config.cost.options).value.interpolation;
}

/// Whether something is asked for that needs a smooth cost, or obstacles where there are no data.
bool asks_for_smooth(const RunConfig& config) { return config.solver || config.post_process || config.clearance > 0; }

}  // namespace

bool is_free(const RunConfig& config) {
  return !config.ring && !config.robot && config.obstacles.empty() && is_flat(config.manifold);
}

bool reads_cells(const RunConfig& config) {
  if (const auto* cost = external_object<SegmentCost>(config.cost)) return find_ability<HasCostCells>(*cost) != nullptr;
  const auto* interpolation = interpolation_of(config);
  return interpolation != nullptr && *interpolation == CostMapInterpolation::cells;
}

void choose_interpolation(RunConfig& config) {
  auto* interpolation = interpolation_of(config);
  if (interpolation == nullptr || *interpolation != CostMapInterpolation::automatic) return;
  const bool cells = is_free(config) && whole_option(config.manifold, "dimension") == 2 && !asks_for_smooth(config);
  *interpolation = cells ? CostMapInterpolation::cells : CostMapInterpolation::smooth;
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

}  // namespace leastcost
