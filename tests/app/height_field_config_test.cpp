// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Ground under a body in space, from a raster or from rows of numbers in the configuration.
#include <algorithm>
#include <fstream>
#include <string>

#include <leastcost/catalogue/catalogue.hpp>
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;

std::string over_ground(const std::string& ground) {
  return R"(manifold: se3
robot: {type: rigid_body, balls: [{center: [0, 0, 0], radius: 0.2}, {center: [0.5, 0, 0], radius: 0.2}]}
obstacles:
  - {type: height_field, )" +
         ground + R"(}
clearance: 0.02
cost: {type: weighted_length, weights: [1, 0.3]}
ends:
  source: {point: [0.6, 1.5, 0.3, 1, 0, 0, 0]}
  target: {point: [5, 1.5, 0.3, 1, 0, 0, 0]}
path: {points: 40}
)";
}

}  // namespace

TEST_CASE("height fields in a configuration: a body of two balls goes over a ridge") {
  const ScratchDir dir;
  std::ofstream(dir / "ridge.csv") << "0,0,0,1,0,0,0\n0,0,0,1,0,0,0\n0,0,0,1,0,0,0\n0,0,0,1,0,0,0\n";
  for (const std::string ground : {"heights: [[0, 0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0, 0], "
                                   "[0, 0, 0, 1, 0, 0, 0]], pose: {position: [0, -0.5, 0]}",
                                   "file: ridge.csv, pose: {position: [0, -0.5, 0]}"}) {
    const RunOutcome outcome = solve(parse_run(over_ground(ground), "a.yaml", dir.path()));
    CHECK(outcome.result.status == Status::certified);
    REQUIRE(outcome.result.certificate.clearance.has_value());
    CHECK(outcome.result.certificate.clearance->lower >= -1e-9);
    // The ridge is 1 high at x = 3.5, and falls to 0 within 1 on both sides.
    const Points& path = outcome.result.path.u;
    double nearest = 9;
    for (Eigen::Index i = 0; i < path.cols(); ++i) {
      const double over = path(2, i) - std::max(0.0, 1 - std::abs(path(0, i) - 3.5));
      nearest = std::min(nearest, over / std::sqrt(2));
    }
    CHECK(nearest > 0.15);
    CHECK(path.row(2).maxCoeff() > 1.2);
  }
}

TEST_CASE("height fields in a configuration: what is wrong is named with its place") {
  const ScratchDir dir;
  std::ofstream(dir / "gap.asc")
      << "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9\n1 1\n1 -9\n";
  std::ofstream(dir / "row.csv") << "1,2,3\n";
  const auto refused = [&](const std::string& ground) { return refusal_of(over_ground(ground), dir.path()); };
  CHECK_THAT(refused("file: gap.asc"), Contains("row 1, column 1 of") && Contains("gap.asc has no height"));
  CHECK_THAT(refused("file: row.csv"),
             Contains("row.csv: a height field has at least 2 x 2 heights") && Contains("1 x 3"));
  CHECK_THAT(refused("depth: 1"),
             Contains("a.yaml:4") && Contains("is missing: a height field has the file of a raster"));
  CHECK_THAT(refused("heights: [[1, 2], [3]]"), Contains("a.yaml:4"));
  CHECK_THAT(refused("heights: []"), Contains("a.yaml:4"));
  CHECK_THAT(refused("heights: [[1, 2], [3, .nan]]"), Contains("a.yaml:4"));
  CHECK_THAT(refused("heights: [[1, 2], [3, 4]], depth: 0"), Contains("a.yaml:4") && Contains("greater than 0"));
}

}  // namespace leastcost::test
