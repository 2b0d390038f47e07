// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/domain/around_pole.hpp"

#include <leastcost/problems/manifolds/earth.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "framework/energy/curve_value.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;

/// To the coordinates beside the pole and back, with a velocity.
void check_round_trip(const HasChart& chart, const ConstraintManifold& domain, const Vector2d& u,
                      const Vector2d& velocity) {
  const double h = 1e-6;
  const std::optional<AroundPole> around = AroundPole::of(chart, u);
  REQUIRE(around);
  const Points p = around->flat((Points(2, 3) << u - h * velocity, u, u + h * velocity).finished());
  Vector2d back, moved;
  around->chart_of(p.col(1), (p.col(2) - p.col(0)) / (2 * h), back, moved);
  const auto place = [&](const Vector2d& at) { return positions(domain, {at, {}, true}); };
  const Points x = place(u);
  CHECK((place(back) - x).norm() <= 1e-12 * x.norm());
  CHECK((place(back + h * moved) - place(u + h * velocity)).norm() <= 1e-9 * x.norm());
}

}  // namespace

TEST_CASE("coordinates beside a pole go there and back", "[framework]") {
  const EarthManifold earth;
  check_round_trip(earth, earth, {85, 170}, {1, -20});
  check_round_trip(earth, earth, {94, -30}, {-1, 20});
  check_round_trip(earth, earth, {-80, 700}, {2, 3});
  const auto sphere = make_parametric_manifold({.surface = parametric::Sphere{}});
  check_round_trip(*sphere, *sphere, {3, -1.4}, {-0.2, 0.1});
  const auto bowl = make_parametric_manifold({.surface = parametric::Paraboloid{}});
  check_round_trip(*bowl, *bowl, {1, 0.3}, {-0.2, 0.1});
  CHECK_FALSE(AroundPole::of(earth, Vector2d(40, 20)));
  CHECK_FALSE(AroundPole::of(*make_parametric_manifold({.surface = parametric::Torus{}}), Vector2d(0, 0)));
}

TEST_CASE("the curve through points beside a pole, and over it, has order four", "[framework]") {
  const auto sphere = make_parametric_manifold({.surface = parametric::Sphere{}});
  const auto excess = [&](double off, int segments) {  // a great circle that passes the pole at a distance
    CoordinatePath path{Points(2, segments + 1), {}, false};
    for (int i = 0; i <= segments; ++i) {
      const double t = -0.9 + 1.8 * i / segments;
      const Eigen::Vector3d x(std::sin(t), std::cos(t) * std::sin(off), std::cos(t) * std::cos(off));
      path.u.col(i) << std::atan2(x[1], x[0]), std::asin(std::min(1.0, x[2]));
    }
    const Problem problem = between(sphere, make_euclidean_cost(3), path.u.col(0), path.u.col(segments));
    return smooth_curve_cost(problem, path).value() - 1.8;
  };
  for (const double off : {0.3, 0.02, 1e-3, 0.0}) {
    CAPTURE(off);
    CHECK(excess(off, 33) >= -1e-13);
    CHECK(excess(off, 33) <= 1e-8);
    CHECK(excess(off, 65) <= 1e-9);
  }
}

}  // namespace leastcost::test
