// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/robot.hpp>

#include <array>
#include <cmath>
#include <string>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

constexpr double kLargest = 1e75;  ///< of coordinates: beyond it products of them overflow

/// `corners`: of the segment or triangle that the part is around.
template <class Corners>
void check_part(const Robot& robot, const std::string& name, int link, double radius, const Corners& corners) {
  const auto refuse = [&](const std::string& why) { throw OptionError("shape", name + " " + why); };
  if (link < 0 || link >= robot.kinematics->link_count())
    refuse("is on link " + std::to_string(link) + "; links are numbered from 0 to " +
           std::to_string(robot.kinematics->link_count() - 1));
  for (const Eigen::Vector3d& corner : corners)
    if (!(corner.cwiseAbs().maxCoeff() <= kLargest)) refuse("must have finite coordinates, none beyond 1e75");
  if (!(radius > 0 && radius <= kLargest)) refuse("must have a radius greater than 0 and at most 1e75");
}

void check_pair(const Robot& robot, std::size_t k) {
  const auto [i, j] = robot.self[k];
  const auto refuse = [k](const std::string& why) {
    throw OptionError("self", "pair " + std::to_string(k) + " " + why);
  };
  const int count = static_cast<int>(robot.capsules.size());
  if (i < 0 || j < 0 || i >= count || j >= count)
    refuse("names a capsule that does not exist; capsules are numbered from 0 to " + std::to_string(count - 1));
  if (robot.capsules[static_cast<std::size_t>(i)].link == robot.capsules[static_cast<std::size_t>(j)].link)
    refuse("names two capsules of one link, which do not move relative to each other");
}

void check_count(const char* key, std::size_t count, std::size_t wanted, const char* of) {
  if (count != 0 && count != wanted)
    throw OptionError(key, "must have one for each " + std::string(of) + ", or none (" + std::to_string(count) +
                               ", and there are " + std::to_string(wanted) + ")");
}

}  // namespace

std::vector<std::string> frame_names(const Robot& robot) {
  std::vector<std::string> names;
  for (const auto& [name, frame] : robot.frames) names.push_back(name);
  if (names.empty())
    for (int link = 0; link < robot.kinematics->link_count(); ++link)
      names.push_back(robot.kinematics->link_name(link));
  return names;
}

NamedFrame find_frame(const Robot& robot, const std::string& name) {
  const Kinematics& kinematics = *robot.kinematics;
  if (name.empty()) return {kinematics.link_count() - 1, {}};
  if (const auto found = robot.frames.find(name); found != robot.frames.end()) return found->second;
  for (int link = 0; link < kinematics.link_count(); ++link)
    if (robot.frames.empty() && kinematics.link_name(link) == name) return {link, {}};
  std::string message = "the robot has no link '" + name + "'; it has: ";
  const char* separator = "";
  for (const std::string& one : frame_names(robot)) {
    message += separator + one;
    separator = ", ";
  }
  throw OptionError("link", message);
}

std::shared_ptr<const Robot> make_robot(Robot robot) {
  if (robot.parts() == 0) throw OptionError("shape", "must have at least one capsule");
  for (std::size_t i = 0; i < robot.capsules.size(); ++i) {
    const Capsule& capsule = robot.capsules[i];
    check_part(robot, "capsule " + std::to_string(i), capsule.link, capsule.radius,
               std::array{capsule.from, capsule.to});
  }
  if (!robot.plates.empty() && robot.kinematics->space() != 3)
    throw OptionError("shape", "triangles need a robot in space, but this one is in the plane");
  for (std::size_t i = 0; i < robot.plates.size(); ++i) {
    const Plate& plate = robot.plates[i];
    check_part(robot, "triangle " + std::to_string(i), plate.link, plate.radius, plate.corners);
  }
  for (std::size_t k = 0; k < robot.self.size(); ++k) check_pair(robot, k);
  const auto dimension = static_cast<std::size_t>(robot.kinematics->dimension());
  check_count("owners", robot.owners.size(), robot.capsules.size(), "capsule");
  check_count("joints", robot.joints.size(), dimension, "coordinate");
  check_count("velocity", static_cast<std::size_t>(robot.velocity.size()), dimension, "coordinate");
  return std::make_shared<const Robot>(std::move(robot));
}

}  // namespace leastcost
