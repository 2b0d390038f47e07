// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/methods/offered_methods.hpp"

#include <atomic>

namespace leastcost {
namespace {

// Set before any code runs, whatever the order in which libraries are loaded.
constinit std::atomic<const MeshMethods*> of_mesh{nullptr};
constinit std::atomic<const PlanningMethods*> of_planning{nullptr};
constinit std::atomic<const BoundsMethods*> of_bounds{nullptr};

}  // namespace

const MeshMethods* mesh_methods() { return of_mesh; }
const PlanningMethods* planning_methods() { return of_planning; }
const BoundsMethods* bounds_methods() { return of_bounds; }

bool offer(const MeshMethods& methods) {
  of_mesh = &methods;
  return true;
}

bool offer(const PlanningMethods& methods) {
  of_planning = &methods;
  return true;
}

bool offer(const BoundsMethods& methods) {
  of_bounds = &methods;
  return true;
}

}  // namespace leastcost
