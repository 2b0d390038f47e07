// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Zermelo's problem, docs/oracles.md D5: both directions, certified, and the truth within the bar.
#include <cmath>
#include <fstream>

#include <leastcost/problems/costs/zermelo.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/data.hpp"

using Catch::Contains;

namespace leastcost::test {
namespace {

constexpr double kBrysonHo = 5.45786526356;

std::shared_ptr<const SegmentCost> uniform(double u, double v) {
  return make_zermelo_cost({.speed = "1", .flow = flow::Uniform{Eigen::Vector2d(u, v)}}, 2);
}
std::shared_ptr<const SegmentCost> shear() {
  return make_zermelo_cost({.speed = "1", .flow = flow::Formula{{"-y", "0"}}}, 2);
}

Result sail(std::shared_ptr<const SegmentCost> cost, const Eigen::VectorXd& from, const Eigen::VectorXd& to, int n,
            const Initializer& initializer = StraightInitializer(), const Solver& solver = Newton()) {
  return find(between(space(static_cast<int>(from.size())), std::move(cost), from, to), n, initializer, solver);
}

void check_arrival(const Result& result, double truth, double widest) {
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(result.costs.size(), truth, e.value, e.error, e.method, failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(result.certificate.scope == Scope::local);
  CHECK(result.certificate.asymmetry.has_value());
  CHECK(std::abs(e.value - truth) <= e.error);
  CHECK(e.error <= widest * truth);
}

WaypointsInitializer through(const Points& points) { return WaypointsInitializer(points); }

}  // namespace

TEST_CASE("D5: Zermelo in a constant wind", "[oracle]") {
  const Eigen::Vector2d a(0, 0), b(3, 1);
  const int n = GENERATE(5, 16, 64);
  const double there = 2.16333199893226547, back = 6.16333199893226547;
  const BowInitializer bow({.height = 0.2});
  check_arrival(sail(uniform(0.4, 0.3), a, b, n, bow), there, 1e-11);
  check_arrival(sail(uniform(0.4, 0.3), b, a, n, bow), back, 1e-11);
  check_arrival(sail(uniform(0.4, 0.3), b, a, n, bow, Lbfgs()), back, 1e-11);
  // In space, and where the wind is faster than the vehicle: |d| / (w + V) along it.
  const auto gale = make_zermelo_cost({.speed = "1", .flow = flow::Uniform{Eigen::Vector3d(0, 3, 0)}}, 3);
  check_arrival(sail(gale, Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 2, 0), n), 0.5, 1e-11);
}

TEST_CASE("D5: Zermelo in a shear current", "[oracle]") {
  const Eigen::Vector2d a(2, -0.8), b(0, 0.6);
  const auto [n, widest] =
      GENERATE(std::pair(9, 1e-4), std::pair(17, 1e-5), std::pair(64, 1e-8), std::pair(200, 1e-10));
  check_arrival(sail(shear(), a, b, n), 2.40961645307160186, widest);
  check_arrival(sail(shear(), b, a, n), 2.14281188063285385, widest);
  if (n == 64) check_arrival(sail(shear(), a, b, n, StraightInitializer(), Lbfgs()), 2.40961645307160186, widest);
}

TEST_CASE("D5: Bryson and Ho, a current faster than the boat, from waypoints", "[oracle]") {
  const Eigen::Vector2d a(3.66, -1.86), b(0, 0);
  Points waypoints(2, 5);
  waypoints << 4.4, 5.1, 5.2, 4.5, 2,  //
      -1.5, -1, -0.5, 0.5, 0.9;
  const auto [n, widest] = GENERATE(std::pair(16, 1e-5), std::pair(64, 1e-7), std::pair(200, 1e-9));
  const Result result = sail(shear(), a, b, n, through(waypoints));
  check_arrival(result, kBrysonHo, widest);
  // The way back from where the boat cannot go against the current.
  CHECK(*result.certificate.asymmetry == std::numeric_limits<double>::infinity());
}

TEST_CASE("D5: no straight line against a current: the place is named", "[oracle]") {
  CHECK_THROWS_WITH(sail(shear(), Eigen::Vector2d(3.66, -1.86), Eigen::Vector2d(0, 0), 32),
                    Contains("the flow has speed 1.8") && Contains("waypoints"));
}

TEST_CASE("D5: a current on a grid", "[oracle]") {
  // -y is reproduced exactly; what is left is the chain.
  const ScratchDir folder;
  std::ofstream out(folder / "current.csv");
  out << "u,v,x,y\n";
  for (int j = 0; j <= 12; ++j)
    for (int i = 0; i <= 9; ++i) out << 1.5 - 0.25 * j << ",0," << -0.5 + 0.5 * i << ',' << -1.5 + 0.25 * j << '\n';
  out.close();
  const auto current = make_zermelo_cost({.speed = "1", .flow = flow::Grid{"current.csv"}}, 2, folder.path());
  check_arrival(sail(current, Eigen::Vector2d(2, -0.8), Eigen::Vector2d(0, 0.6), 64), 2.40961645307160186, 1e-8);
  check_arrival(sail(current, Eigen::Vector2d(0, 0.6), Eigen::Vector2d(2, -0.8), 64), 2.14281188063285385, 1e-8);
}

}  // namespace leastcost::test
