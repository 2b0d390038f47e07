// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Ground under a robot in space, from a raster or from rows of numbers in the configuration.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include <leastcost/catalogue/catalogue.hpp>
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;

/// A gantry of three slides with a gripper, over ground.
std::string over_ground(const std::string& ground) {
  return "manifold: robot\nrobot: {type: urdf, file: " + (project_dir() / "tests/app/robots/gantry.urdf").string() +
         "}\nobstacles:\n  - {type: height_field, " + ground +
         "}\nclearance: 0.01\ncost: euclidean\n"
         "ends: {source: {point: [0.2, 0.3, 0.55]}, target: {point: [1.3, 0.7, 0.55]}}\n";
}

/// Of a place over the ridge, which is 0.5 high at x = 0.875 and falls to 0 within 0.25 on both sides.
double from_ridge(const Eigen::Vector2d& place) {
  double least = place[1];
  for (const double side : {-0.25, 0.25}) {
    const Eigen::Vector2d top(0.875, 0.5), way(side, -0.5);
    const double t = std::clamp((place - top).dot(way) / way.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (place - top - t * way).norm());
  }
  return least;
}

}  // namespace

TEST_CASE("height fields in a configuration: a gripper goes over a ridge") {
  const ScratchDir dir;
  std::string table, rows;
  for (int row = 0; row < 6; ++row) {
    table += "0,0,0,0.5,0,0,0,0\n";
    rows += (row > 0 ? ", " : "") + std::string("[0, 0, 0, 0.5, 0, 0, 0, 0]");
  }
  std::ofstream(dir / "ridge.csv") << table;
  for (const std::string& ground : {std::string("file: ridge.csv"), "heights: [" + rows + "]"}) {
    const std::string placed = ground + ", cell: 0.25, pose: {position: [0, -0.25, 0]}";
    const Result result = solve(parse_run(over_ground(placed), "a.yaml", dir.path())).result;
    CHECK(result.status == Status::certified);
    REQUIRE(result.certificate.clearance.has_value());
    CHECK(result.certificate.clearance->lower >= -1e-9);
    double nearest = 9;  // of a ball of the gripper
    for (Eigen::Index i = 0; i < result.path.u.cols(); ++i) {
      const Eigen::VectorXd q = result.path.u.col(i);
      nearest = std::min(nearest, from_ridge({q[0] + 0.17, 1 - q[2] - 0.33}) - 0.04);
    }
    CHECK(nearest > 0.01 - 1e-6);
    CHECK(nearest < 0.05);  // it was in the way
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
