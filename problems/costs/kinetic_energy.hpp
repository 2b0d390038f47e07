// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/problems/robots/arm_models.hpp>

namespace leastcost {

/// Arms whose links have a mass. Lengths in m, masses in kg.
namespace arm_inertia {

struct Panda {
  static constexpr std::string_view kType = "panda";
  static constexpr std::string_view kHelp = "Franka Emika Panda without its gripper, 7 joints.";
};

struct Ur5 {
  static constexpr std::string_view kType = "ur5";
  static constexpr std::string_view kHelp = "Universal Robots UR5 without a tool, 6 joints.";
};

/// A user's own.
struct Table {
  static constexpr std::string_view kType = "table";
  static constexpr std::string_view kHelp =
      "A Denavit-Hartenberg table of revolute joints, with the masses of the links.";
  DhConvention convention = DhConvention::standard;
  Eigen::MatrixXd rows = {};
  Eigen::MatrixXd links = {};
  void fields(FieldVisitor& visit);
};

}  // namespace arm_inertia

struct KineticEnergyOptions {
  std::variant<arm_inertia::Panda, arm_inertia::Ur5, arm_inertia::Table> model = {};
  void fields(FieldVisitor& visit);
};

/// Length under the metric of an arm's kinetic energy: c(a, b) = sqrt(d' M(m) d), d = b - a, m = (a + b) / 2, where
/// q' M(x) q is twice the kinetic energy of the links in configuration x as the joints move at rates q. What is
/// shortest is how the arm moves by itself, without gravity and friction (Bullo, Lewis, Geometric Control of Mechanical
/// Systems, 2005, Sec. 4.3). Of order 2 in the length of a move. Motors and gears, whose inertia is no part of the
/// tables, are not there. Throws OptionError.
std::shared_ptr<const SegmentCost> make_kinetic_energy_cost(const KineticEnergyOptions& options, int dim);

}  // namespace leastcost
