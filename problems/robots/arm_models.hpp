// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>

#include <leastcost/framework/options.hpp>
#include <leastcost/problems/robots/dh_arm.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

/// Arms by name. Lengths in m. Their tables are those that their makers publish; their capsules are our own, drawn
/// generously around the links from the main dimensions of the arms: they are no measured shapes, and an application
/// that goes near needs its own (a table with capsules).
namespace arm_model {

/// Joint 7 carries the flange and a gripper of the usual size.
struct Panda {
  static constexpr std::string_view kType = "panda";
  static constexpr std::string_view kHelp = "Franka Emika Panda with its gripper, 7 joints.";
};

struct Ur5 {
  static constexpr std::string_view kType = "ur5";
  static constexpr std::string_view kHelp = "Universal Robots UR5 without a tool, 6 joints.";
};

/// A user's own.
struct Table {
  static constexpr std::string_view kType = "table";
  static constexpr std::string_view kHelp =
      "A Denavit-Hartenberg table of joints that turn, with capsules on its links.";
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
