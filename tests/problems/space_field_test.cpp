// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Fields of least costs in space, against closed forms.
#include <leastcost/problems/fields/space_field.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/refractive_index.hpp>
#include <leastcost/problems/costs/zermelo.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector3d;
using SpaceTruth = std::function<double(const Vector3d&)>;

std::shared_ptr<const EuclideanManifold> unit_cube() { return box(Vector3d(0, 0, 0), Vector3d(1, 1, 1)); }

/// The largest difference from the truth, where that is a number.
double worst_in_space(const SpaceField& field, const SpaceTruth& truth) {
  double most = 0;
  for (std::int32_t k = 0; k < field.count[2]; ++k)
    for (std::int32_t j = 0; j < field.count[1]; ++j)
      for (std::int32_t i = 0; i < field.count[0]; ++i) {
        const double exact = truth(field.node(i, j, k)), value = field.value(i, j, k);
        if (std::isnan(exact)) continue;
        REQUIRE(std::isfinite(value));
        most = std::max(most, std::abs(value - exact));
      }
  return most;
}

/// Around a ball at the origin: the straight line, or tangents and an arc.
double around_ball(const Vector3d& a, const Vector3d& b, double radius) {
  const double t = std::clamp(-a.dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  if ((a + t * (b - a)).norm() >= radius) return (b - a).norm();
  const double between = std::acos(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0, 1.0));
  const double from_a = std::acos(radius / a.norm()), from_b = std::acos(std::min(radius / b.norm(), 1.0));
  return radius * (std::tan(from_a) + std::tan(from_b) + between - from_a - from_b);
}

}  // namespace

TEST_CASE("space field: distances and the nearest of two places") {
  const Vector3d source(0.31, 0.42, 0.55);
  const Problem problem = between(unit_cube(), make_euclidean_cost(3), source, Vector3d(0.9, 0.9, 0.9));
  const SpaceField field = space_costs_from(problem, {source}, {.resolution = 0.05});
  CHECK(field.count == std::array<std::int32_t, 3>{21, 21, 21});
  const double error = worst_in_space(field, [&](const Vector3d& x) { return (x - source).norm(); });
  CAPTURE(error, field.error);
  CHECK(error < 2e-3);
  CHECK(field.error >= error);
  const std::vector<Eigen::VectorXd> two = {Vector3d(0.2, 0.2, 0.2), Vector3d(0.7, 0.8, 0.6)};
  CHECK(worst_in_space(space_costs_from(problem, two, {.resolution = 0.05}),
                       [&](const Vector3d& x) { return std::min((x - two[0]).norm(), (x - two[1]).norm()); }) < 0.01);
}

TEST_CASE("space field: second order where slowness has a gradient") {
  // Speed 1 + z: circles, as in the plane.
  const auto cost = make_refractive_index_cost({refraction::Formula{"1 / (1 + z)", {}}}, 3);
  const Vector3d source(0.1, 0.2, 0.3);
  const Problem problem = between(unit_cube(), cost, source, Vector3d(0.9, 0.9, 0.9));
  const SpaceTruth truth = [&](const Vector3d& x) {
    return std::acosh(1 + (x - source).squaredNorm() / (2 * (1 + source[2]) * (1 + x[2])));
  };
  const SpaceField coarse = space_costs_from(problem, {source}, {.resolution = 0.1}),
                   fine = space_costs_from(problem, {source}, {.resolution = 0.05});
  const double before = worst_in_space(coarse, truth), after = worst_in_space(fine, truth);
  CAPTURE(before, after, fine.error);
  CHECK(after < 1e-3);
  CHECK(after < before / 2.5);
  CHECK(fine.error >= after);
  const std::vector<Vector3d> way = way_down(fine, problem, Vector3d(0.9, 0.8, 0.4));
  CHECK(way.front() == source);
  CHECK(way.back() == Vector3d(0.9, 0.8, 0.4));
  CHECK(cost_of_way(problem, way) == Approx(truth(way.back())).epsilon(2e-3));
}

TEST_CASE("space field: around a ball and the way behind it") {
  const auto room = std::make_shared<const FreeSpace>(box(Vector3d(-1, -1, -1), Vector3d(1, 1, 1)),
                                                      FreeSpace::Obstacles{make_ball({Vector3d(0, 0, 0), 0.4})}, 0.0);
  const Vector3d source(-0.8, 0.05, 0.1), behind(0.8, 0, 0);
  const Problem problem = between(room, make_euclidean_cost(3), source, behind);
  const SpaceField field = space_costs_from(problem, {source}, {.resolution = 0.1});
  const double error = worst_in_space(
      field, [&](const Vector3d& x) { return x.norm() < 0.4 + 1e-9 ? std::nan("") : around_ball(source, x, 0.4); });
  CAPTURE(error, field.error);
  CHECK(error < 0.12);
  CHECK(field.error >= error);
  CHECK(std::isnan(field.value(10, 10, 10)));
  const std::vector<Vector3d> way = way_down(field, problem, behind);
  CHECK(cost_of_way(problem, way) == Approx(around_ball(source, behind, 0.4)).epsilon(0.01));
  const SpaceField to = space_costs_from(problem, {behind}, {.resolution = 0.1, .to_places = true});
  const SpaceField sum = corridor(field, to);
  CHECK(*std::min_element(sum.values.begin(), sum.values.end(),
                          [](double a, double b) { return std::isnan(b) || a < b; }) == 0);
  CHECK(way_down(to, problem, source).back() == behind);
}

TEST_CASE("space field: what has none is refused") {
  const Vector3d source(0.5, 0.5, 0.5);
  const auto wind = make_zermelo_cost({.speed = "1", .flow = flow::Formula{{"2 * x", "0.2", "0"}}}, 3);
  const Problem sail = between(unit_cube(), wind, source, Vector3d(0.9, 0.9, 0.9));
  CHECK_THROWS_WITH(space_costs_from(sail, {source}),
                    Catch::Contains("in a wind that is weaker than the speed; at (0.5, 0, 0) it is neither"));
  const auto current = make_zermelo_cost({.speed = "1", .flow = flow::Formula{{"0.5", "0.2", "0"}}}, 3);
  const Problem drift = between(unit_cube(), current, source, Vector3d(0.9, 0.9, 0.9));
  CHECK_THROWS_WITH(space_costs_from(drift, {source}, {.resolution = 0.005}),
                    Catch::Contains("more than 3 million nodes"));
  const Problem walk = between(unit_cube(), make_euclidean_cost(3), source, Vector3d(0.9, 0.9, 0.9));
  CHECK_THROWS_WITH(space_costs_from(walk, {Vector3d(2, 0, 0)}), Catch::Contains("is outside the box"));
  CHECK_THROWS_AS(space_costs_from(walk, {source}, {.resolution = 0.3}), OptionError);
  CHECK_THROWS_AS(space_costs_from(walk, {source}, {.resolution = 1e-4}), OptionError);
}

}  // namespace leastcost::test
