// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A robot of somebody else in a configuration: its URDF, its SRDF and what stands around it.
#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <vector>

#include <leastcost/catalogue/catalogue.hpp>
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;
using Eigen::AngleAxisd;
using Eigen::Vector3d;

const std::string kArm = R"(manifold: robot
robot: {type: urdf, file: gantry_arm.urdf, srdf: gantry_arm.srdf, group: arm, hold_state: open}
obstacles: [{type: ball, center: [0, 0.05, 0.4], radius: 0.25}]
clearance: 0.01
cost: euclidean
ends: {source: {state: left_bin}, target: {state: right_bin}}
path: {points: 40}
)";

std::filesystem::path folder() { return project_dir() / "configs/data"; }

/// The distance of a point from a box of the file in its frame; 0 inside.
double from_box(const Vector3d& point, const Vector3d& middle, const Vector3d& size) {
  return ((point - middle).cwiseAbs() - size / 2).cwiseMax(0).norm();
}

}  // namespace

TEST_CASE("urdf in a configuration: ten lines give a certified plan that is clear of the shapes of the file") {
  const RunOutcome outcome = solve(parse_run(kArm, "a.yaml", folder()));
  const Result& result = outcome.result;
  CHECK(result.status == Status::certified);
  const Points& path = result.path.u;
  REQUIRE(path.rows() == 4);
  CHECK(path.col(0).isApprox(Eigen::Vector4d(-0.7, 0.3, -0.4, 0), 1e-12));
  // By transformations of Eigen: the forearm and the palm are boxes, the ball keeps 0.01 away from them.
  const Vector3d ball(0, 0.05, 0.4);
  double nearest = 1e300;
  for (Eigen::Index i = 0; i + 1 < path.cols(); ++i) {
    for (int k = 0; k <= 10; ++k) {
      const Eigen::VectorXd q = path.col(i) + (path.col(i + 1) - path.col(i)) * k / 10.0;
      const Eigen::Affine3d forearm = Eigen::Translation3d(q[0], 0, 1.05) * AngleAxisd(q[1], Vector3d::UnitY()) *
                                      Eigen::Translation3d(0, 0, -0.4) * AngleAxisd(0.3, Vector3d::UnitZ()) *
                                      AngleAxisd(q[2], Vector3d::UnitY());
      const Eigen::Affine3d wrist = forearm * Eigen::Translation3d(0, 0, -0.32) * AngleAxisd(q[3], Vector3d::UnitZ());
      nearest = std::min({nearest, from_box(forearm.inverse() * ball, {0, 0, -0.15}, {0.08, 0.06, 0.3}),
                          from_box(wrist.inverse() * ball, {0, 0, -0.095}, {0.14, 0.04, 0.03})});
    }
  }
  CHECK(nearest > 0.25 + 0.01);
  CHECK(nearest < 0.25 + 0.2);  // and the ball was in the way
}

TEST_CASE("urdf in a configuration: what does not fit is named with its place") {
  CHECK(errors_of(kArm) == "");  // without its files nothing can be said against it
  CHECK(refusal_of(kArm, folder()) == "");
  CHECK_THAT(refusal_of(replaced(kArm, "left_bin", "nowhere"), folder()),
             Contains("a.yaml:6") && Contains("the robot has no state 'nowhere'; it has: left_bin, right_bin"));
  CHECK_THAT(refusal_of(replaced(kArm, "group: arm", "group: leg"), folder()),
             Contains("a.yaml:2") && Contains("the SRDF has no group 'leg'; it has: 'all', 'arm', 'gripper'"));
  CHECK_THAT(refusal_of(replaced(kArm, "gantry_arm.urdf", "missing.urdf"), folder()), Contains("missing.urdf"));
  CHECK_THAT(refusal_of(replaced(kArm, "{state: left_bin}", "{point: [0, 0, 0]}"), folder()),
             Contains("must have 4 coordinates (x0, x1, x2, x3; found 3)"));
  CHECK_THAT(refusal_of(replaced(kArm, "hold_state: open", "hold: {left: 1}"), folder()),
             Contains("outside its limits"));
  CHECK_THAT(refusal_of(replaced(kArm, "manifold: robot", "manifold: {type: euclidean, dimension: 4}"), folder()),
             Contains("coordinate 0 has the limits [-1, 1]"));
}

}  // namespace leastcost::test
