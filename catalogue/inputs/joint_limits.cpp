// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/inputs/joint_limits.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/inputs/scene_block.hpp"
#include "catalogue/yaml/yaml_reader.hpp"
#include "framework/base/point_text.hpp"
#include "problems/readers/file_content.hpp"

namespace leastcost {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// Infinite: the file says none.
struct JointLimit {
  double velocity = kNone, acceleration = kNone;
};

struct JointLimits {
  std::map<std::string, JointLimit> joints;
  double velocity_factor = 1, acceleration_factor = 1;
  bool positions = false;  ///< whether it limits positions, too
};

double limit_of(SceneBlock& block, const char* has, const char* most) {
  const bool given = block.flag(has, false);
  const double value = block.number(most, given ? std::nullopt : std::optional<double>(0));
  if (!given) return kNone;
  if (block.has(most) && !(value > 0)) block.fault(most, "must be greater than 0");
  return value > 0 ? value : kNone;
}

double factor_of(SceneBlock& block, const char* key) {
  const double factor = block.number(key, 1.0);
  if (factor > 0 && factor <= 1) return factor;
  block.fault(key, "must be greater than 0 and at most 1");
  return 1;
}

JointLimits read_limits(const ConfigNode& tree, Diagnostics& errors) {
  JointLimits limits;
  const ConfigEntry* outer = tree.find("robot_description_planning");  // as parameters of ROS 2 have it
  SceneBlock root(outer != nullptr ? outer->value : tree, "the file of joint limits", errors);
  limits.velocity_factor = factor_of(root, "default_velocity_scaling_factor");
  limits.acceleration_factor = factor_of(root, "default_acceleration_scaling_factor");
  const ConfigNode* joints = root.required("joint_limits");
  if (joints == nullptr) return limits;
  SceneBlock all(*joints, "'joint_limits'", errors);
  for (const ConfigEntry& entry : joints->entries) {
    SceneBlock joint(entry.value, "the joint " + in_quotes(entry.key), errors);
    if (!entry.value.is_block()) continue;
    limits.joints[entry.key] = {limit_of(joint, "has_velocity_limits", "max_velocity"),
                                limit_of(joint, "has_acceleration_limits", "max_acceleration")};
    limits.positions = joint.flag("has_position_limits", false) || limits.positions;
    for (const char* other : {"min_position", "max_position", "has_jerk_limits", "max_jerk", "has_deceleration_limits",
                              "max_deceleration", "has_effort_limits", "max_effort", "angle_wraparound"})
      joint.find(other);
    joint.finish();
  }
  root.finish();
  return limits;
}

std::string named(const std::vector<std::string>& joints) {
  std::string list;
  for (const std::string& joint : joints) list += (list.empty() ? "" : ", ") + joint;
  return list;
}

}  // namespace

TrajectoryOptions with_joint_limits(const std::filesystem::path& file, const Robot& robot, TrajectoryOptions options,
                                    const std::function<void(std::string)>& note) {
  if (robot.joints.empty())
    throw OptionError("limits",
                      "has limits by the names of joints, and the joints of this robot have none: give "
                      "'velocity' and 'acceleration'");
  const std::string text = read_content(file);
  Diagnostics errors(file.string(), text);
  const ConfigNode tree = read_yaml(text, errors);
  const JointLimits limits = errors.empty() ? read_limits(tree, errors) : JointLimits{};
  if (!errors.empty()) throw InputError(errors.render() + errors.count());
  const auto count = static_cast<Eigen::Index>(robot.joints.size());
  Eigen::VectorXd velocity = robot.velocity.size() > 0 ? robot.velocity : Eigen::VectorXd::Constant(count, kNone),
                  acceleration = Eigen::VectorXd::Constant(count, kNone);
  bool any = false;
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto found = limits.joints.find(robot.joints[static_cast<std::size_t>(i)]);
    if (found == limits.joints.end()) continue;
    any = true;
    if (std::isfinite(found->second.velocity)) velocity[i] = found->second.velocity;
    acceleration[i] = found->second.acceleration;
  }
  const std::string name = file.filename().string();
  if (!any) throw OptionError("limits", name + " has none of the robot's joints, which are " + named(robot.joints));
  const auto take = [&](const char* key, std::optional<Eigen::VectorXd>& given, const Eigen::VectorXd& read,
                        double factor, const std::string& what) {
    if (given) return;
    for (Eigen::Index i = 0; i < count; ++i)
      if (!std::isfinite(read[i]))
        throw OptionError(key,
                          fmt::format("is needed: {} for the joint '{}' (has_{}_limits: true, max_{}: ..); or give "
                                      "one number for all joints, or a list with one for each",
                                      what, robot.joints[static_cast<std::size_t>(i)], key, key));
    given = factor * read;
    if (factor < 1 && note)
      note(fmt::format("limits of {} are {} of those in {}, by its default_{}_scaling_factor", key,
                       short_number(factor, 9), name, key));
  };
  take("velocity", options.velocity, velocity, limits.velocity_factor, name + " and the robot's file have none");
  take("acceleration", options.acceleration, acceleration, limits.acceleration_factor, name + " has none");
  if (limits.positions && note) note("limits of positions in " + name + " are ignored; the URDF's are used");
  return options;
}

}  // namespace leastcost
