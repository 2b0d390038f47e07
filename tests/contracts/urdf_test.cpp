// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/urdf/urdf_robot.hpp>

#include "tests/contracts/robot_contract.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost {

TEST_CASE("robot contract: urdf") {
  const UrdfRobotOptions all{.file = "gantry_arm.urdf", .srdf = "gantry_arm.srdf"};
  test::check_robot(make_urdf_robot(all, test::project_dir() / "configs/data"));
  const UrdfRobotOptions alone{.file = "gantry_arm.urdf", .position = Eigen::Vector3d(0.3, -0.2, 0.1)};
  test::check_robot(make_urdf_robot(alone, test::project_dir() / "configs/data"));
}

}  // namespace leastcost
