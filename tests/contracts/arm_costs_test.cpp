// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/end_effector_length.hpp>
#include <leastcost/problems/costs/kinetic_energy.hpp>
#include "tests/contracts/cost_contract.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/refused_key.hpp"

namespace leastcost::test {
namespace {

CostCase arm_cost_case(std::shared_ptr<const SegmentCost> cost) {
  const int d = cost->dim();
  return {.cost = std::move(cost), .draw = [d](Random& random) { return random.vector(d); }};
}

/// Two bars in the plane.
arm_inertia::Table two_bars() {
  arm_inertia::Table table;
  table.rows.resize(2, 4);
  table.rows << 1, 0, 0, 0,  //
      0.8, 0, 0, 0;
  table.links.resize(2, 10);
  table.links << 4, -0.5, 0, 0, 0, 0.34, 0.34, 0, 0, 0,  //
      2, -0.4, 0, 0, 0, 0.11, 0.11, 0, 0, 0;
  return table;
}

}  // namespace

TEST_CASE("cost contract: kinetic_energy", "[contract]") {
  check_cost_contract(arm_cost_case(make_kinetic_energy_cost({}, 7)));
  check_cost_contract(arm_cost_case(make_kinetic_energy_cost({.model = arm_inertia::Ur5{}}, 6)));
  check_cost_contract(arm_cost_case(make_kinetic_energy_cost({.model = two_bars()}, 2)));
  arm_inertia::Table modified = two_bars();
  modified.convention = DhConvention::modified;
  modified.rows.col(1).setConstant(0.7);
  check_cost_contract(arm_cost_case(make_kinetic_energy_cost({.model = modified}, 2)));
}

TEST_CASE("cost contract: end_effector_length", "[contract]") {
  check_cost_contract(arm_cost_case(make_end_effector_length({}, 7)));
  check_cost_contract(arm_cost_case(make_end_effector_length(
      {.model = arm_model::Ur5{}, .tool = Eigen::Vector3d(0, 0.1, 0.2), .joint_weight = 0.3}, 6)));
}

TEST_CASE("costs of arms: options that do not fit are named", "[contract]") {
  const auto key = [](const arm_inertia::Table& table, int dim) {
    return refused_key([&] { make_kinetic_energy_cost({.model = table}, dim); });
  };
  CHECK(key(two_bars(), 2).empty());
  CHECK(key(two_bars(), 3) == "model");
  arm_inertia::Table wrong = two_bars();
  wrong.links.conservativeResize(1, 10);
  CHECK(key(wrong, 2) == "model.links");
  wrong = two_bars();
  wrong.links(1, 0) = -1;
  CHECK(key(wrong, 2) == "model.links");
  wrong = two_bars();
  wrong.links(0, 7) = 1;  // xy alone: one moment is negative
  CHECK(key(wrong, 2) == "model.links");
  wrong = two_bars();
  wrong.links.row(1).setZero();  // joint 2 moves nothing
  CHECK(key(wrong, 2) == "model.links");
  wrong = two_bars();
  wrong.links(0, 0) = std::nan("");
  CHECK(key(wrong, 2) == "model.links");
  wrong.rows.resize(2, 3);
  CHECK(key(wrong, 2) == "model.rows");
  CHECK(key(arm_inertia::Table{}, 2) == "model.rows");

  CHECK(refused_key([] { make_end_effector_length({}, 6); }) == "model");
  CHECK(refused_key([] { make_end_effector_length({.joint_weight = 0}, 7); }) == "joint_weight");
  CHECK(refused_key([] { make_end_effector_length({.tool = Eigen::Vector2d(0, 0)}, 7); }) == "tool");
  CHECK(refused_key([] { make_end_effector_length({.model = arm_joints::Table{}}, 7); }) == "model.rows");
}

}  // namespace leastcost::test
