// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/rigid_body.hpp>
#include "tests/contracts/robot_contract.hpp"
#include "tests/support/catch.hpp"

namespace leastcost {

TEST_CASE("robot contract: dh_arm") {
  test::check_robot(make_dh_arm({}));
  test::check_robot(make_dh_arm({.model = arm_model::Ur5{}, .base = Eigen::Vector3d(0.1, -0.2, 0.3)}));
  arm_model::Table planar;
  planar.rows.resize(2, 4);
  planar.rows << 0.5, 0, 0, 0.1,  //
      0.4, 0.3, 0.2, 0;
  planar.shape.resize(2, 8);
  planar.shape << 1, -0.5, 0, 0, 0, 0, 0, 0.05,  //
      2, -0.4, 0, 0, 0, 0, 0, 0.05;
  test::check_robot(make_dh_arm({.model = planar}));
}

TEST_CASE("robot contract: rigid_body") {
  Eigen::MatrixXd shape(1, 5);
  shape << -0.3, 0, 0.4, 0.1, 0.1;
  test::check_robot(make_rigid_body({shape}));
  shape.resize(1, 7);
  shape << -0.3, 0, 0, 0.4, 0.1, 0.2, 0.1;
  test::check_robot(make_rigid_body({shape}));
}

}  // namespace leastcost
