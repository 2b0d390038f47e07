// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/voids.hpp"

#include <algorithm>

#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/problems/obstacles/has_walls.hpp>
#include <leastcost/problems/obstacles/raster_obstacles.hpp>
#include "catalogue/config/choice_options.hpp"
#include "catalogue/config/config_facts.hpp"
#include "catalogue/plugins/external_plugin.hpp"
#include "problems/raster/raster_patches.hpp"

namespace leastcost {

void Voids::add(const HasVoids* raster) {
  if (raster == nullptr) return;
  const RasterPatches& patches = raster->known_patches();
  const FreeSpace::Obstacles boxes = void_obstacles(patches, false);  // maps show where there are no data
  if (boxes.empty()) return;
  const double side = patches.cell().minCoeff();
  cell = any() ? std::min(cell, side) : side;
  obstacles.insert(obstacles.end(), boxes.begin(), boxes.end());
}

double Voids::clearance(double asked) const {
  constexpr double kOfCell = 0.1;
  return !any() || asked > 0 ? asked : kOfCell * cell;
}

bool takes_voids(const RunConfig& config, const ConstraintManifold& domain) {
  if (config.robot || brackets(config) || find_ability<HasWalls>(domain) != nullptr) return false;
  return std::none_of(config.obstacles.begin(), config.obstacles.end(),
                      [](const PluginChoice& choice) { return choice.plugin->type == "raster"; });
}

bool may_be_map(const PluginChoice& cost) { return is_type(cost, {"cost_map", kExternal}); }

bool straight_is_blocked(const Problem& problem) {
  const Eigen::VectorXd &from = problem.source.u, &to = problem.target.u;
  if (from.size() != 2 || to.size() != 2) return false;
  constexpr int kPlaces = 1000;
  for (int i = 1; i < kPlaces; ++i)
    if (!why_in_clearance(problem, PathEnd{from + (to - from) * i / kPlaces}).empty()) return true;
  return false;
}

}  // namespace leastcost
