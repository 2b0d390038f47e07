// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// One formula is checked once, whoever asks, and another question is another one.
#include "problems/costs/lagrangian/lagrangian_memory.hpp"

#include <leastcost/framework/base/errors.hpp>

#include "tests/support/catch.hpp"

namespace leastcost::test {

TEST_CASE("lagrangian check: the same question is answered from memory, refusals too") {
  const Eigen::VectorXd lower = Eigen::Vector2d(0, 0), upper = Eigen::Vector2d(1, 1), wider = Eigen::Vector2d(1, 2);
  const LagrangianQuestion asked{"a text of this test", {{"a", 1}}, {lower, upper}, 2, false};
  int checks = 0;
  const auto check = [&] {
    ++checks;
    return LagrangianCheck{true, checks > 1, "number " + std::to_string(checks)};
  };
  CHECK(remembered_check(asked, check).note == "number 1");
  const LagrangianCheck again = remembered_check(asked, check);
  CHECK(checks == 1);
  CHECK(again.note == "number 1");
  CHECK(again.proved);
  CHECK_FALSE(again.convex);

  LagrangianQuestion other = asked;
  other.parameters["a"] = 2;
  remembered_check(other, check);
  other = asked;
  other.box.upper = wider;
  remembered_check(other, check);
  other = asked;
  other.box = {};
  remembered_check(other, check);
  other = asked;
  other.any_shape = true;
  remembered_check(other, check);
  CHECK(checks == 5);

  other.text = "one that is refused";
  const auto refuse = [&]() -> LagrangianCheck {
    ++checks;
    throw OptionError("lagrangian", "is none");
  };
  CHECK_THROWS_WITH(remembered_check(other, refuse), "lagrangian is none");
  CHECK_THROWS_WITH(remembered_check(other, refuse), "lagrangian is none");
  CHECK(checks == 6);
  for (int i = 0; i < 200; ++i) {  // old answers make room
    other.dim = 100 + i;
    remembered_check(other, check);
  }
  checks = 0;
  remembered_check(asked, check);
  CHECK(checks == 1);
}

}  // namespace leastcost::test
