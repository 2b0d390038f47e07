// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/energy/curve_value.hpp"

#include <numbers>

#include <leastcost/framework/cost/segment_cost_function.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/half_plane.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost::test {
TEST_CASE("the smooth curve through points of a geodesic: order 4 where the chain has 2", "[framework]") {
  const Problem problem =
      between(space(2), make_segment_cost(HalfPlane{}), Eigen::Vector2d(-1, 1), Eigen::Vector2d(1, 1));
  const double half = std::asinh(1.0);  // unit speed: (sqrt 2 tanh t, sqrt 2 / cosh t), t from -half to half
  std::vector<double> chain, curve;
  for (const int n : {8, 16, 32, 64}) {
    CoordinatePath path{Points(2, n + 1), {}, false};
    for (Index i = 0; i <= n; ++i) {
      const double t = half * (2.0 * static_cast<double>(i) / n - 1);
      path.u.col(i) << std::sqrt(2.0) * std::tanh(t), std::sqrt(2.0) / std::cosh(t);
    }
    chain.push_back(std::abs(PathEnergy(problem, 1).cost(path) - 2 * half));
    const std::optional<double> value = smooth_curve_cost(problem, path);
    REQUIRE(value);
    CHECK(*value > 2 * half);  // a curve between the ends: never better than the geodesic
    curve.push_back(*value - 2 * half);
  }
  for (std::size_t k = 1; k < curve.size(); ++k) {
    CHECK(std::log2(chain[k - 1] / chain[k]) == Approx(2).margin(0.1));
    CHECK(std::log2(curve[k - 1] / curve[k]) > 3.8);
  }
  CHECK(curve.back() < 1e-3 * chain.back());
}

TEST_CASE("the smooth curve of a ring closes", "[framework]") {
  const Problem problem = closed(space(2), make_euclidean_cost(2));
  CoordinatePath path{Points(2, 64), {}, true};
  for (Index i = 0; i < 64; ++i) {
    const double t = 2 * std::numbers::pi * static_cast<double>(i) / 64;
    path.u.col(i) << std::cos(t), std::sin(t);
  }
  const double h = 2 * std::numbers::pi / 64;
  CHECK(*smooth_curve_cost(problem, path) == Approx(2 * std::numbers::pi).epsilon(h * h * h * h));
}

TEST_CASE("no smooth curve on a curved domain, from rest, or with too few points", "[framework]") {
  const Problem sphere =
      between(std::make_shared<Sphere>(), make_euclidean_cost(3), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0));
  CHECK_FALSE(smooth_curve_cost(sphere, find(sphere, 9).path));
  const Problem rest = bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(2, -1));
  CHECK_FALSE(smooth_curve_cost(rest, find(rest, 9).path));
  const Problem line = between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0));
  CHECK_FALSE(smooth_curve_cost(line, find(line, 1).path));
}

TEST_CASE("where the smooth curve overshoots a bound, it follows the bound", "[framework]") {
  const Problem boxed = between(box(Eigen::Vector2d(-9, -9), Eigen::Vector2d(9, 1)), make_euclidean_cost(2),
                                Eigen::Vector2d(0, 0), Eigen::Vector2d(3, 0));
  const CoordinatePath plateau{(Points(2, 4) << 0, 1, 2, 3, 0, 1, 1, 0).finished(), {}, false};
  // y = t (3 - t) / 2 up to the lid at y = 1: two arcs of a parabola whose slopes run from 3/2 to 1/2, and a straight
  // piece.
  const auto arc = [](double slope) { return (slope * std::hypot(1, slope) + std::asinh(slope)) / 2; };
  const std::optional<double> cost = smooth_curve_cost(boxed, plateau);
  REQUIRE(cost);
  CHECK(*cost == Approx(2 * (arc(1.5) - arc(0.5)) + 1).epsilon(1e-7));
}

}  // namespace leastcost::test
