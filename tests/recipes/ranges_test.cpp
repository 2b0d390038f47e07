// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Ranges that a configuration refuses are refused in C++ as well, by the same list of fields.
#include <limits>

#include <leastcost/leastcost.hpp>

#include "tests/support/catch.hpp"

namespace leastcost::test {

TEST_CASE("ranges: options outside their range do not make a part") {
  CHECK_THROWS_WITH(RrtInitializer({.goal_bias = 7}),
                    Catch::Contains("goal_bias must be at least 0 and at most 1, not 7"));
  CHECK_THROWS_AS(RrtInitializer({.max_nodes = -3}), OptionError);
  CHECK_THROWS_WITH(RrtInitializer({.step = -1}), Catch::Contains("must be greater than 0, not -1"));
  CHECK_THROWS_AS(BowInitializer({.height = -1}), OptionError);
  CHECK_THROWS_AS(GridInitializer({.resolution = 0}), OptionError);
  CHECK_THROWS_AS(EikonalInitializer({.cells = -4}), OptionError);
  CHECK_THROWS_WITH(Lbfgs({.memory = -2}), Catch::Contains("at least 1"));
  CHECK_THROWS_AS(DijkstraInitializer({.rank = 0}), OptionError);
  CHECK_THROWS_AS(TautPostProcessor({.excess = 1}), OptionError);
  CHECK_THROWS_AS(OnSurfacePostProcessor({.tolerance = std::numeric_limits<double>::quiet_NaN()}), OptionError);
  CHECK_NOTHROW(RrtInitializer({.goal_bias = 1}));
}

TEST_CASE("ranges: thresholds of the certificate are checked where a search begins, with their names") {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
  problem.cost = make_euclidean_cost(2);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = Eigen::Vector2d(0, 0);
  problem.target.u = Eigen::Vector2d(1, 0);
  const auto key_of = [&](const CertificateOptions& options) -> std::string {
    try {
      find_path(problem, StraightInitializer(), Newton(), {.certificate = options});
    } catch (const OptionError& error) {
      return error.key();
    }
    return "";
  };
  CHECK(key_of({}) == "");
  CHECK(key_of({.spacing = -1}) == "certificate.spacing");
  CHECK(key_of({.longest_segment = 0.1}) == "certificate.longest_segment");
  CHECK(key_of({.global = GlobalBudget{.tolerance = 1}}) == "certificate.global.tolerance");
}

}  // namespace leastcost::test
