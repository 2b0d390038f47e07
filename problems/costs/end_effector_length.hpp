// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string_view>
#include <variant>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/problems/robots/arm_models.hpp>

namespace leastcost {

namespace arm_joints {

/// A user's own.
struct Table {
  static constexpr std::string_view kType = "table";
  static constexpr std::string_view kHelp = "A Denavit-Hartenberg table of revolute joints.";
  DhConvention convention = DhConvention::standard;
  Eigen::MatrixXd rows = {};
  void fields(FieldVisitor& visit);
};

}  // namespace arm_joints

struct EndEffectorLengthOptions {
  std::variant<arm_model::Panda, arm_model::Ur5, arm_joints::Table> model = {};
  Eigen::VectorXd tool = Eigen::Vector3d::Zero();  ///< in the frame of the last row
  double joint_weight = 0.05;                      ///< length units per rad, greater than 0
  void fields(FieldVisitor& visit);
};

/// c(a, b) = sqrt(|p(b) - p(a)|^2 + w^2 |b - a|^2), p being where the tool is: the length of the tool's way through
/// space, and w times that of the joints. Without the weight w a motion that leaves the tool where it is would cost
/// nothing, and no path would be the only cheapest one; the smaller it is, the more the path is that of the tool alone.
/// It is a chord in the space of tool places and weighted angles, hence of order 2 and never above the curve's cost.
/// Throws OptionError.
std::shared_ptr<const SegmentCost> make_end_effector_length(const EndEffectorLengthOptions& options, int dim);

}  // namespace leastcost
