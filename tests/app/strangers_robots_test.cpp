// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Robots as their owners bring them: a URDF, perhaps an SRDF, and some ten lines of configuration. What is certified is
// looked at again by kinematics that are written down here.
#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include <leastcost/catalogue/catalogue.hpp>
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;
using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

std::filesystem::path strangers_folder() { return project_dir() / "tests/app/robots"; }

Result solved(const std::string& text) { return solve(parse_run(text, "a.yaml", strangers_folder())).result; }

/// The least value at places along a path.
template <class Value>
double least_value_along(const Points& path, const Value& value) {
  constexpr int kPlaces = 8;
  double least = value(VectorXd(path.col(0)));
  for (Eigen::Index i = 0; i + 1 < path.cols(); ++i)
    for (int k = 1; k <= kPlaces; ++k)
      least = std::min(least, value(VectorXd(path.col(i) + (path.col(i + 1) - path.col(i)) * k / kPlaces)));
  return least;
}

Isometry3d turned_by(double angle, const Vector3d& axis) { return Isometry3d(AngleAxisd(angle, axis)); }
Isometry3d moved_by(double x, double y, double z) { return Isometry3d(Translation3d(x, y, z)); }

/// The frame of the gripper of mobile_manipulator.urdf, its torso and arm moving.
Isometry3d gripper_of(const VectorXd& q) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  return moved_by(-0.09, 0, 0.38 + q[0]) * moved_by(0.12, 0, 0.35) * turned_by(q[1], z) * moved_by(0.117, 0, 0.06) *
         turned_by(q[2], y) * moved_by(0.219, 0, 0) * turned_by(q[3], x) * moved_by(0.133, 0, 0) * turned_by(q[4], y) *
         moved_by(0.197, 0, 0) * turned_by(q[5], x) * moved_by(0.1245, 0, 0) * turned_by(q[6], y) *
         moved_by(0.1385, 0, 0) * turned_by(q[7], x) * moved_by(0.1, 0, 0);
}

}  // namespace

TEST_CASE("robots of others: a SCARA with a quill that slides goes around a post") {
  const Result result = solved(R"(manifold: robot
robot: {type: urdf, file: scara.urdf}
obstacles:
  - {type: cylinder, radius: 0.05, height: 0.5, pose: {position: [0.45, 0, 0.25]}}
clearance: 0.005
cost: euclidean
ends: {source: {point: [0.9, 0.3, 0.02, 0]}, target: {point: [-0.9, -0.3, 0.1, 1]}}
path: {points: 100}
)");
  CHECK(result.status == Status::certified);
  REQUIRE(result.path.u.rows() == 4);
  // The quill is upright, and lower than the top of the post: both are discs seen from above.
  const double nearest = least_value_along(result.path.u, [](const VectorXd& q) {
    const Isometry3d quill = turned_by(q[0], Vector3d::UnitZ()) * moved_by(0.3, 0, 0.3) *
                             turned_by(q[1], Vector3d::UnitZ()) * moved_by(0.25, 0, 0.05 - q[2]);
    return (quill.translation() - Vector3d(0.45, 0, 0)).head<2>().norm();
  });
  CHECK(nearest > 0.05 + 0.012 + 0.005);
  // The straight way leads through it.
  const VectorXd a = result.path.u.col(0), b = result.path.u.col(result.path.u.cols() - 1);
  const VectorXd middle = (a + b) / 2;
  CHECK(least_value_along(result.path.u, [&](const VectorXd& q) { return (q - middle).norm(); }) > 0.2);
}

TEST_CASE("robots of others: a gantry of three slides lifts its gripper over a box") {
  const Result result = solved(R"(manifold: robot
robot: {type: urdf, file: gantry.urdf}
obstacles:
  - {type: box, size: [0.3, 0.6, 0.5], pose: {position: [0.9, 0.5, 0.25], rpy: [0, 0, 0.3]}}
  - {type: half_space, normal: [0, 0, 1]}
clearance: 0.01
cost: euclidean
ends: {source: {point: [0.2, 0.3, 0.55]}, target: {point: [1.3, 0.7, 0.55]}}
)");
  CHECK(result.status == Status::certified);
  REQUIRE(result.path.u.rows() == 3);
  const double nearest = least_value_along(result.path.u, [](const VectorXd& q) {
    const Vector3d ball(q[0] + 0.17, q[1], 1 - q[2] - 0.33);
    const Vector3d local = turned_by(-0.3, Vector3d::UnitZ()) * Vector3d(ball - Vector3d(0.9, 0.5, 0.25));
    return (local.cwiseAbs() - Vector3d(0.15, 0.3, 0.25)).cwiseMax(0).norm() - 0.04;
  });
  CHECK(nearest > 0.01 - 1e-9);
  CHECK(nearest < 0.02);  // it was in the way
}

TEST_CASE("robots of others: an arm on a lifting torso of a mobile base reaches over a table") {
  const Result result = solved(R"(manifold: robot
robot: {type: urdf, file: mobile_manipulator.urdf, srdf: mobile_manipulator.srdf,
        group: arm_with_torso, hold_state: open}
obstacles:
  - {type: box, size: [0.6, 1.2, 0.04], pose: {position: [0.85, 0, 0.7]}}
  - {type: half_space, normal: [0, 0, 1]}
clearance: 0.01
cost: euclidean
ends: {source: {state: tucked}, target: {state: reach}}
path: {points: 64}
)");
  CHECK(result.status == Status::certified);
  REQUIRE(result.path.u.rows() == 8);
  const double nearest = least_value_along(result.path.u, [](const VectorXd& q) {
    const Isometry3d gripper = gripper_of(q);
    double least = 1;
    for (const double side : {-0.062, 0.062}) {  // the tips of the open fingers
      const Vector3d tip = gripper * Vector3d(0.075, side, 0);
      least =
          std::min(least, ((tip - Vector3d(0.85, 0, 0.7)).cwiseAbs() - Vector3d(0.3, 0.6, 0.02)).cwiseMax(0).norm());
    }
    return least;
  });
  CHECK(nearest > 0.01);
}

TEST_CASE("robots of others: a tool is also a link that a fixed joint holds") {
  const std::string text = R"(manifold: robot
robot: {type: urdf, file: mobile_manipulator.urdf, srdf: mobile_manipulator.srdf,
        group: arm_with_torso, hold_state: open}
cost: euclidean
ends:
  source: {state: tucked}
  target: {tool: {link: gripper_link, offset: [0.07, 0, 0], position: [0.8, 0.1, 1], rpy: [0.2, 0.3, 0.4]}}
)";
  const Run run = parse_run(text, "a.yaml", strangers_folder());
  const VectorXd q = run.parts.problem.target.u;
  REQUIRE(q.size() == 8);
  const Isometry3d gripper = gripper_of(q);
  CHECK((gripper * Vector3d(0.07, 0, 0) - Vector3d(0.8, 0.1, 1)).norm() < 1e-7);
  const Isometry3d wanted =
      turned_by(0.4, Vector3d::UnitZ()) * turned_by(0.3, Vector3d::UnitY()) * turned_by(0.2, Vector3d::UnitX());
  CHECK((gripper.linear() - wanted.linear()).norm() < 1e-7);
  std::string wrong = text;
  wrong.replace(wrong.find("link: gripper_link"), 18, "link: griper_link");
  CHECK_THAT(refusal_of(wrong, strangers_folder()),
             Contains("a.yaml:7") && Contains("the robot has no link 'griper_link'; it has: base_link") &&
                 Contains("gripper_link"));
}

TEST_CASE("robots of others: an end beyond the limits of a joint is refused with the coordinate") {
  const std::string gantry =
      "manifold: robot\nrobot: {type: urdf, file: gantry.urdf}\ncost: euclidean\nends:\n"
      "  source: {point: [0.2, 0.3, 0.55]}\n  target: {point: [1.3, 0.7, 0.65]}\n";
  CHECK_THAT(refusal_of(gantry, strangers_folder()),
             Contains("a.yaml:6") && Contains("between 0 and 0.6 (found 0.65)"));
  // A coordinate that is large forgives the others nothing.
  const std::string scara =
      "manifold: robot\nrobot: {type: urdf, file: scara.urdf}\ncost: euclidean\nends:\n"
      "  source: {point: [0, 0.3, 0, 0]}\n  target: {point: [0, 2.9, 0, 1e9]}\n";
  CHECK_THAT(refusal_of(scara, strangers_folder()),
             Contains("a.yaml:6") && Contains("between -2.5 and 2.5 (found 2.9)"));
}

TEST_CASE("robots of others: an arm of six joints from URDF and SRDF on a bench - with limits of MoveIt") {
  const std::string text = R"(manifold: robot
robot: {type: urdf, file: six_axis.urdf, srdf: six_axis.srdf, group: manipulator}
obstacles: [{type: scene, file: bench.yaml}]
clearance: 0.005
cost: euclidean
ends: {source: {state: pick}, target: {state: place}}
output: {trajectory: {limits: six_axis_joint_limits.yaml}}
)";
  const RunOutcome outcome = solve(parse_run(text, "a.yaml", strangers_folder()));
  const Result& result = outcome.result;
  CHECK(result.status == Status::certified);
  REQUIRE(result.path.u.rows() == 6);
  const Vector3d y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const double nearest = least_value_along(result.path.u, [&](const VectorXd& q) {
    const Isometry3d upper = moved_by(0, 0, 0.09) * turned_by(q[0], z) * moved_by(0, 0.13, 0) * turned_by(q[1], y);
    const Isometry3d forearm = upper * moved_by(0, -0.12, 0.42) * turned_by(q[2], y);
    const Isometry3d wrist = forearm * moved_by(0, 0, 0.39) * turned_by(q[3], y);
    const auto outside = [](const Vector3d& ball) {  // of the wall between the bins
      return ((ball - Vector3d(0.6, 0, 0.12)).cwiseAbs() - Vector3d(0.15, 0.02, 0.125)).cwiseMax(0).norm();
    };
    return std::min(outside(wrist * Vector3d(0, 0.04, 0)) - 0.06, outside(forearm * Vector3d(0, 0, 0.41)) - 0.045);
  });
  CHECK(nearest > 0.005 - 1e-9);
  CHECK(nearest < 0.02);  // it was in the way
  REQUIRE(outcome.trajectory.has_value());
  const Eigen::VectorXd fastest = outcome.trajectory->velocity.cwiseAbs().rowwise().maxCoeff();
  CHECK((fastest.array() <= (VectorXd(6) << 1.5, 1.5, 1.5, 1.6, 1.6, 1.6).finished().array() + 1e-9).all());
  CHECK(fastest[0] > 0.5);
}

}  // namespace leastcost::test
