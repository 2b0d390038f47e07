// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Fields of least costs: against closed forms, and random worlds against finer fields of their own kind.
#include <leastcost/problems/fields/cost_field.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/costs/refractive_index.hpp>
#include <leastcost/problems/costs/zermelo.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;
using Truth = std::function<double(const Vector2d&)>;

std::shared_ptr<const SegmentCost> index_of(const std::string& formula) {
  return make_refractive_index_cost({refraction::Formula{formula, {}}}, 2);
}

/// The largest difference from the truth.
double worst(const CostField& field, const Truth& truth) {
  double most = 0;
  for (std::int32_t j = 0; j < field.count[1]; ++j)
    for (std::int32_t i = 0; i < field.count[0]; ++i) {
      const double value = field.value(i, j), exact = truth(field.node(i, j));
      if (std::isnan(exact)) continue;
      REQUIRE(std::isfinite(value));
      most = std::max(most, std::abs(value - exact));
    }
  return most;
}

CostField field_of(const Problem& problem, double resolution, bool to_places = false) {
  return costs_from(problem, {problem.source.u}, {.resolution = resolution, .to_places = to_places});
}

/// Around a disc at the origin: the straight line, or tangents and an arc.
double around_disc(const Vector2d& a, const Vector2d& b, double radius) {
  const double t = std::clamp(-a.dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  if ((a + t * (b - a)).norm() >= radius) return (b - a).norm();
  const double between = std::acos(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0, 1.0));
  const double from_a = std::acos(radius / a.norm()), from_b = std::acos(std::min(radius / b.norm(), 1.0));
  return radius * (std::tan(from_a) + std::tan(from_b) + between - from_a - from_b);
}

/// Bumps and hollows that a lattice of a hundredth resolves.
struct World {
  explicit World(std::uint32_t seed) : random(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  Vector2d place() { return {number(0.05, 0.95), number(0.05, 0.95)}; }
  std::string density() {
    std::string text = "1";
    for (int k = 0; k < 3; ++k) {
      const Vector2d middle = place();
      text += " + " + std::to_string(number(0.2, 1.5)) + " * exp(-((x - " + std::to_string(middle[0]) + ")^2 + (y - " +
              std::to_string(middle[1]) + ")^2) / " + std::to_string(number(0.02, 0.1)) + ")";
    }
    return text;
  }
  /// Up to three, four cells of the coarse lattice or more apart and off the sides of the box.
  FreeSpace::Obstacles discs(const Vector2d& source) {
    constexpr double kApart = 0.1;
    FreeSpace::Obstacles obstacles;
    std::vector<std::pair<Vector2d, double>> all = {{source, 0.0}};
    for (int trial = 0; trial < 50 && all.size() < 4; ++trial) {
      const double radius = number(0.05, 0.15), edge = radius + kApart;
      const Vector2d middle(number(edge, 1 - edge), number(edge, 1 - edge));
      const bool apart = std::all_of(all.begin(), all.end(), [&](const auto& other) {
        return (other.first - middle).norm() > other.second + radius + kApart;
      });
      if (!apart) continue;
      all.emplace_back(middle, radius);
      obstacles.push_back(make_ball({middle, radius}));
    }
    return obstacles;
  }
  std::mt19937 random;
};

std::shared_ptr<const EuclideanManifold> unit_box() { return box(Vector2d(0, 0), Vector2d(1, 1)); }

/// Differences of the coarse field from a fine one, at common nodes away from the places, against what it says itself.
struct Outcome {
  double worst = 0, stated = 0, largest = 0;
};
Outcome compared(const Problem& problem, const std::vector<Eigen::VectorXd>& places, double step, int finer) {
  const CostField coarse = costs_from(problem, places, {.resolution = step});
  const CostField fine = costs_from(problem, places, {.resolution = step / finer, .estimate_error = false});
  Outcome outcome{0, coarse.error, 0};
  for (std::int32_t j = 0; j < coarse.count[1]; ++j)
    for (std::int32_t i = 0; i < coarse.count[0]; ++i) {
      const double value = coarse.value(i, j), reference = fine.value(finer * i, finer * j);
      CHECK((std::isnan(value) || std::isfinite(reference)));  // a finer lattice has more ways
      if (!std::isfinite(value)) continue;
      outcome.worst = std::max(outcome.worst, std::abs(value - reference));
      outcome.largest = std::max(outcome.largest, reference);
    }
  return outcome;
}

}  // namespace

TEST_CASE("field: distances in a plane are exact to a thousandth of a cell") {
  const Problem problem = between(unit_box(), make_euclidean_cost(2), Vector2d(0.31, 0.42), Vector2d(0.9, 0.9));
  const CostField field = field_of(problem, 0.01);
  CHECK(field.method == "isotropic march");
  CHECK(field.count == std::array<std::int32_t, 2>{101, 101});
  CHECK_FALSE(field.directed);
  const double error = worst(field, [&](const Vector2d& x) { return (x - problem.source.u).norm(); });
  CHECK(error < 1e-5);
  CHECK(field.error >= error);
  // The nearest of two places.
  const std::vector<Eigen::VectorXd> two = {Vector2d(0.2, 0.2), Vector2d(0.7, 0.8)};
  CHECK(worst(costs_from(problem, two, {.resolution = 0.01}),
              [&](const Vector2d& x) { return std::min((x - two[0]).norm(), (x - two[1]).norm()); }) < 5e-4);
}

TEST_CASE("field: second order in a medium whose slowness has a gradient") {
  // Speed v = 1 + y: circles, t = acosh(1 + |x - a|^2 / (2 v(a) v(x))).
  const Problem problem = between(unit_box(), index_of("1 / (1 + y)"), Vector2d(0.1, 0.2), Vector2d(0.9, 0.9));
  const Truth truth = [&](const Vector2d& x) {
    return std::acosh(1 + (x - problem.source.u).squaredNorm() / (2 * (1 + problem.source.u[1]) * (1 + x[1])));
  };
  const CostField coarse = field_of(problem, 0.02), fine = field_of(problem, 0.01);
  const double before = worst(coarse, truth), after = worst(fine, truth);
  CAPTURE(before, after);
  CHECK(after < 2e-5);
  CHECK(after < before / 3);
  CHECK(fine.error >= after);
}

TEST_CASE("field: two media, by the law of refraction") {
  // n = 1 below y = 1/2 and 2 above; from below the least over where the line crosses, or along the border.
  const Problem problem =
      between(unit_box(), index_of("1.5 + 0.5 * tanh((y - 0.5) * 2000)"), Vector2d(0.2, 0.25), Vector2d(0.9, 0.9));
  const Vector2d a = problem.source.u;
  const Truth truth = [&](const Vector2d& x) {
    if (std::abs(x[1] - 0.5) < 0.011) return std::nan("");
    if (x[1] < 0.5) return (x - a).norm();
    const auto over = [&](double cross) {
      const Vector2d at(cross, 0.5);
      return (at - a).norm() + 2 * (x - at).norm();
    };
    double low = std::min(a[0], x[0]), high = std::max(a[0], x[0]);
    for (int k = 0; k < 60; ++k) {  // it is convex
      const double left = low + (high - low) / 3, right = high - (high - low) / 3;
      (over(left) < over(right) ? high : low) = over(left) < over(right) ? right : left;
    }
    return over(low);
  };
  const CostField field = field_of(problem, 0.01);
  const double error = worst(field, truth);
  CAPTURE(error, field.error);
  CHECK(error < 0.01);  // a jump is where one cell has it
  CHECK(field.error >= 0.5 * error);
}

TEST_CASE("field: around a disc, and behind a wall that nothing passes") {
  const auto disc = std::make_shared<const FreeSpace>(box(Vector2d(-1, -1), Vector2d(1, 1)),
                                                      FreeSpace::Obstacles{make_ball({Vector2d(0, 0), 0.4})}, 0.0);
  const Problem problem = between(disc, make_euclidean_cost(2), Vector2d(-0.8, 0.05), Vector2d(0.9, 0.9));
  const Truth truth = [&](const Vector2d& x) {
    return x.norm() < 0.4 + 1e-9 ? std::nan("") : around_disc(problem.source.u, x, 0.4);
  };
  const CostField field = field_of(problem, 0.02);
  const double error = worst(field, truth);
  CAPTURE(error, field.error);
  CHECK(error < 0.03);
  CHECK(field.error >= error);
  CHECK(std::isnan(field.value(50, 50)));
}

TEST_CASE("field: 100 random worlds against a finer field, with the error that is stated") {
  int understated = 0, worlds = 0;
  const int most = kSanitized ? 10 : 100;
  for (std::uint32_t seed = 1; worlds < most; ++seed, ++worlds) {
    World world(seed);
    std::shared_ptr<const ConstraintManifold> domain = unit_box();
    const bool among = seed % 2 == 0;
    const Vector2d source = world.place();
    if (among) {
      const FreeSpace::Obstacles discs = world.discs(source);
      domain = std::make_shared<const FreeSpace>(unit_box(), discs, 0.0);
    }
    const Problem problem = between(domain, index_of(world.density()), source, source + Vector2d(0.01, 0));
    const Outcome outcome = compared(problem, {source}, 0.025, 4);
    CAPTURE(seed, outcome.worst, outcome.stated, outcome.largest);
    CHECK(outcome.worst < (among ? 0.04 : 0.005) * outcome.largest);
    if (outcome.worst > outcome.stated) ++understated;
  }
  CAPTURE(understated);
  CHECK(understated <= worlds / 20);
}

TEST_CASE("field: costs that depend on the direction, from a place and to it") {
  const auto wind = make_zermelo_cost({.speed = "1", .flow = flow::Formula{{"0.5", "0.2"}}}, 2);
  const Problem problem = between(unit_box(), wind, Vector2d(0.4, 0.5), Vector2d(0.9, 0.9));
  for (const bool to : {false, true}) {
    const CostField field = field_of(problem, 0.02, to);
    CHECK(field.method == "arrival field");
    CHECK(field.directed);
    CHECK(field.asymmetry > 2.5);  // nearly (1 + w) / (1 - w), along the wind
    CHECK(field.asymmetry <= 3.34);
    const double error = worst(field, [&](const Vector2d& x) {
      if (x == problem.source.u) return std::nan("");
      return to ? move_cost(*wind, x, problem.source.u) : move_cost(*wind, problem.source.u, x);
    });
    CAPTURE(to, error, field.error);
    CHECK(error < 0.02);
    CHECK(field.error >= error);
  }
}

TEST_CASE("field: in strong winds the error falls with the step and is covered") {
  for (const double speed : {0.3, 0.8, 0.95})
    for (const double turn : {0.1, 0.7}) {
      const auto wind = make_zermelo_cost(
          {.speed = "1",
           .flow = flow::Formula{{std::to_string(speed * std::cos(turn)), std::to_string(speed * std::sin(turn))}}},
          2);
      const Problem problem = between(unit_box(), wind, Vector2d(0.4, 0.5), Vector2d(0.9, 0.9));
      const CostField field = field_of(problem, 0.025);
      const double most = *std::max_element(field.values.begin(), field.values.end());
      const double error = worst(field, [&](const Vector2d& x) {
        return x == problem.source.u ? 0.0 : move_cost(*wind, problem.source.u, x);
      });
      CAPTURE(speed, turn, error, field.error, most);
      CHECK(error < 0.004 * most);
      CHECK(field.error >= error);
    }
}

TEST_CASE("field: 100 random worlds whose cost depends on the direction") {
  int understated = 0;
  const int most = kSanitized ? 5 : 100;
  for (int seed = 1; seed <= most; ++seed) {
    World world(static_cast<std::uint32_t>(seed));
    const double turn = world.number(0, 3), ratio = world.number(1.2, 3);
    const Eigen::Matrix2d axes = Eigen::Rotation2Dd(turn).toRotationMatrix();
    MetricTensorOptions options;
    options.matrix = axes * Vector2d(1, ratio * ratio).asDiagonal() * axes.transpose();
    const auto cost = make_metric_tensor_cost(options, 2);
    const Problem problem = between(unit_box(), cost, world.place(), Vector2d(0.5, 0.5));
    const CostField field = field_of(problem, 0.04);
    const double error = worst(
        field, [&](const Vector2d& x) { return x == problem.source.u ? 0.0 : move_cost(*cost, problem.source.u, x); });
    CAPTURE(seed, ratio, error, field.error);
    CHECK(error < 0.1 * ratio);
    if (error > field.error) ++understated;
  }
  CHECK(understated <= most / 20);
}

TEST_CASE("field: nodes are on the values of a raster, and cells without data are not reached") {
  RasterGrid raster;
  raster.rows = 12, raster.columns = 16;
  raster.cell = Vector2d(2, 2);
  raster.corner = Vector2d(10, 20);
  raster.values.assign(12 * 16, 3);
  for (int row = 0; row < 12; ++row) raster.values[raster.index(row, 9)] = std::nan("");
  raster.source = "test";
  for (const auto interpolation : {CostMapInterpolation::bilinear, CostMapInterpolation::cells}) {
    const Problem problem =
        between(space(2), make_cost_map(raster, interpolation, 2), Vector2d(13, 25), Vector2d(15, 25));
    const CostField field = costs_from(problem, {problem.source.u});
    CHECK(field.count == std::array<std::int32_t, 2>{16, 12});
    CHECK(field.lower == Vector2d(11, 21));
    CHECK(field.step == Vector2d(2, 2));
    CHECK(field.value(7, 2) == Approx(3 * 12).margin(1e-6));
    CHECK(std::isnan(field.value(9, 2)));
    CHECK(std::isnan(field.value(12, 2)));
    CHECK_THROWS_WITH(costs_from(problem, {Vector2d(29, 25)}), Catch::Contains("no path leaves the place (29, 25)"));
  }
}

TEST_CASE("field: the way back has the cost that the field states") {
  for (int seed = 1; seed <= (kSanitized ? 3 : 20); ++seed) {
    World world(static_cast<std::uint32_t>(seed));
    const Problem problem = between(unit_box(), index_of(world.density()), world.place(), world.place());
    const CostField field = field_of(problem, 0.02);
    for (const auto& [i, j] : {std::pair(0, 0), std::pair(50, 3), std::pair(20, 41)}) {
      const std::vector<Vector2d> way = way_down(field, problem, field.node(i, j));
      CAPTURE(seed, i, j, way.size());
      CHECK(way.front() == Vector2d(problem.source.u));
      CHECK(way.back() == field.node(i, j));
      const double cost = cost_of_way(problem, way);
      CHECK(cost == Approx(field.value(i, j)).epsilon(0.005).margin(0.001));
    }
  }
  const auto wind = make_zermelo_cost({.speed = "1", .flow = flow::Formula{{"0.5", "0.2"}}}, 2);
  const Problem sail = between(unit_box(), wind, Vector2d(0.4, 0.5), Vector2d(0.9, 0.9));
  const CostField to = field_of(sail, 0.02, true);
  const std::vector<Vector2d> way = way_down(to, sail, Vector2d(0.9, 0.1));
  CHECK(way.back() == Vector2d(0.4, 0.5));
  CHECK(cost_of_way(sail, way) == Approx(move_cost(*wind, Vector2d(0.9, 0.1), Vector2d(0.4, 0.5))).epsilon(0.01));
}

TEST_CASE("field: ways are pulled tight") {
  // Around a disc, and in a medium whose speed is 1 + y, over a lattice of few nodes.
  const auto disc = std::make_shared<const FreeSpace>(box(Vector2d(-1, -1), Vector2d(1, 1)),
                                                      FreeSpace::Obstacles{make_ball({Vector2d(0, 0), 0.4})}, 0.0);
  const Problem around = between(disc, make_euclidean_cost(2), Vector2d(-0.8, 0.05), Vector2d(0.9, 0.9));
  const CostField lengths = field_of(around, 0.02);
  for (const Vector2d& to : {Vector2d(0.8, 0.0), Vector2d(0.7, -0.3), Vector2d(0.1, 0.42), Vector2d(-0.3, 0.8)}) {
    const double cost = cost_of_way(around, way_down(lengths, around, to));
    const double exact = around_disc(around.source.u, to, 0.4);
    CAPTURE(to[0], to[1], cost, exact);
    CHECK(cost >= exact * (1 - 1e-9));
    CHECK(cost <= exact * 1.003);
  }
  const Problem medium = between(unit_box(), index_of("1 / (1 + y)"), Vector2d(0.1, 0.2), Vector2d(0.9, 0.9));
  const CostField coarse = field_of(medium, 0.1);
  const Vector2d to(0.9, 0.3);
  const double exact = std::acosh(1 + (to - medium.source.u).squaredNorm() / (2 * 1.2 * 1.3));
  CHECK(cost_of_way(medium, way_down(coarse, medium, to)) == Approx(exact).epsilon(1e-4));
}

TEST_CASE("field: a way against a current that leaves few directions") {
  // Zermelo's river, whose velocity is (-y, 0): there and back differ, and most moves have no move back.
  const auto river = make_zermelo_cost({.speed = "1", .flow = flow::Formula{{"-y", "0"}}}, 2);
  const Problem sail = between(space(2), river, Vector2d(3.66, -1.86), Vector2d(0, 0));
  const CostField field = costs_from(sail, {sail.source.u}, {.resolution = 0.12});
  const std::vector<Vector2d> way = way_down(field, sail, Vector2d(0, 0));
  CHECK(way.front() == Vector2d(3.66, -1.86));
  CHECK(way.back() == Vector2d(0, 0));
  CHECK(cost_of_way(sail, way) == Approx(5.4579).epsilon(0.005));
}

TEST_CASE("field: a cost that is not positive or not finite is named with its value and place") {
  const auto from = [](const std::string& n, const Vector2d& source) {
    return costs_from(between(unit_box(), index_of(n), source, Vector2d(0.9, 0.9)), {source}, {.resolution = 0.05});
  };
  CHECK_THROWS_WITH(
      from("x - 5", Vector2d(0.5, 0.5)),
      Catch::Contains("no path leaves the place (0.5, 0.5): at (0.5, 0.5) the formula of n is not positive: "
                      "n = -4.5"));
  CHECK_THROWS_WITH(from("1 / (x - x)", Vector2d(0.5, 0.5)),
                    Catch::Contains("the formula of n is not finite: n = inf"));
  CHECK_THROWS_WITH(from("sqrt(x - 2)", Vector2d(0.5, 0.5)), Catch::Contains("the formula of n has no value"));
  const CostField half = from("0.5 - x", Vector2d(0.2, 0.2));
  CHECK_THAT(half.without_cost, Catch::Contains("the formula of n is not positive: n = -"));
  CHECK(from("1 + x", Vector2d(0.2, 0.2)).without_cost.empty());
}

TEST_CASE("field: nodes cover the box to its edges whatever the resolution") {
  const auto box = std::make_shared<const EuclideanManifold>(
      EuclideanManifoldOptions::of({Eigen::VectorXd(Vector2d(1, 2)), Eigen::VectorXd(Vector2d(2, 2.73))}));
  const Problem problem = between(box, make_euclidean_cost(2), Vector2d(1.2, 2.2), Vector2d(1.5, 2.5));
  for (const double resolution : {0.1, 0.09, 0.013}) {
    const CostField field = field_of(problem, resolution);
    CHECK((field.node(field.count[0] - 1, field.count[1] - 1) - Vector2d(2, 2.73)).norm() < 1e-12);
    CHECK(field.step.maxCoeff() <= resolution * (1 + 1e-9));
    CHECK(worst(field, [&](const Vector2d& x) { return (x - problem.source.u).norm(); }) < 5e-3 * resolution);
  }
  CHECK(field_of(problem, 0.1).step == Vector2d(0.1, 0.73 / 8));
  const CostField square = costs_from(problem, {problem.source.u}, {.resolution = 0.1, .equal_steps = true});
  CHECK(square.step == Vector2d(0.1, 0.1));
  CHECK(square.count == std::array<std::int32_t, 2>{11, 8});
}

TEST_CASE("field: why there is no way is said") {
  RasterGrid raster;
  raster.rows = 12, raster.columns = 16;
  raster.cell = Vector2d(1, 1);
  raster.corner = Vector2d(0, 0);
  raster.values.assign(12 * 16, 3);
  for (int row = 0; row < 12; ++row) raster.values[raster.index(row, 9)] = std::nan("");
  raster.source = "test";
  const Problem problem =
      between(space(2), make_cost_map(raster, CostMapInterpolation::cells, 2), Vector2d(3, 5), Vector2d(4, 5));
  const CostField field = costs_from(problem, {problem.source.u});
  CHECK_THROWS_WITH(way_down(field, problem, Vector2d(14, 5)), Catch::Contains("no path leads to the place (14, 5)"));
  CHECK_THROWS_WITH(way_down(field, problem, Vector2d(40, 5)), Catch::Contains("(40, 5) is outside the field"));
}

TEST_CASE("field: a corridor is how much longer a detour is") {
  const Problem problem = between(unit_box(), make_euclidean_cost(2), Vector2d(0.2, 0.5), Vector2d(0.8, 0.5));
  const CostField from = field_of(problem, 0.02);
  const CostField to = costs_from(problem, {problem.target.u}, {.resolution = 0.02, .to_places = true});
  const CostField sum = corridor(from, to);
  CHECK(worst(sum, [&](const Vector2d& x) {
          return (x - problem.source.u).norm() + (x - problem.target.u).norm() - 0.6;
        }) < 2e-5);
  CHECK_THROWS_WITH(corridor(from, field_of(problem, 0.04)), Catch::Contains("different nodes"));
}

TEST_CASE("field: a corridor between places beside each other is as much longer as it is") {
  const Problem problem = between(unit_box(), make_euclidean_cost(2), Vector2d(0.52, 0.53), Vector2d(0.56, 0.55));
  const double least = (problem.target.u - problem.source.u).norm();
  const CostField from = field_of(problem, 0.1);
  const CostField to = costs_from(problem, {problem.target.u}, {.resolution = 0.1, .to_places = true});
  const auto detour = [&](const Vector2d& x) {
    return (x - problem.source.u).norm() + (x - problem.target.u).norm() - least;
  };
  const CostField sum = corridor(from, to, least);
  CHECK(worst(sum, detour) <= sum.error);
  CHECK(sum.error < 0.05);
  CHECK(worst(corridor(from, to), detour) > sum.error);  // the nodes around have no shorter one
}

TEST_CASE("field: cells are joined by a corner that they share") {
  RasterGrid raster;
  raster.rows = raster.columns = 5;
  raster.cell = Vector2d(2, 1);
  raster.corner = Vector2d(400000, 5000000);
  raster.values.assign(25, std::nan(""));
  for (int k = 0; k < 5; ++k) raster.values[raster.index(k, k)] = 1 + k;  // as a road one cell wide
  raster.source = "test";
  const Vector2d first = raster.corner + Vector2d(1, 0.5), last = first + Vector2d(8, 4);
  const Problem problem = between(space(2), make_cost_map(raster, CostMapInterpolation::cells, 2), first, last);
  const CostField field = costs_from(problem, {problem.source.u});
  const double diagonal = std::sqrt(5.0), whole = diagonal * (0.5 + 2 + 3 + 4 + 2.5);
  CHECK(field.value(4, 4) == Approx(whole).epsilon(1e-6));
  CHECK(value_at(field, last) == Approx(whole).epsilon(1e-6));  // beside nodes without a value
  CHECK(cost_of_way(problem, way_down(field, problem, last)) == Approx(whole).epsilon(1e-9));
}

TEST_CASE("field: the way to a place near the source leads round dear cells") {
  RasterGrid raster;
  raster.rows = raster.columns = 7;
  raster.values.assign(49, 1);
  raster.cell = Vector2d(1, 1);
  raster.source = "test";
  raster.values[raster.index(3, 3)] = 100;
  const Problem problem =
      between(space(2), make_cost_map(raster, CostMapInterpolation::cells, 2), Vector2d(2.5, 3.5), Vector2d(4.5, 3.5));
  const CostField field = costs_from(problem, {problem.source.u});
  CHECK(cost_of_way(problem, way_down(field, problem, Vector2d(4.5, 3.5))) < 3);
}

TEST_CASE("field: sizes whose squares are no numbers are refused") {
  const Problem problem = between(box(Vector2d(0, 0), Vector2d(1e-300, 1e-300)), make_euclidean_cost(2), Vector2d(0, 0),
                                  Vector2d(1e-300, 0));
  CHECK_THROWS_WITH(costs_from(problem, {problem.source.u}), Catch::Contains("below 1e-75"));
}

TEST_CASE("field: what it does not do is said") {
  const Problem ring = closed(space(2), make_euclidean_cost(2));
  CHECK_THROWS_WITH(costs_from(ring, {Vector2d(0, 0)}), Catch::Contains("a ring has no source"));
  const Problem solid = between(space(3), make_euclidean_cost(3), Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0));
  CHECK_THROWS_WITH(costs_from(solid, {solid.source.u}), Catch::Contains("two coordinates"));
  const Problem globe = between(make_parametric_manifold({.surface = parametric::Sphere{}}), make_euclidean_cost(3),
                                Vector2d(0.3, 0.7), Vector2d(2.2, 0.9));
  // Beyond the pole a place has another name.
  CHECK(costs_from(globe, {Vector2d(0, 2)}).places[0][1] == Approx(std::numbers::pi - 2));
  const Problem plane = between(unit_box(), make_euclidean_cost(2), Vector2d(0.2, 0.5), Vector2d(0.8, 0.5));
  CHECK_THROWS_WITH(costs_from(plane, {}), Catch::Contains("at least one place"));
  CHECK_THROWS_WITH(costs_from(plane, {Vector2d(2, 0)}), Catch::Contains("(2, 0) is outside the box from (0, 0)"));
  CHECK_THROWS_AS(costs_from(plane, {Vector2d(0, std::nan(""))}), InputError);
  for (const double bad : {0.0, -1.0, 1e-9, std::nan(""), std::numeric_limits<double>::infinity()})
    CHECK_THROWS_AS(field_of(plane, bad), OptionError);
  CHECK_THROWS_AS(way_down(field_of(plane, 0.1), plane, Vector2d(std::nan(""), 0)), InputError);
  Monitor stops;
  stops.stop_requested = [] { return true; };
  CHECK_THROWS_AS(costs_from(plane, {plane.source.u}, {}, stops), Interrupted);
}

}  // namespace leastcost::test
