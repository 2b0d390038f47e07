// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Pushes out of several walls at once, and points between walls that face each other.
#include "problems/obstacles/least_push.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include "tests/support/catch.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

/// The least step by looking at all of a fine grid.
double least_on_grid(const std::vector<WallToClear>& walls, double size, int places) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = -places; i <= places; ++i)
    for (int j = -places; j <= places; ++j) {
      const Vector2d step(size * i / places, size * j / places);
      bool clears = true;
      for (const WallToClear& wall : walls) clears = clears && wall.slope.dot(step) >= wall.missing - 1e-12;
      if (clears) least = std::min(least, step.norm());
    }
  return least;
}

}  // namespace

TEST_CASE("least push: the least step that clears all walls") {
  const std::vector<std::vector<WallToClear>> cases = {
      {{Vector2d(1, 0), 0.5}, {Vector2d(0, 1), -1}},
      {{Vector2d(1, 0), 0.5}, {Vector2d(-0.8, 0.6), -0.1}},
      {{Vector2d(1, 0), 0.5}, {Vector2d(-0.8, 0.6), 0.2}, {Vector2d(0, -1), -2}},
      {{Vector2d(0.6, 0.8), 0.3}, {Vector2d(0.8, 0.6), 0.3}, {Vector2d(1, 0), 0.1}},
      {{Vector2d(1, 0), 0.2}, {Vector2d(0.3, 0.1), -0.5}, {Vector2d(-1, 0.5), -0.1}, {Vector2d(0.2, -1), -0.6}}};
  for (const auto& walls : cases) {
    const std::optional<VectorXd> step = least_push(walls);
    REQUIRE(step);
    for (const WallToClear& wall : walls) CHECK(wall.slope.dot(*step) >= wall.missing - 1e-8);
    CHECK(step->norm() == Approx(least_on_grid(walls, 2, 400)).margin(0.01));
  }
}

TEST_CASE("least push: a wall that holds the point is ended on, and no step where nothing is missing") {
  const std::vector<WallToClear> held = {{Vector2d(1, 0), -0.5, true}, {Vector2d(0.8, 0.6), -0.1}};
  const std::optional<VectorXd> step = least_push(held);
  REQUIRE(step);
  CHECK((*step)[0] == Approx(-0.5));
  CHECK((*step)[1] == Approx((-0.1 + 0.4) / 0.6));
  CHECK(least_push({{Vector2d(1, 0), -0.5}})->norm() == 0);
  CHECK_FALSE(least_push({}));
}

TEST_CASE("least push: no step clears walls that leave no room") {
  CHECK_FALSE(least_push({{Vector2d(1, 0), 0.5}, {Vector2d(-1, 0), 0.5}}));
}

TEST_CASE("least push: a point in the notch of two balls that nearly face each other comes out of it") {
  const auto plane = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
  for (const double apart : {0.9, 0.99, 0.999, 0.9999}) {
    const FreeSpace space(plane, {make_ball({Vector2d(-apart, 0), 1}), make_ball({Vector2d(apart, 0), 1})}, 0);
    const double notch = std::sqrt(1 - apart * apart);
    CoordinatePath path{Points(2, 1), {}, true};
    path.u << 0.02 * notch, 0.8 * notch;
    const Projection projection = space.project(path);
    CHECK(projection.failed.empty());
    CHECK((path.u.col(0) - Vector2d(-apart, 0)).norm() >= 1 - 1e-9);
    CHECK((path.u.col(0) - Vector2d(apart, 0)).norm() >= 1 - 1e-9);
    CHECK((path.u.col(0) - Vector2d(0, notch)).norm() <= 0.3 * notch);
  }
}

}  // namespace leastcost
