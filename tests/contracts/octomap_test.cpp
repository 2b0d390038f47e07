// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/octomap/octomap_obstacles.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost {

/// Its obstacles are boxes; together they are the occupied cells of the file, written out here.
TEST_CASE("obstacle contract: octomap") {
  using Eigen::Vector3d;
  const auto all = read_octomap({.file = "configs/data/corner.bt"}, test::project_dir());
  const std::vector<Eigen::AlignedBox3d> cells = {{Vector3d(0, 0, 0), Vector3d(0.5, 0.5, 0.5)},
                                                  {Vector3d(0.5, 0, 0), Vector3d(1, 0.5, 0.5)},
                                                  {Vector3d(0, 0, 0.5), Vector3d(0.5, 0.5, 1)},
                                                  {Vector3d(0.5, 0, 0.5), Vector3d(0.75, 0.25, 0.75)},
                                                  {Vector3d(0.5, 0.25, 0.5), Vector3d(0.75, 0.5, 0.75)}};
  CHECK(all.size() == 3);
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> anywhere(-1, 2);
  int inside = 0;
  for (int k = 0; k < 1000; ++k) {
    const Vector3d x = Vector3d::NullaryExpr([&] { return anywhere(engine); });
    double expected = 1e300, found = 1e300;
    for (const Eigen::AlignedBox3d& cell : cells) expected = std::min(expected, cell.exteriorDistance(x));
    Eigen::VectorXd away(3);
    for (const auto& one : all) {
      const double distance = one->distance(x, away);
      CHECK(away.norm() == Approx(1));
      CHECK(one->convex());
      found = std::min(found, distance);
    }
    CHECK(std::max(0.0, found) == Approx(expected).margin(1e-12));
    inside += found < 0 ? 1 : 0;
  }
  CHECK(inside > 3);
}

}  // namespace leastcost
