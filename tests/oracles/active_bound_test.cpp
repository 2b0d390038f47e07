// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A brachistochrone that would dip below the floor of its box: the place where it leaves the floor moves between the
// levels of the certificate, so the bar must not come from an extrapolation.
#include <numbers>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/solvers/newton.hpp>
#include "tests/support/catch.hpp"

namespace {

using namespace leastcost;

Result slide_on_floor(int points) {
  EuclideanManifoldOptions box{.dimension = 2};
  box.box.lower = Eigen::Vector2d(-1, -1);
  box.box.upper = Eigen::Vector2d(6, 1);
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(box);
  problem.source.u = Eigen::Vector2d(0, 0);
  problem.target.u = Eigen::Vector2d(5, -0.5);
  problem.cost = make_travel_time_cost({.gravity = 1}, 2, problem.source.u);
  problem.kernel = make_kernel<Expm1Square>();
  const Newton newton;
  FindOptions options;
  options.points = points;
  return find_path(problem, StraightInitializer(), newton, options);
}

}  // namespace

TEST_CASE("a path along a bound: the error bar covers the finer solution", "[oracles]") {
  const Result fine = slide_on_floor(1000);
  REQUIRE(fine.path.u.row(1).minCoeff() == -1);  // it does rest on the floor
  const CostEstimate reference = fine.certificate.estimate;
  for (const int points : {8, 16, 40, 64, 100}) {
    const Certificate c = slide_on_floor(points).certificate;
    INFO(points << " points: " << c.estimate.value << " +- " << c.estimate.error << ", " << reference.value << " +- "
                << reference.error);
    CHECK(std::abs(c.estimate.value - reference.value) <= c.estimate.error + reference.error);
  }
}
