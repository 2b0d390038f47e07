// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/distance/distance_grid.hpp>

#include <limits>

#include <leastcost/framework/base/errors.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector3d;

template <class Function>
DistanceGrid sampled(const GridShape& shape, Function f) {
  std::vector<double> values;
  for (int k = 0; k < shape.count[2]; ++k)
    for (int j = 0; j < shape.count[1]; ++j)
      for (int i = 0; i < shape.count[0]; ++i) values.push_back(f(shape.node(i, j, k)));
  return DistanceGrid(shape, std::move(values));
}

double wave(const Vector3d& x) { return std::sin(2 * x[0] + 0.3) * std::cos(x[1] - x[2]) + x[2] * x[0]; }
Vector3d wave_gradient(const Vector3d& x) {
  const double s = std::sin(2 * x[0] + 0.3), c = std::cos(2 * x[0] + 0.3);
  return {2 * c * std::cos(x[1] - x[2]) + x[2], -s * std::sin(x[1] - x[2]), s * std::sin(x[1] - x[2]) + x[0]};
}

GridShape cube(int count) { return {Vector3d(-1, -0.5, 2), 2.0 / (count - 1), {count, count, count}}; }

std::string refusal(const GridShape& shape, std::vector<double> values) {
  try {
    DistanceGrid(shape, std::move(values));
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("distance grid: second derivatives are those of its gradient") {
  constexpr double kStep = 1e-5;
  const DistanceGrid grid = sampled(cube(12), wave);
  REQUIRE(grid.knows_curvature());
  Random random;
  Eigen::VectorXd weight(1);
  weight[0] = -1.7;
  Points bend(3, 3);
  for (int n = 0; n < 50; ++n) {
    const Vector3d x(random.uniform(-0.9, 0.9), random.uniform(-0.4, 1.4), random.uniform(2.1, 3.9));
    grid.curvature(x, weight, bend);
    for (int axis = 0; axis < 3; ++axis) {
      Vector3d before, after;
      grid.evaluate(x - kStep * Vector3d::Unit(axis), before);
      grid.evaluate(x + kStep * Vector3d::Unit(axis), after);
      const Vector3d differences = weight[0] * (after - before) / (2 * kStep);
      CHECK((bend.col(axis) - differences).norm() < 1e-3);  // third derivatives jump between cells
    }
  }
  grid.curvature(Vector3d(9, 9, 9), weight, bend);
  CHECK(!bend.allFinite());
}

// A spline of degree three with clamped ends whose slopes are exact for cubics reproduces every tricubic polynomial, up
// to the border.
TEST_CASE("distance grid: tricubic polynomials are reproduced") {
  const auto cubic = [](const Vector3d& x) {
    return 1 + x[0] * x[0] * x[0] * x[1] - 2 * x[1] * x[1] * x[1] * x[2] * x[2] +
           x[2] * x[2] * x[2] * x[0] * x[1] * x[1];
  };
  const DistanceGrid grid = sampled({Vector3d(-0.3, 0.1, 0.2), 0.1, {6, 9, 4}}, cubic);
  Random random;
  for (int n = 0; n < 200; ++n) {
    const Vector3d x(random.uniform(-0.3, 0.2), random.uniform(0.1, 0.9), random.uniform(0.2, 0.5));
    Vector3d gradient;
    CHECK(grid.evaluate(x, gradient) == Approx(cubic(x)).margin(1e-14));
    CHECK(gradient[0] == Approx(3 * x[0] * x[0] * x[1] + x[2] * x[2] * x[2] * x[1] * x[1]).margin(1e-13));
  }
}

TEST_CASE("distance grid: order 4 in value and 3 in gradient, border included") {
  Random random;
  std::vector<Vector3d> places;
  for (int n = 0; n < 400; ++n)
    places.emplace_back(Vector3d(-1, -0.5, 2) +
                        2 * Vector3d(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)));
  double last_value = 0, last_gradient = 0;
  for (const int count : {17, 33, 65}) {
    const DistanceGrid grid = sampled(cube(count), wave);
    double value = 0, slope = 0;
    for (const Vector3d& x : places) {
      Vector3d gradient;
      value = std::max(value, std::abs(grid.evaluate(x, gradient) - wave(x)));
      slope = std::max(slope, (gradient - wave_gradient(x)).norm());
    }
    if (last_value > 0) {
      CHECK(std::log2(last_value / value) > 3.7);
      CHECK(std::log2(last_gradient / slope) > 2.7);
    }
    last_value = value;
    last_gradient = slope;
  }
}

// The value 2^-20 of a cell before and behind a face of the cells: with two continuous derivatives the third difference
// there is O(cell^-3) h^3.
TEST_CASE("distance grid: two continuous derivatives across the faces of the cells") {
  Random random;
  const GridShape shape = cube(9);
  std::vector<double> values(shape.nodes());
  for (double& v : values) v = random.uniform(-1, 1);
  const DistanceGrid grid(shape, values);
  for (int n = 0; n < 30; ++n) {
    Vector3d x = shape.node(random.integer(1, 7), random.integer(1, 7), random.integer(1, 7));
    const int axis = n % 3;
    for (int a = 0; a < 3; ++a)
      if (a != axis) x[a] += shape.cell * random.uniform(0, 0.99);
    const double h = 1e-4 * shape.cell;
    const Vector3d e = h * Vector3d::Unit(axis);
    Vector3d before, at, after;
    grid.evaluate(x - e, before);
    grid.evaluate(x, at);
    grid.evaluate(x + e, after);
    const double jump = (after - 2 * at + before).norm() / h;  // of second derivatives, plus h times third ones
    CHECK(jump <= 50 * h / std::pow(shape.cell, 3));
  }
}

TEST_CASE("distance grid: values at nodes, every second node, raised") {
  const DistanceGrid grid = sampled({Vector3d::Zero(), 0.25, {9, 11, 13}}, wave);
  const DistanceGrid half = grid.every_second();
  CHECK(half.shape().cell == 0.5);
  CHECK(half.shape().count == std::array<int, 3>{5, 6, 7});
  Vector3d gradient;
  for (int i = 0; i < 5; ++i) {
    const Vector3d x = half.shape().node(i, i, i);
    CHECK(grid.at_node(2 * i, 2 * i, 2 * i) == Approx(wave(x)).margin(1e-14));
    CHECK(half.at_node(i, i, i) == Approx(wave(x)).margin(1e-14));
    CHECK(grid.raised(0.5).evaluate(x, gradient) == Approx(wave(x) + 0.5).margin(1e-14));
  }
  CHECK_THROWS_AS(half.every_second(), InputError);
}

TEST_CASE("distance grid: not finite outside, nothing else is refused inside") {
  const DistanceGrid grid = sampled(cube(5), wave);
  Vector3d gradient;
  for (const Vector3d& x : {grid.shape().origin, grid.shape().upper(), grid.shape().node(2, 4, 0)})
    CHECK(grid.evaluate(x, gradient) == Approx(wave(x)).margin(1e-13));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vector3d& x :
       {Vector3d(-1.0001, 0, 3), Vector3d(0, 0, 4.0001), Vector3d(nan, 0, 3), Vector3d(1e300, 0, 3)}) {
    CHECK(std::isnan(grid.evaluate(x, gradient)));
    CHECK(!gradient.allFinite());
  }
}

TEST_CASE("distance grid: what is no grid is refused") {
  CHECK_THAT(refusal({Vector3d::Zero(), 1, {3, 9, 9}}, std::vector<double>(243)), Catch::Contains("at least 4 nodes"));
  CHECK_THAT(refusal(cube(4), std::vector<double>(63)), Catch::Contains("63 values for a grid of 64"));
  std::vector<double> values(64);
  values[5] = std::numeric_limits<double>::infinity();
  CHECK_THAT(refusal(cube(4), values), Catch::Contains("not finite"));
}

TEST_CASE("grid shape: around a box, with a limit on memory that says what fits") {
  const Eigen::AlignedBox3d box(Vector3d(-1, -1, -1), Vector3d(1, 1, 2));
  const GridShape shape = grid_around(box, 0.1, 8, 1e9);
  for (const int count : shape.count) CHECK(count % 4 == 1);
  CHECK((shape.origin.array() <= box.min().array() - 0.8 + 1e-12).all());
  CHECK((shape.upper().array() >= box.max().array() + 0.8 - 1e-12).all());
  const auto message = [&](double cell) -> std::string {
    try {
      grid_around(box, cell, 8, 24e6);
      return "accepted";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  CHECK(message(0.05) == "accepted");
  const std::string refused = message(1e-3);
  CHECK_THAT(refused, Catch::Contains("2016 x 2016 x 3016 cells") && Catch::Contains("22.9 MiB"));
  const double fits = std::stod(refused.substr(refused.find("a cell of ") + 10));
  CHECK(message(fits) == "accepted");
  CHECK(message(0.9 * fits) != "accepted");
  CHECK_THAT(message(1e-300), Catch::Contains("memory limit"));
  CHECK_THROWS_AS(grid_around(box, 0, 8, 1e9), OptionError);
  CHECK_THROWS_AS(grid_around(box, std::numeric_limits<double>::quiet_NaN(), 8, 1e9), OptionError);
  CHECK_THROWS_AS(grid_around(Eigen::AlignedBox3d(), 1, 8, 1e9), InputError);
}

}  // namespace leastcost::test
