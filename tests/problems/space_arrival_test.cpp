// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Fields in space for costs that depend on the direction, against closed forms and finer fields.
#include <leastcost/problems/fields/space_field.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/costs/zermelo.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector3d;

const Vector3d kFrom(0.31, 0.42, 0.55);

Problem in_cube(const std::shared_ptr<const SegmentCost>& cost) {
  return between(box(Vector3d(0, 0, 0), Vector3d(1, 1, 1)), cost, kFrom, Vector3d(0.9, 0.9, 0.9));
}

/// The largest difference from the cost of straight moves.
double worst_of_straight(const SpaceField& field, const SegmentCost& cost) {
  double most = 0;
  const Eigen::VectorXd source = kFrom;
  for (std::int32_t k = 0; k < field.count[2]; ++k)
    for (std::int32_t j = 0; j < field.count[1]; ++j)
      for (std::int32_t i = 0; i < field.count[0]; ++i) {
        const Eigen::VectorXd x = field.node(i, j, k);
        const double right = field.to_places ? move_cost(cost, x, source) : move_cost(cost, source, x);
        REQUIRE(std::isfinite(field.value(i, j, k)));
        most = std::max(most, std::abs(field.value(i, j, k) - right));
      }
  return most;
}

/// The largest difference from a field on twice as many cells.
double worst_of_finer(const SpaceField& field, const SpaceField& finer) {
  double most = 0;
  for (std::int32_t k = 0; k < field.count[2]; ++k)
    for (std::int32_t j = 0; j < field.count[1]; ++j)
      for (std::int32_t i = 0; i < field.count[0]; ++i)
        most = std::max(most, std::abs(field.value(i, j, k) - finer.value(2 * i, 2 * j, 2 * k)));
  return most;
}

double least_of(const SpaceField& field) {
  return *std::min_element(field.values.begin(), field.values.end(),
                           [](double a, double b) { return std::isnan(b) || a < b; });
}

}  // namespace

TEST_CASE("space arrival: a constant wind has the times of straight moves in both directions") {
  const auto cost = make_zermelo_cost({.speed = "1", .flow = flow::Formula{{"0.5", "0.2", "-0.3"}}}, 3);
  const Problem problem = in_cube(cost);
  for (const bool to : {false, true}) {
    const SpaceField field = space_costs_from(problem, {kFrom}, {.resolution = 0.1, .to_places = to});
    const double error = worst_of_straight(field, *cost);
    CAPTURE(to, error, field.error);
    CHECK(error < 2e-3);
    CHECK(field.error >= error);
    CHECK(field.directed);
    CHECK(field.method == "arrival field");
  }
}

TEST_CASE("space arrival: a constant metric has the lengths of straight moves") {
  Eigen::MatrixXd metric(3, 3);
  metric << 4, 1, 0.5, 1, 1, 0.2, 0.5, 0.2, 0.5;
  const auto cost = make_metric_tensor_cost({metric}, 3);
  const SpaceField field = space_costs_from(in_cube(cost), {kFrom}, {.resolution = 0.05});
  const double error = worst_of_straight(field, *cost);
  CAPTURE(error, field.error);
  CHECK(error < 0.01);
  CHECK(field.error >= error);
  CHECK_FALSE(field.directed);
}

TEST_CASE("space arrival: a metric that varies against a field on twice as many cells") {
  const auto cost = make_metric_field_cost(
      {metric::Formula{{"1 + 2 * x * x", "0.3 * y", "0", "1 + exp(-4 * z)", "0.2 * x", "1.5"}, {}}}, 3);
  const Problem problem = in_cube(cost);
  const SpaceField coarse = space_costs_from(problem, {kFrom}, {.resolution = 0.1}),
                   fine = space_costs_from(problem, {kFrom}, {.resolution = 0.05});
  const double error = worst_of_finer(coarse, fine);
  CAPTURE(error, coarse.error);
  CHECK(error < 4e-3);
  CHECK(coarse.error >= error);
  const Vector3d there(0.9, 0.8, 0.2);
  const std::vector<Vector3d> way = way_down(fine, problem, there);
  CHECK(way.front() == kFrom);
  CHECK(way.back() == there);
  CHECK(cost_of_way(problem, way) == Approx(fine.value(18, 16, 4)).epsilon(5e-3));
}

TEST_CASE("space arrival: a wind among obstacles with its ways and its corridor") {
  const auto cost = make_zermelo_cost(
      {.speed = "1", .flow = flow::Formula{{"0.5 * sin(4 * y)", "0.4 * cos(3 * x + z)", "0.3 * sin(5 * x)"}}}, 3);
  Problem problem = in_cube(cost);
  problem.manifold = std::make_shared<const FreeSpace>(
      problem.manifold, FreeSpace::Obstacles{make_ball({Vector3d(0.6, 0.6, 0.6), 0.2})}, 0.0);
  const Vector3d behind(0.9, 0.8, 0.7);
  const SpaceField from = space_costs_from(problem, {kFrom}, {.resolution = 0.05}),
                   to = space_costs_from(problem, {behind}, {.resolution = 0.05, .to_places = true});
  CHECK(std::isnan(from.value(12, 12, 12)));
  const std::vector<Vector3d> way = way_down(from, problem, behind), same = way_down(to, problem, kFrom);
  CHECK(way.front() == kFrom);
  CHECK(way.back() == behind);
  CHECK(same.front() == kFrom);
  CHECK(same.back() == behind);
  const double value = from.value(18, 16, 14), cost_there = cost_of_way(problem, way);
  CAPTURE(value, from.error, cost_there);
  CHECK(std::abs(cost_there - value) < from.error);
  CHECK(cost_of_way(problem, same) == Approx(cost_there).epsilon(0.01));
  for (const Vector3d& point : way) CHECK((point - Vector3d(0.6, 0.6, 0.6)).norm() > 0.2 - 1e-9);
  CHECK(least_of(corridor(from, to)) == 0);
  // There the wind blows from the place, so that the way back takes longer.
  const SpaceField back = space_costs_from(problem, {kFrom}, {.resolution = 0.05, .to_places = true});
  CHECK(std::abs(back.value(18, 16, 14) - value) > 0.05);
}

}  // namespace leastcost::test
