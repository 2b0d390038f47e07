// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/robots/dh_arm.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

/// Arms by name. Lengths in m. Their tables are those that their makers publish. Their capsules cover the collision
/// meshes of the makers' robot descriptions: every corner of a mesh lies in one capsule of its link, so that the whole
/// mesh does, capsules being convex. They are up to 1.9 times as large as the meshes' convex hulls (the UR5's
/// base 5.7).
namespace arm_model {

/// Joint 7 carries the flange and a gripper of the usual size.
struct Panda {
  static constexpr std::string_view kType = "panda";
  static constexpr std::string_view kHelp =
      "Franka Emika Panda with its gripper, 7 joints. Its capsules cover the collision meshes of franka_description, "
      "fingers open to 40 mm each.";
};

struct Ur5 {
  static constexpr std::string_view kType = "ur5";
  static constexpr std::string_view kHelp =
      "Universal Robots UR5 without a tool, 6 joints. Its capsules cover the collision meshes of ur_description.";
};

/// A user's own.
struct Table {
  static constexpr std::string_view kType = "table";
  static constexpr std::string_view kHelp =
      "A Denavit-Hartenberg table of revolute joints, with capsules on the links.";
  DhConvention convention = DhConvention::standard;
  Eigen::MatrixXd rows = {};
  std::optional<Eigen::VectorXd> lower = {}, upper = {};
  Eigen::MatrixXd shape = {};
  std::optional<Eigen::MatrixXd> self = {};
  void fields(FieldVisitor& visit);
};

}  // namespace arm_model

struct DhArmOptions {
  std::variant<arm_model::Panda, arm_model::Ur5, arm_model::Table> model = {};
  Eigen::VectorXd base = Eigen::Vector3d::Zero();
  void fields(FieldVisitor& visit);
};

using ArmModelOptions = std::variant<arm_model::Panda, arm_model::Ur5, arm_model::Table>;

/// The joints alone. Throws OptionError, without "model." in front of its key, for shapes too.
DhTable joints_of(const ArmModelOptions& model);

/// Throws OptionError.
std::shared_ptr<const Robot> make_dh_arm(const DhArmOptions& options);

}  // namespace leastcost
