// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

/// Obstacles, and for each of them its entry in the list of the configuration, for messages. An entry may be several.
struct ListedObstacles {
  FreeSpace::Obstacles all;
  std::vector<std::size_t> entry_of;

  void add(std::shared_ptr<const Obstacle> obstacle, std::size_t entry) {
    all.push_back(std::move(obstacle));
    entry_of.push_back(entry);
  }
};

/// Throws OptionError where the domain of a robot's configurations extends beyond the limits of its joints.
void check_robot_limits(const Robot& robot, const ConstraintManifold& domain);

/// The domain without what obstacles and the clearance around them take: obstacles in it, or, with a `robot` (else
/// null), in the space that it moves in. Throws OptionError for the entry at fault.
std::shared_ptr<const ConstraintManifold> among(ListedObstacles obstacles, double clearance,
                                                const std::shared_ptr<const Robot>& robot,
                                                const std::shared_ptr<const ConstraintManifold>& domain);

}  // namespace leastcost
