// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/costs/walking_laws.hpp"

#include <cmath>

#include <leastcost/problems/costs/walking.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

/// Second difference of a pace, over its step squared.
template <class Pace>
double bend(const Pace& pace, double s, double h) {
  return (pace(s + h) - 2 * pace(s) + pace(s - h)) / (h * h);
}

double exact_tobler(double s) { return std::exp(3.5 * std::abs(s + 0.05)); }

}  // namespace

TEST_CASE("Tobler's law: rounded within delta of the kink, convex, never below") {
  const double delta = GENERATE(0.002, 0.01, 0.049);
  const ToblerPace pace{delta};
  for (int k = -4000; k <= 4000; ++k) {
    const double s = 1e-4 * k;
    const double excess = pace(s) / exact_tobler(s) - 1;
    if (std::abs(s + 0.05) >= delta)
      CHECK(std::abs(excess) < 1e-14);
    else
      CHECK((excess >= -1e-15 && excess <= pace.rounding(s) / pace(s) * (1 + pace.rounding(s)) + 1e-15));
    CHECK(bend(pace, s, 1e-5) > 0);
  }
  CHECK(pace(-0.05) == Approx(std::exp(3.5 * 0.375 * delta)).epsilon(1e-14));
  // Two derivatives go over.
  using Slope = Dual<Dual<double, 1>, 1>;
  for (const double edge : {-0.05 - delta, -0.05 + delta})
    for (const int order : {0, 1, 2}) {
      std::array<double, 2> sides{};
      for (const int side : {0, 1}) {
        Slope s(edge + (side == 0 ? -1e-12 : 1e-12));
        s.value.d[0] = 1, s.d[0].value = 1;
        const Slope f = pace(s);
        sides[static_cast<std::size_t>(side)] = order == 0 ? f.value.value : order == 1 ? f.d[0].value : f.d[0].d[0];
      }
      CHECK(sides[0] == Approx(sides[1]).epsilon(1e-5));
    }
}

TEST_CASE("Tobler's law: what rounding costs is delta times the derivative in delta") {
  for (const double s : {-0.058, -0.052, -0.05, -0.045, -0.03, 0.1}) {
    const double delta = 0.01, h = 1e-6;
    const double slope = (ToblerPace{delta + h}(s)-ToblerPace{delta - h}(s)) / (2 * h);
    CHECK(ToblerPace{delta}.rounding(s) == Approx(delta * slope).margin(1e-9));
  }
}

TEST_CASE("critical slopes: Tobler's are 2/7 and -2/7, Minetti's the least cost per height") {
  const HullSide up = hull_side(ToblerPace{0.01}, 1, 0, 0), down = hull_side(ToblerPace{0.01}, -1, 0, 0);
  CHECK(up.to == Approx(2.0 / 7).epsilon(1e-14));
  CHECK(down.to == Approx(2.0 / 7).epsilon(1e-14));
  CHECK(up.rise / 6 == Approx(1.88891671723881041).epsilon(1e-14));
  CHECK(down.rise / 6 == Approx(1.33109711310876049).epsilon(1e-14));
  const MinettiPace minetti;
  for (const double sign : {1.0, -1.0}) {
    const HullSide hull = hull_side(minetti, sign, 0, 0);
    for (double s = 0.01; s <= MinettiPace::kSteepest; s += 1e-3)
      CHECK(minetti(sign * s) / s >= hull.rise * (1 - 1e-12));
    CHECK(minetti(sign * hull.to) / hull.to == Approx(hull.rise).epsilon(1e-12));
    for (double s = 0; s < hull.to; s += 1e-3) CHECK(bend(minetti, sign * s, 1e-4) > 0);
  }
}

TEST_CASE("hulls: a pace goes over into its tangent with two derivatives, convex and never above the hull") {
  const auto check = [](const auto& pace, double sign) {
    const HullSide side = hull_side(pace, sign, 0.02, 1e-4), hull = hull_side(pace, sign, 0, 0);
    CHECK((side.from < hull.to && hull.to < side.to));
    CHECK(side.base == Approx(1e-4 * side.value).epsilon(1e-6));
    CHECK(side.going_over(side.from) == Approx(pace(sign * side.from)).epsilon(1e-14));
    CHECK(side.going_over(side.to) == Approx(side.base + side.rise * side.to).epsilon(1e-14));
    const auto over = [&](double x) { return side.going_over(x); };
    CHECK((over(side.to) - over(side.to - 1e-6)) / 1e-6 == Approx(side.rise).epsilon(1e-6));
    const auto own = [&](double x) { return pace(sign * x); };
    CHECK(bend(over, side.from + 1e-4, 1e-4) == Approx(bend(own, side.from, 1e-4)).epsilon(0.01));
    // What the second derivative loses while it falls to 0, bend t / width, twice integrated; and the tilt.
    const double below = 1.1 * side.bend * 0.02 * 0.02 / 6 + 1e-4 * side.value;
    for (double x = side.from; x < side.to; x += 1e-4) {
      const double exact = x < hull.to ? own(x) : hull.rise * x;
      CHECK(over(x) <= exact * (1 + 1e-14));
      CHECK(over(x) >= exact - below);
    }
    CHECK(side.rise < hull.rise);
  };
  for (const double sign : {1.0, -1.0}) {
    check(ToblerPace{0.01}, sign);
    check(MinettiPace{}, sign);
  }
}

TEST_CASE("walking: a convex cost, below every way in more moves and near the hull") {
  const auto cost = make_walking_cost({.length = MapLength::kilometres}, 3);
  Random random;
  for (int k = 0; k < 3000; ++k) {
    Eigen::Vector3d first = random.vector(3), second = random.vector(3);
    first[2] *= 0.5, second[2] *= 0.5;
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    const double whole = move_cost(*cost, none, first + second);
    CHECK(whole <= (move_cost(*cost, none, first) + move_cost(*cost, none, second)) * (1 + 1e-13));
    const double map = (first + second).head(2).norm(), slope = (first[2] + second[2]) / map;
    const double hull = slope > 2.0 / 7    ? slope * 1.88891671723881041
                        : slope < -2.0 / 7 ? -slope * 1.33109711310876049
                                           : exact_tobler(slope) / 6;
    CHECK(whole >= map * hull * (1 - 1e-3));
    CHECK(whole <= map * hull * (1 + 0.0132));
  }
}

}  // namespace leastcost::test
