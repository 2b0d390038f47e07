// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/plugins/kinds.hpp"
#include "catalogue/registry/registry.hpp"

#include <leastcost/framework/domain/has_box.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include "tests/contracts/manifold_contract.hpp"

namespace leastcost::test {

TEST_CASE("manifold contract: robot", "[contract]") {
  BuildContext context;
  context.robot = make_dh_arm({});
  const auto& plugin = static_cast<const ManifoldPlugin&>(*find_plugin(kind("manifold"), "robot"));
  const auto manifold = plugin.make(*plugin.defaults(), context);
  const auto* box = find_ability<HasBox>(*manifold);
  REQUIRE(box != nullptr);
  CHECK(box->box_lower() == context.robot->kinematics->lower());
  CHECK(box->box_upper() == context.robot->kinematics->upper());
  check_manifold_contract({.manifold = manifold, .near = [&](Random& random) -> Eigen::VectorXd {
                             const Eigen::VectorXd middle = (box->box_lower() + box->box_upper()) / 2;
                             return middle + random.vector(7);
                           }});
}

}  // namespace leastcost::test
