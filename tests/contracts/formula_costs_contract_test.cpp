// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Costs that are given by formulas, or made of other costs.
#include <leastcost/problems/costs/combined_cost.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/formula_cost.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/costs/refractive_index.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include "tests/contracts/cost_contract.hpp"

namespace leastcost::test {
namespace {

/// Points around (0, ..., 0, 2.5), above 1.5 in the last coordinate, and within a box.
std::function<Eigen::VectorXd(Random&)> above(int d) {
  return [d](Random& random) -> Eigen::VectorXd {
    return 2.5 * Eigen::VectorXd::Unit(d, d - 1) + 0.5 * random.vector(d).cwiseMax(-2).cwiseMin(2);
  };
}
/// Points within 0.5 or so of the origin.
std::function<Eigen::VectorXd(Random&)> around_origin(int d) {
  return [d](Random& random) -> Eigen::VectorXd { return 0.3 * random.vector(d); };
}

CostCase media(refraction::Index index, int d) {
  return {.cost = make_refractive_index_cost({std::move(index)}, d), .draw = above(d)};
}

CostCase lagrangian(const char* text, bool convexify = false) {
  const CheckedRegion region{Eigen::Vector2d(-1, 1), Eigen::Vector2d(1, 4)};
  return {.cost = make_formula_cost({.lagrangian = text, .convexify = convexify}, 2, region), .draw = above(2)};
}

std::shared_ptr<const SegmentCost> tensor() {
  MetricTensorOptions options;
  options.matrix = (Eigen::Matrix2d() << 4, 1, 1, 2).finished();
  return make_metric_tensor_cost(options, 2);
}
std::shared_ptr<const SegmentCost> half_plane() {
  return make_refractive_index_cost({refraction::PowerLaw{.exponent = -1}}, 2);
}
std::shared_ptr<const SegmentCost> wind() {
  return make_formula_cost({.lagrangian = "sqrt(vx^2 + vy^2) + 0.3*vx*cos(y)"}, 2, std::nullopt);
}

}  // namespace

TEST_CASE("cost contract: refractive_index", "[contract]") {
  for (const int d : {2, 3, 5}) {
    const Eigen::VectorXd up = Eigen::VectorXd::Unit(d, d - 1);
    CostCase linear = media(refraction::LinearVelocity{.speed = 0.2, .gradient = up}, d);
    linear.outside = {-0.3 * up, -5 * up};
    check_cost_contract(linear);
    CostCase luneburg = media(refraction::Luneburg{.radius = 2}, d);
    luneburg.draw = around_origin(d);
    luneburg.outside = {3 * up};
    check_cost_contract(luneburg);
    check_cost_contract(media(refraction::MaxwellFisheye{.peak = 3, .radius = 2}, d));
    CostCase power = media(refraction::PowerLaw{.exponent = d == 3 ? -0.5 : 1, .level = 0.1}, d);
    power.outside = {-up, -1e-8 * up};
    check_cost_contract(power);
    check_cost_contract(media(refraction::SmoothLayers{.boundaries = Eigen::Vector2d(2, 3),
                                                       .values = Eigen::Vector3d(1, 3, 2),
                                                       .values_are = refraction::LayerValues::speed,
                                                       .width = 0.7},
                              d));
  }
  check_cost_contract(media(refraction::Formula{"a + sin(x) * y / 9", {{"a", 2}}}, 2));
}

TEST_CASE("cost contract: travel_time, in a potential", "[contract]") {
  for (const int d : {2, 3, 4}) {
    const TravelTimeOptions options{.level = 9, .potential = d == 4 ? "x0^2 + sin(x1) - x3" : "x^2 + sin(y) * y"};
    check_cost_contract({.cost = make_travel_time_cost(options, d, std::nullopt),
                         .draw = around_origin(d),
                         .outside = {5 * Eigen::VectorXd::Unit(d, 0)}});
  }
}

TEST_CASE("cost contract: formula", "[contract]") {
  SECTION("a metric") { check_cost_contract(lagrangian("sqrt(vx^2 + vx*vy*sin(x) + 2*vy^2) / y")); }
  SECTION("wind") { check_cost_contract(lagrangian("sqrt(vx^2 + vy^2) + 0.3*vx*cos(y)")); }
  SECTION("a quartic norm") { check_cost_contract(lagrangian("(vx^4 + 4*vx^2*vy^2 + vy^4)^0.25 * (1 + x^2)")); }
}
TEST_CASE("cost contract: formula, in more dimensions", "[contract]") {
  for (const int d : {3, 4}) {
    const char* text =
        d == 3 ? "sqrt(vx^2 + vy^2 + vz^2) + 0.2*vx*sin(z)" : "sqrt(v0^2 + v1^2 + v2^2 + v3^2) + 0.2*v0*sin(x3)";
    check_cost_contract({.cost = make_formula_cost({.lagrangian = text}, d, std::nullopt), .draw = above(d)});
  }
}
TEST_CASE("cost contract: formula, its hull", "[contract]") {
  // Where F is the hull, and where it is linear in v: the directions of random moves are both. Its second derivatives
  // jump between them, which no Taylor slope across an edge survives: the draw keeps to fixed directions.
  const auto cost =
      lagrangian("sqrt(vx^2 + vy^2) * (1 + (0.8 + 0.1*sin(x)) * (2*vx*vy / (vx^2 + vy^2))^2) / y", true).cost;
  Random random;
  Points x(2, 4);
  for (const double angle : {0.02, 0.6, 0.9, 1.55, 2.3, -0.7, 3.15}) {
    const Eigen::Vector2d step(std::cos(angle), std::sin(angle));
    for (Index i = 0; i < 4; ++i)
      x.col(i) = Eigen::Vector2d(0, 3) + 0.3 * static_cast<double>(i) * step + 1e-3 * random.vector(2);
    CAPTURE(angle);
    CHECK(text(check_cost_derivatives(*cost, x, false, random.engine())) == "");
  }
}

TEST_CASE("cost contract: sum", "[contract]") {
  SECTION("under one metric") {
    check_cost_contract({.cost = make_sum_cost({{2, half_plane()}, {0.5, make_euclidean_cost(2)}}), .draw = above(2)});
  }
  SECTION("a norm") {
    check_cost_contract({.cost = make_sum_cost({{2, tensor()}, {0.5, make_euclidean_cost(2)}}), .draw = above(2)});
  }
  SECTION("asymmetric") {
    check_cost_contract({.cost = make_sum_cost({{2, wind()}, {0.5, half_plane()}}), .draw = above(2)});
  }
}

TEST_CASE("cost contract: scaled", "[contract]") {
  SECTION("a constant metric") {
    check_cost_contract({.cost = make_scaled_cost({"y - 0.4"}, tensor()),
                         .draw = above(2),
                         .outside = {Eigen::Vector2d(0, -9), Eigen::Vector2d(0, -20)}});
  }
  SECTION("a metric") {
    check_cost_contract(
        {.cost = make_scaled_cost({"1 + x^2"}, make_metric_field_cost({.field = metric::FisherRao{}}, 2)),
         .draw = above(2)});
  }
  SECTION("wind") { check_cost_contract({.cost = make_scaled_cost({"2 + sin(x)"}, wind()), .draw = above(2)}); }
  SECTION("a sum of itself") {
    check_cost_contract(
        {.cost = make_sum_cost({{1, make_scaled_cost({"y"}, make_euclidean_cost(2))}, {1, half_plane()}}),
         .draw = above(2)});
  }
}

}  // namespace leastcost::test
