// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <fstream>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/walking.hpp>
#include <leastcost/problems/costs/zermelo.hpp>
#include "tests/contracts/cost_contract.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/refused_key.hpp"

namespace leastcost::test {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

CostCase zermelo_case(const ZermeloOptions& options, int dim, const std::filesystem::path& folder = {}) {
  return {.cost = make_zermelo_cost(options, dim, folder),
          .draw = [dim](Random& random) -> Eigen::VectorXd { return 0.5 * random.vector(dim); }};
}

ZermeloOptions by_formula(std::string speed, std::vector<std::string> velocity) {
  return {.speed = std::move(speed), .flow = flow::Formula{std::move(velocity)}, .parameters = {{"k", 0.3}}};
}

/// A walk over points whose slopes are those of the draw: height is `steepness` times a bounded function of the place.
CostCase walking_case(const WalkingOptions& options, double steepness) {
  return {.cost = make_walking_cost(options, 3), .draw = [steepness](Random& random) -> Eigen::VectorXd {
            const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
            return Eigen::Vector3d(x, y, steepness * (x + 0.5 * y));
          }};
}

}  // namespace

TEST_CASE("cost contract: zermelo", "[contract]") {
  check_cost_contract(zermelo_case({.speed = "1", .flow = flow::Uniform{Eigen::Vector2d(0.4, 0.3)}}, 2));
  check_cost_contract(zermelo_case({.speed = "2", .flow = flow::Uniform{Eigen::Vector3d(0.4, -0.3, 1)}}, 3));
  check_cost_contract(zermelo_case(by_formula("1.5 + k * sin(x)", {"-k * y", "k * cos(2 * x)"}), 2));
  check_cost_contract(zermelo_case(by_formula("1.5", {"k * z", "k * sin(x)", "k * x * y"}), 3));
}

TEST_CASE("cost contract: zermelo, grid", "[contract]") {
  const ScratchDir folder;
  std::ofstream out(folder / "flow.csv");
  out << "x,y,u,v\n";
  for (int j = 0; j <= 16; ++j)
    for (int i = 0; i <= 16; ++i) {
      const double x = -2 + 0.25 * i, y = -2 + 0.25 * j;
      out << x << ',' << y << ',' << 0.4 * std::sin(x + y) << ',' << 0.3 * std::cos(x * y) << '\n';
    }
  out.close();
  CostCase grid = zermelo_case({.speed = "1", .flow = flow::Grid{"flow.csv"}}, 2, folder.path());
  grid.outside = {Eigen::Vector2d(2.5, 0), Eigen::Vector2d(0, -3)};
  check_cost_contract(grid);
}

TEST_CASE("cost contract: walking", "[contract]") {
  const double steepness = GENERATE(0.01, 0.1, 0.2, 0.6);
  check_cost_contract(walking_case({}, steepness));
  check_cost_contract(
      walking_case({.law = walking::Tobler{.unit = WalkingTime::seconds}, .rounding = 0.04}, steepness));
  check_cost_contract(walking_case({.law = walking::Minetti{}, .length = MapLength::kilometres}, steepness));
}

TEST_CASE("zermelo: what cannot be is named", "[contract]") {
  const auto key = [](const ZermeloOptions& options, int dim = 2) {
    return refused_key([&] { make_zermelo_cost(options, dim); });
  };
  const flow::Uniform calm{Eigen::Vector2d(0, 0)};
  CHECK(key({.flow = calm}) == "speed");
  CHECK(key({.speed = "-1", .flow = calm}) == "speed");
  CHECK(key({.speed = "1 + q", .flow = calm}) == "speed");
  CHECK(key({.speed = "1", .flow = calm}, 3) == "flow.velocity");
  CHECK(key({.speed = "1", .flow = calm}, 7) == "type");
  CHECK(key({.speed = "1", .flow = flow::Uniform{Eigen::Vector2d(kInfinite, 0)}}) == "flow.velocity");
  CHECK(key(by_formula("1", {"-y"})) == "flow.velocity");
  CHECK(key(by_formula("1", {"-y", "2 *"})) == "flow.velocity.1");
}

TEST_CASE("zermelo: moves that the flow does not allow, and why", "[contract]") {
  const auto cost = make_zermelo_cost(by_formula("1", {"-2 * y", "0"}), 2);
  const auto why = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return reason_for_infinity(*cost, a, b); };
  // At y = -1 the current has twice the speed of the boat: 30 degrees around its direction are open.
  const double edge = std::acos(-1.0) / 6;
  const auto move = [&](double angle) {
    const Eigen::Vector2d half(0.05 * std::cos(angle), 0.05 * std::sin(angle)), at(3, -1);
    return move_cost(*cost, at - half, at + half);
  };
  CHECK(move(edge - 1e-6) < kInfinite);
  CHECK(move(-edge + 1e-6) < kInfinite);
  CHECK(move(edge + 1e-6) == kInfinite);
  CHECK(move(std::acos(-1.0)) == kInfinite);
  CHECK(move(0) == Approx(0.1 / 3));  // with the current
  CHECK(why({3, -1}, {2, -1}).find("at (2.5, -1)") != std::string::npos);
  CHECK(why({3, -1}, {2, -1}).find("within 30 degrees") != std::string::npos);
  CHECK(why({3, -1}, {4, -1}) == "");
  const auto slow = make_zermelo_cost(by_formula("x", {"0", "0"}), 2);
  CHECK(
      reason_for_infinity(*slow, Eigen::Vector2d(-2, 0), Eigen::Vector2d(-1, 0)).find("speed of the vehicle is -1.5") !=
      std::string::npos);
}

TEST_CASE("walking: what cannot be is named", "[contract]") {
  const auto key = [](const WalkingOptions& options, int dim = 3) {
    return refused_key([&] { make_walking_cost(options, dim); });
  };
  CHECK(key({}, 2) == "type");
  CHECK(key({.rounding = 0.05}) == "rounding");
  CHECK(key({.rounding = 0}) == "rounding");
  CHECK(key({.law = walking::Tobler{.speed_factor = -1}}) == "law.speed_factor");
  CHECK(key({}) == "");
}

}  // namespace leastcost::test
