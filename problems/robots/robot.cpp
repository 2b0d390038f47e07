// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/robot.hpp>

#include <cmath>
#include <string>

#include <leastcost/framework/errors.hpp>

namespace leastcost {
namespace {

void check_capsule(const Robot& robot, std::size_t i) {
  const Capsule& capsule = robot.capsules[i];
  const auto refuse = [i](const std::string& why) {
    throw OptionError("shape", "capsule " + std::to_string(i) + " " + why);
  };
  if (capsule.link < 0 || capsule.link >= robot.kinematics->link_count())
    refuse("is on link " + std::to_string(capsule.link) + "; the links are numbered from 0 to " +
           std::to_string(robot.kinematics->link_count() - 1));
  if (!capsule.from.allFinite() || !capsule.to.allFinite()) refuse("must have finite coordinates");
  if (!(capsule.radius > 0) || !std::isfinite(capsule.radius)) refuse("must have a radius greater than 0");
}

void check_pair(const Robot& robot, std::size_t k) {
  const auto [i, j] = robot.self[k];
  const auto refuse = [k](const std::string& why) {
    throw OptionError("self", "pair " + std::to_string(k) + " " + why);
  };
  const int count = static_cast<int>(robot.capsules.size());
  if (i < 0 || j < 0 || i >= count || j >= count)
    refuse("names a capsule that is not there; they are numbered from 0 to " + std::to_string(count - 1));
  if (robot.capsules[static_cast<std::size_t>(i)].link == robot.capsules[static_cast<std::size_t>(j)].link)
    refuse("names two capsules of one link, which cannot move against each other");
}

}  // namespace

std::shared_ptr<const Robot> make_robot(Robot robot) {
  if (robot.capsules.empty()) throw OptionError("shape", "must have at least one capsule");
  for (std::size_t i = 0; i < robot.capsules.size(); ++i) check_capsule(robot, i);
  for (std::size_t k = 0; k < robot.self.size(); ++k) check_pair(robot, k);
  return std::make_shared<const Robot>(std::move(robot));
}

}  // namespace leastcost
