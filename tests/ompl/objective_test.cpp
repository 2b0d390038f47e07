// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/ompl/objective.hpp>

#include <ompl/base/OptimizationObjective.h>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include "tests/ompl/plans.hpp"

namespace leastcost::test {

TEST_CASE("ompl objective: a path costs what its moves cost us, across the seam of an angle as well") {
  const PlannerSpace space = open_space(planar_poses());
  const auto cost = make_metric_field_cost({.field = metric::Formula{{"1", "0", "0", "2", "0", "1+x*x"}, {}}}, 3);
  const auto objective = make_objective(space, cost);
  Points given(3, 5);
  given << 0, 1, 2, 2, 3,  //
      0, 0, 1, 2, 2,       //
      3, 3.5, 4.5, 6, 7;
  double sum = 0;
  for (Index i = 0; i + 1 < given.cols(); ++i) sum += move_cost(*cost, given.col(i), given.col(i + 1));
  CHECK(path_through(space, given).cost(objective).value() == Approx(sum).epsilon(1e-12));
  CHECK(objective->isSymmetric());
}

TEST_CASE("ompl objective: parts that do not fit") {
  const PlannerSpace space = open_space(square());
  CHECK_THROWS_AS(make_objective(space, make_euclidean_cost(3)), InputError);
  CHECK_THROWS_WITH(make_objective(space, make_euclidean_cost(3)),
                    Catch::Contains("the cost has 3 dimensions, but states of the space have 2"));
  CHECK_THROWS_AS(make_objective(space, nullptr), InputError);
  CHECK_THROWS_AS(make_objective(nullptr, make_euclidean_cost(2)), InputError);
}

}  // namespace leastcost::test
