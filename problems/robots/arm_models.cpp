// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/arm_models.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr double kTurn = 2 * std::numbers::pi, kQuarter = std::numbers::pi / 2;

struct ArmModel {
  DhTable table;
  Robot shape;  ///< without its kinematics
};

/// Every capsule of one list of links against every one of another.
void keep_apart(Robot& robot, const std::vector<int>& links, const std::vector<int>& others) {
  const auto among = [](int link, const std::vector<int>& all) {
    return std::find(all.begin(), all.end(), link) != all.end();
  };
  for (int i = 0; i < static_cast<int>(robot.capsules.size()); ++i)
    for (int j = 0; j < static_cast<int>(robot.capsules.size()); ++j)
      if (among(robot.capsules[static_cast<std::size_t>(i)].link, links) &&
          among(robot.capsules[static_cast<std::size_t>(j)].link, others))
        robot.self.emplace_back(i, j);
}

/// Table and limits: Franka Emika, "Robot and interface specifications: Denavit-Hartenberg parameters" and "Limits for
/// Panda" (frankaemika.github.io/docs/control_parameters.html); the flange belongs to the last row. Capsules: fitted to
/// the meshes of franka_description (`tests/problems/arm_shapes_test.cpp`).
ArmModel panda() {
  ArmModel arm;
  DhTable& table = arm.table;
  table.convention = DhConvention::modified;
  table.rows.resize(7, 4);
  table.rows << 0, 0, 0.333, 0,      //
      0, -kQuarter, 0, 0,            //
      0, kQuarter, 0.316, 0,         //
      0.0825, kQuarter, 0, 0,        //
      -0.0825, -kQuarter, 0.384, 0,  //
      0, kQuarter, 0, 0,             //
      0.088, kQuarter, 0.107, 0;
  table.lower.resize(7);
  table.upper.resize(7);
  table.lower << -2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973;
  table.upper << 2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973;
  // Each holds every corner of a mesh, so all of it: links 0 to 6; link 7, the hand and the fingers, open to 40 mm.
  arm.shape.capsules = {
      {0, Vector3d(-0.0565, -0.0001, 0.0137), Vector3d(-0.0007, 0, 0.0518), 0.1046},
      {1, Vector3d(0, -0.0536, 0.0019), Vector3d(0.0002, -0.0012, -0.141), 0.0762},
      {2, Vector3d(0, 0.0001, 0.0532), Vector3d(-0.0013, -0.1477, 0.0053), 0.0766},
      {3, Vector3d(0.0008, 0.0002, -0.0805), Vector3d(0.0829, 0.0426, 0.0004), 0.0694},
      {4, Vector3d(0, -0.0001, 0.0424), Vector3d(-0.0813, 0.0836, 0.0005), 0.0696},
      {5, Vector3d(0.0001, 0.0104, -0.2438), Vector3d(0, 0.0639, 0.003), 0.0675},
      {6, Vector3d(0.0873, 0.009, -0.0002), Vector3d(0.0235, 0.0054, 0.0057), 0.0754},
      {7, Vector3d(0.033, 0.033, -0.0264), Vector3d(-0.0051, -0.0051, -0.0337), 0.0495},
      {7, Vector3d(0.0437, 0.0438, 0.03), Vector3d(-0.054, -0.0539, 0.0213), 0.0493},
      {7, Vector3d(0.0406, 0.0406, 0.084), Vector3d(-0.0407, -0.0406, 0.084), 0.0291},
  };
  arm.shape.whose = "capsules that cover the collision meshes of franka_description, fingers open to 40 mm each";
  arm.shape.unit = "m";
  keep_apart(arm.shape, {0, 1, 2}, {5, 6, 7});
  keep_apart(arm.shape, {3}, {7});
  return arm;
}

/// Table: Universal Robots, "DH parameters for calculations of kinematics and dynamics"; limits: its data sheet, +-360
/// degrees. Capsules: fitted to the meshes of ur_description (`tests/problems/arm_shapes_test.cpp`).
ArmModel ur5() {
  ArmModel arm;
  DhTable& table = arm.table;
  table.rows.resize(6, 4);
  table.rows << 0, kQuarter, 0.089159, 0,  //
      -0.425, 0, 0, 0,                     //
      -0.39225, 0, 0, 0,                   //
      0, kQuarter, 0.10915, 0,             //
      0, -kQuarter, 0.09465, 0,            //
      0, 0, 0.0823, 0;
  table.lower = Eigen::VectorXd::Constant(6, -kTurn);
  table.upper = Eigen::VectorXd::Constant(6, kTurn);
  // Each holds every corner of the mesh of its link.
  arm.shape.capsules = {
      {0, Vector3d(-0.0002, 0.0361, 0.0056), Vector3d(0, -0.0001, 0.0055), 0.0742},
      {1, Vector3d(0.0001, -0.0001, 0.0133), Vector3d(0.0007, -0.0091, 0.0008), 0.0818},
      {2, Vector3d(0.4252, 0.0003, 0.131), Vector3d(0, 0.0003, 0.1308), 0.0842},
      {3, Vector3d(0.393, -0.0002, 0.0444), Vector3d(0.0041, 0.0015, 0.0156), 0.0642},
      {4, Vector3d(-0.0003, -0.0039, -0.0094), Vector3d(0.0004, -0.0023, 0.0073), 0.0567},
      {5, Vector3d(0, 0.0016, 0.0064), Vector3d(-0.0003, 0.0039, -0.0083), 0.057},
      {6, Vector3d(0, 0.0001, -0.0212), Vector3d(0.0001, -0.0032, -0.0209), 0.0401},
  };
  arm.shape.whose = "capsules that cover the collision meshes of ur_description, without a tool";
  arm.shape.unit = "m";
  keep_apart(arm.shape, {0, 1}, {3, 4, 5, 6});
  keep_apart(arm.shape, {2}, {4, 5, 6});
  keep_apart(arm.shape, {3}, {6});
  return arm;
}

ArmModel model_of(const arm_model::Panda&) { return panda(); }
ArmModel model_of(const arm_model::Ur5&) { return ur5(); }

ArmModel model_of(const arm_model::Table& given) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  ArmModel arm;
  arm.table.convention = given.convention;
  arm.table.rows = given.rows;
  arm.table.lower = given.lower.value_or(Eigen::VectorXd::Constant(given.rows.rows(), -kNone));
  arm.table.upper = given.upper.value_or(Eigen::VectorXd::Constant(given.rows.rows(), kNone));
  arm.shape.whose = "the capsules of the configuration";
  const auto whole = [](double x) { return std::isfinite(x) && std::abs(x) < 1e6 && x == std::floor(x); };
  if (given.shape.rows() == 0 || given.shape.cols() != 8)
    throw OptionError("shape", "must be rows of 8 numbers: the link, both ends of a segment and a radius");
  for (const auto& row : given.shape.rowwise()) {
    if (!whole(row[0])) throw OptionError("shape", "must begin with a link number in every row");
    arm.shape.capsules.push_back(
        {static_cast<int>(row[0]), row.segment<3>(1).transpose(), row.segment<3>(4).transpose(), row[7]});
  }
  if (!given.self) return arm;
  if (given.self->cols() != 2) throw OptionError("self", "must be rows of two capsule numbers");
  for (const auto& row : given.self->rowwise()) {
    if (!whole(row[0]) || !whole(row[1])) throw OptionError("self", "must be rows of two capsule numbers");
    arm.shape.self.emplace_back(static_cast<int>(row[0]), static_cast<int>(row[1]));
  }
  return arm;
}

std::shared_ptr<const Robot> made(ArmModel arm, const Vector3d& base) {
  arm.table.base = base;
  arm.shape.kinematics = std::make_shared<const DhArm>(std::move(arm.table));
  return make_robot(std::move(arm.shape));
}

}  // namespace

void arm_model::Table::fields(FieldVisitor& visit) {
  visit.choice("convention", convention,
               {.help = "standard: joint i turns about z of frame i - 1; modified (Craig): about z of frame i."});
  visit.field("rows", rows, {.help = "One row per joint: [a, alpha, d, offset of the angle].", .required = true});
  visit.field("lower", lower, {.help = "Smallest angle of each joint; default: no limit.", .unit = "rad"});
  visit.field("upper", upper, {.help = "Largest angle of each joint; default: no limit.", .unit = "rad"});
  visit.field(
      "shape", shape,
      {.help = "Capsules [link, x1, y1, z1, x2, y2, z2, radius] in the frame of their link; link 0 is the base, "
               "link i has the frame of row i.",
       .unit = "length",
       .required = true});
  visit.field("self", self,
              {.help = "Pairs of capsules that must not touch each other, by number from 0; default: none."});
}

void DhArmOptions::fields(FieldVisitor& visit) {
  visit.variant("model", model, {.help = "The arm: a named model, or a table."});
  visit.field("base", base, {.help = "Position of the base; the z axis of its frame points up.", .unit = "length"});
}

DhTable joints_of(const ArmModelOptions& model) {
  return std::visit([](const auto& chosen) { return model_of(chosen); }, model).table;
}

std::shared_ptr<const Robot> make_dh_arm(const DhArmOptions& options) {
  if (options.base.size() != 3 || !options.base.allFinite())
    throw OptionError("base", "must be a point in space, with finite coordinates");
  try {
    return made(std::visit([](const auto& model) { return model_of(model); }, options.model), options.base);
  } catch (const OptionError& error) {
    throw error.under("model");
  }
}

}  // namespace leastcost
