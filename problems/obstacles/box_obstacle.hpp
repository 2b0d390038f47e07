// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include <leastcost/problems/obstacles/obstacle.hpp>

namespace leastcost {

/// A box with sides along the axes, in the plane a rectangle. Its corners are sharp: it asks for a clearance.
struct BoxObstacleOptions {
  Eigen::VectorXd lower = {};  ///< corner with the least coordinates
  Eigen::VectorXd upper = {};  ///< corner with the greatest coordinates
};

/// What a box is called in messages, and whether pictures show it.
struct BoxLook {
  std::string name = "the box";  ///< in messages
  bool drawn = true;             ///< whether pictures show it
  bool with_place = true;        ///< where it is follows its name
};

/// Throws OptionError where the corners do not fit or the box is empty.
std::shared_ptr<const Obstacle> make_box_obstacle(const BoxObstacleOptions& options, const BoxLook& look = {});

}  // namespace leastcost
