// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/walls.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include "framework/base/counted.hpp"
#include "problems/obstacles/walls_in.hpp"

namespace leastcost {
namespace {

/// Which option a fault of the obstacles is one of: their constructor numbers them, `entry_of` is where they come from.
std::string key_of_fault(const std::string& key, const std::vector<std::size_t>& entry_of) {
  if (!std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; })) return key;
  return "obstacles." + std::to_string(entry_of.at(std::stoul(key)));
}

/// What keeps out of a domain: obstacles in it, or those in the workspace of a robot, a configuration of which it is
/// of.
std::shared_ptr<const Walls> walls_of(ListedObstacles obstacles, double clearance,
                                      const std::shared_ptr<const Robot>& robot, const ConstraintManifold& domain) {
  try {
    if (robot != nullptr) return std::make_shared<const RobotWalls>(robot, std::move(obstacles.all), clearance);
    return walls_in(domain, std::move(obstacles.all), clearance);
  } catch (const OptionError& error) {
    throw OptionError(key_of_fault(error.key(), obstacles.entry_of), error.reason());
  }
}

}  // namespace

void check_robot_limits(const Robot& robot, const ConstraintManifold& domain) {
  const Eigen::VectorXd lower = robot.kinematics->lower(), upper = robot.kinematics->upper();
  if (lower.size() != domain.dimensions().ambient)
    throw OptionError("robot", fmt::format("has configurations of {}, but the manifold has points of {}",
                                           counted(lower.size(), "coordinate"), domain.dimensions().ambient));
  if (lower.array().isInf().all() && upper.array().isInf().all()) return;
  const auto* box = find_ability<HasBox>(domain);
  for (Eigen::Index i = 0; i < lower.size(); ++i) {
    if (box != nullptr && box->box_lower()[i] >= lower[i] && box->box_upper()[i] <= upper[i]) continue;
    throw OptionError("robot",
                      fmt::format("coordinate {} has the limits [{:.8g}, {:.8g}], but the manifold extends beyond "
                                  "them: give the manifold lower: [{:.8g}] and upper: [{:.8g}], or tighter bounds",
                                  i, lower[i], upper[i], fmt::join(lower, ", "), fmt::join(upper, ", ")));
  }
}

std::shared_ptr<const ConstraintManifold> among(ListedObstacles obstacles, double clearance,
                                                const std::shared_ptr<const Robot>& robot,
                                                const std::shared_ptr<const ConstraintManifold>& domain) {
  std::shared_ptr<const Walls> walls = walls_of(std::move(obstacles), clearance, robot, *domain);
  try {
    return std::make_shared<const FreeSpace>(domain, std::move(walls));
  } catch (const InputError& error) {
    throw OptionError(robot != nullptr ? "robot" : "obstacles", error.what());
  }
}

}  // namespace leastcost
