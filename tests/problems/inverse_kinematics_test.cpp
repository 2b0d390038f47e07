// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/inverse_kinematics.hpp>

#include <Eigen/Geometry>
#include <random>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/dh_arm.hpp>
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

const auto kAnything = [](const VectorXd&) { return true; };

VectorXd any_configuration(const Kinematics& robot, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.1, 0.9);
  const VectorXd lower = robot.lower(), upper = robot.upper();
  return VectorXd::NullaryExpr(lower.size(),
                               [&](Eigen::Index j) { return lower[j] + share(random) * (upper[j] - lower[j]); });
}

Frame link_at(const Kinematics& robot, const VectorXd& x, int link) {
  std::vector<Frame> links;
  robot.place(x, links);
  return links[static_cast<std::size_t>(link)];
}

}  // namespace

TEST_CASE("inverse kinematics: poses of two arms that they can take are found, within the limits") {
  const auto robot =
      GENERATE(false, true) ? make_dh_arm({})->kinematics : make_dh_arm({.model = arm_model::Ur5{}})->kinematics;
  const int hand = robot->link_count() - 1;
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Vector3d tool(0.01, -0.02, 0.1);
    const Frame wanted = link_at(*robot, any_configuration(*robot, random), hand);
    const VectorXd near = any_configuration(*robot, random);
    const ToolGoal goal{hand, tool, wanted.at(tool), wanted.rotation};
    const auto found = inverse_kinematics(*robot, goal, near, kAnything);
    REQUIRE_FALSE(found.empty());
    for (std::size_t k = 0; k < found.size(); ++k) {
      const Frame at = link_at(*robot, found[k], hand);
      CHECK((at.at(tool) - goal.position).norm() < 1e-7);
      CHECK((at.rotation - wanted.rotation).norm() < 1e-6);
      CHECK((found[k] - robot->lower()).minCoeff() >= 0);
      CHECK((robot->upper() - found[k]).minCoeff() >= 0);
      if (k > 0) CHECK((found[k] - near).norm() >= (found[k - 1] - near).norm());
    }
  }
}

TEST_CASE("inverse kinematics: a configuration to be near to has the coordinates of the robot") {
  const auto robot = make_dh_arm({})->kinematics;
  CHECK_THROWS_WITH(inverse_kinematics(*robot, {.link = 1}, VectorXd(), kAnything),
                    Catch::Contains("has 7 coordinates, but the one to be near to has 0"));
}

TEST_CASE("inverse kinematics: an arm of two links in the plane has its two elbows, and stays near with one to spare") {
  DhTable table;
  table.rows = Eigen::MatrixXd::Zero(2, 4);
  table.rows.col(0).setOnes();
  table.lower = VectorXd::Constant(2, -3);
  table.upper = VectorXd::Constant(2, 3);
  const DhArm two(table);
  const ToolGoal goal{2, Vector3d::Zero(), Vector3d(1, 1, 0), {}};
  const auto elbows = inverse_kinematics(two, goal, Eigen::Vector2d(0, 1), kAnything);
  REQUIRE(elbows.size() == 2);
  CHECK((elbows[0] - Eigen::Vector2d(0, std::acos(0.0))).norm() < 1e-8);
  CHECK((elbows[1] - Eigen::Vector2d(std::acos(0.0), -std::acos(0.0))).norm() < 1e-8);
  const auto left = inverse_kinematics(two, goal, Eigen::Vector2d(0, 1), [](const VectorXd& x) { return x[1] < 0; });
  REQUIRE(left.size() == 1);
  CHECK(left[0][1] < 0);

  table.rows = Eigen::MatrixXd::Zero(3, 4);
  table.rows.col(0).setOnes();
  table.lower = VectorXd::Constant(3, -3);
  table.upper = VectorXd::Constant(3, 3);
  const DhArm three(table);
  const VectorXd near = Vector3d(0.3, 0.5, 0.4);
  const ToolGoal same{3, Vector3d::Zero(), link_at(three, near, 3).origin + Vector3d(0.01, 0, 0), {}};
  const auto found = inverse_kinematics(three, same, near, kAnything);
  REQUIRE_FALSE(found.empty());
  CHECK((found[0] - near).norm() < 0.05);
}

TEST_CASE("inverse kinematics: what is out of reach is not found, and goals that are none are refused") {
  const auto robot = make_dh_arm({})->kinematics;
  const VectorXd near = (robot->lower() + robot->upper()) / 2;
  CHECK(inverse_kinematics(*robot, {7, Vector3d::Zero(), Vector3d(3, 0, 0), {}}, near, kAnything).empty());
  const auto refused = [&](const ToolGoal& goal, const char* why) {
    CHECK_THROWS_WITH(inverse_kinematics(*robot, goal, near, kAnything), Catch::Contains(why));
  };
  refused({99}, "0 to 7");
  refused({7, Vector3d::Zero(), Vector3d::Constant(std::nan(""))}, "finite");
  refused({7, Vector3d::Zero(), Vector3d::Zero(), 2 * Eigen::Matrix3d::Identity()}, "must be a rotation");
}

}  // namespace leastcost::test
