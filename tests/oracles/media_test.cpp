// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Rays, beads and catenaries under the costs of the library: docs/oracles.md D4 and D5.
#include <cmath>
#include <numbers>

#include <leastcost/problems/costs/refractive_index.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

std::shared_ptr<const SegmentCost> medium(refraction::Index index, int dim = 2) {
  return make_refractive_index_cost({std::move(index)}, dim);
}

Result ray(std::shared_ptr<const SegmentCost> cost, const Eigen::Vector2d& source, const Eigen::Vector2d& target,
           int n) {
  return find(between(space(2), std::move(cost), source, target), n);
}

/// Certified, and the truth lies within the error bar, which is not simply wide.
void check_covered(const Result& result, double truth, double widest) {
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(result.costs.size(), truth, e.value, e.error, e.method, failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(std::abs(e.value - truth) <= e.error);
  CHECK(e.error <= widest * truth);
}

bool is_proved(const Result& result) {
  const auto& resolution = result.certificate.resolution;
  return resolution && resolution->verdict == ResolutionVerdict::proved && resolution->minimum_proved;
}

bool has_note(const Result& result, const std::string& part) {
  for (const std::string& note : result.notes)
    if (note.find(part) != std::string::npos) return true;
  return false;
}

/// Offset and time of a ray with parameter p (sin of its angle over the speed) through speeds v(z), z from 0 to depth:
/// x = int p v / sqrt(1 - p^2 v^2) dz, T = int 1 / (v sqrt(1 - p^2 v^2)) dz, by Simpson's rule.
struct StratifiedRay {
  double offset = 0, time = 0;
  template <class Speed>
  StratifiedRay(const Speed& speed, double depth, double p) {
    constexpr int kSteps = 20000;
    for (int i = 0; i <= kSteps; ++i) {
      const double v = speed(depth * i / kSteps), cosine = std::sqrt(1 - p * p * v * v);
      const double w = (i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2) * depth / kSteps / 3;
      offset += w * p * v / cosine;
      time += w / (v * cosine);
    }
  }
};

}  // namespace

TEST_CASE("D5: linear velocity, Luneburg's lens and Maxwell's fisheye", "[oracle]") {
  const int n = GENERATE(12, 64);
  const double widest = n == 12 ? 1e-3 : 1e-5;
  SECTION("linear velocity") {
    const auto cost = medium(refraction::LinearVelocity{.speed = 1, .gradient = Eigen::Vector2d(0, 0.5)});
    const Result result = ray(cost, {0, 0}, {4, 1}, n);
    check_covered(result, 3.05937323665641694, widest);
    CHECK(is_proved(result));
    CHECK(cost->traits().unit == "time");
  }
  SECTION("Luneburg") {
    const auto cost = medium(refraction::Luneburg{});
    for (const auto& [angle, truth] :
         {std::pair(0.5, 2.44837888868526934), std::pair(std::numbers::pi / 3, 2.07079632679489662)}) {
      const Result result = ray(cost, {-1, 0}, {std::cos(angle), std::sin(angle)}, n);
      check_covered(result, truth, widest);
    }
  }
  SECTION("Luneburg, moved and larger") {
    const auto cost = medium(refraction::Luneburg{.radius = 2, .center = Eigen::Vector2d(1, 3)});
    check_covered(ray(cost, {-1, 3}, {1 + 2 * std::cos(0.5), 3 + 2 * std::sin(0.5)}, n), 2 * 2.44837888868526934,
                  widest);
  }
  SECTION("fisheye") {
    const Result result = ray(medium(refraction::MaxwellFisheye{}), {0.5, -0.2}, {-0.7, 0.9}, n);
    check_covered(result, 2.47561986411056569, widest);
  }
}

TEST_CASE("D5: a fisheye in space and in four dimensions is that of the plane through its centre", "[oracle]") {
  const int d = GENERATE(3, 4);
  Eigen::VectorXd a = Eigen::VectorXd::Zero(d), b = a;
  a.tail(2) << 0.5, -0.2, b.tail(2) << -0.7, 0.9;
  const Result result = find(between(space(d), medium(refraction::MaxwellFisheye{}, d), a, b), 32);
  check_covered(result, 2.47561986411056569, 1e-4);
}

TEST_CASE("D3: a hill by formula: both ways around it, and the straight saddle", "[oracle]") {
  const auto cost = medium(refraction::Formula{"1 + h * exp(-x^2 - y^2)", {{"h", 2}}});
  const Problem problem = between(space(2), cost, Eigen::Vector2d(-2, 0), Eigen::Vector2d(2, 0));
  for (const double angle : {0.0, 180.0}) {
    const Result result = find(problem, 64, BowInitializer({.height = 0.5, .angle = angle}));
    check_covered(result, 6.030127200428, 1e-4);
  }
  const Result straight = find(problem, 64);
  CHECK(straight.certificate.index.verdict == IndexVerdict::saddle);
  CHECK(straight.curve.cost == Approx(7.52832556304968672).epsilon(1e-3));
}

TEST_CASE("smooth layers against the integrals of stratified rays", "[oracle]") {
  // Speeds 1, 1.5, 2.5 with boundaries at -1 and -2, from the surface down to z = -3.
  const double width = GENERATE(0.1, 0.3);
  const auto speed = [&](double depth) {
    return 1 + 0.25 * (1 + std::tanh((depth - 1) / width)) + 0.5 * (1 + std::tanh((depth - 2) / width));
  };
  double low = 0, high = 1 / speed(3) * (1 - 1e-12);
  for (int i = 0; i < 60; ++i) {
    const double p = (low + high) / 2;
    (StratifiedRay(speed, 3, p).offset < 2 ? low : high) = p;
  }
  const double truth = StratifiedRay(speed, 3, low).time;
  const auto cost = medium(refraction::SmoothLayers{.boundaries = Eigen::Vector2d(1, 2),
                                                    .values = Eigen::Vector3d(1, 1.5, 2.5),
                                                    .values_are = refraction::LayerValues::speed,
                                                    .width = width,
                                                    .normal = Eigen::Vector2d(0, -2)});
  check_covered(ray(cost, {0, 0}, {2, -3}, 100), truth, 1e-4);
}

TEST_CASE("D4: the power-law family, as a cost of the library", "[oracle]") {
  const int n = GENERATE(12, 64);
  const double widest = n == 12 ? 1e-3 : 1e-5;
  const auto power = [](double k) { return medium(refraction::PowerLaw{.exponent = k}); };
  SECTION("half-plane") { check_covered(ray(power(-1), {0, 1}, {2, 3}, n), 1.49099630899480838, widest); }
  SECTION("line") { check_covered(ray(power(0), {0, 1}, {3, 5}, n), 5, widest); }
  SECTION("parabola") { check_covered(ray(power(0.5), {0, 1}, {1, 2}, n), 1.71528231633382749, widest); }
  SECTION("catenary") { check_covered(ray(power(1), {-0.5, 1}, {0.5, 1}, n), 0.953624106702002751, widest); }
  SECTION("catenary above another level") {
    const auto cost = medium(refraction::PowerLaw{.exponent = 1, .level = -3});
    check_covered(ray(cost, {-0.5, -2}, {0.5, -2}, n), 0.953624106702002751, widest);
  }
}

TEST_CASE("D4: a catenary that Goldschmidt's solution undercuts is certified, and the note names it", "[oracle]") {
  const auto cost = medium(refraction::PowerLaw{.exponent = 1});
  const bool bounded = GENERATE(false, true);
  const auto domain = bounded ? box(Eigen::Vector2d(-10, 0), Eigen::Vector2d(10, 10)) : space(2);
  const Result dear = find(between(domain, cost, Eigen::Vector2d(-0.6, 1), Eigen::Vector2d(0.6, 1)), 40);
  check_covered(dear, 1.1140277, 1e-6);
  CHECK(dear.certificate.scope == Scope::local);
  CHECK(has_note(dear,
                 "cheaper: the path through the places where moves cost nothing costs 1, but this path costs 1.11"));
  const Result cheap = find(between(domain, cost, Eigen::Vector2d(-0.5, 1), Eigen::Vector2d(0.5, 1)), 40);
  CHECK_FALSE(has_note(cheap, "cheaper"));
  // A box that ends above y = 0 does not let it through.
  const auto above = box(Eigen::Vector2d(-10, 0.1), Eigen::Vector2d(10, 10));
  const Result kept = find(between(above, cost, Eigen::Vector2d(-0.6, 1), Eigen::Vector2d(0.6, 1)), 40);
  CHECK_FALSE(has_note(kept, "cheaper"));
}

TEST_CASE("D4: past a / y0 = 0.6627 the catenary collapses, with and without a bound at y = 0", "[oracle]") {
  const double a = GENERATE(0.67, 0.7, 1.0, 3.0), height = GENERATE(1.0, 0.5);
  const bool bounded = GENERATE(false, true);
  const auto domain = bounded ? box(Eigen::Vector2d(-10, 0), Eigen::Vector2d(10, 10)) : space(2);
  const auto cost = medium(refraction::PowerLaw{.exponent = 1});
  const Result result = find(between(domain, cost, Eigen::Vector2d(-a, 1), Eigen::Vector2d(a, height)), 40);
  CAPTURE(a, height, bounded, word_of(result.solve.termination), result.curve.cost);
  REQUIRE(result.status == Status::collapsed);
  CHECK(result.curve.cost == Approx((1 + height * height) / 2).epsilon(1e-12));
  CHECK(has_note(result, "collapsed: the path collapsed onto places where moves cost nothing"));
  // Straight down, free along y = 0, straight up; equal costs, but for the move that is free.
  Index free = 0;
  CHECK(result.costs.minCoeff(&free) == 0);
  CHECK(result.path.u.col(free) == Eigen::Vector2d(-a, 0));
  CHECK(result.path.u.col(free + 1) == Eigen::Vector2d(a, 0));
  CHECK(result.certificate.spacing < (height == 1 ? 1e-12 : 0.1));
  CHECK_FALSE(result.certificate.certified());
}

TEST_CASE("D4: the gravity tunnel, at rest at both ends, by a formula of the potential", "[oracle]") {
  const int n = GENERATE(32, 100);
  TravelTimeOptions options{.potential = "g * (x^2 + y^2) / (2 * R)", .parameters = {{"g", 1}, {"R", 1}}};
  const Eigen::Vector2d source(1, 0);
  const double s = GENERATE(1.0, 2.0);
  const Eigen::Vector2d target(std::cos(s), std::sin(s));
  const Result result = ray(make_travel_time_cost(options, 2, Eigen::VectorXd(source)), source, target, n);
  const CostEstimate& e = result.certificate.estimate;
  const double truth = std::sqrt(s * (2 * std::numbers::pi - s));
  CAPTURE(n, s, e.value, e.error, e.method, failures(result.certificate));
  if (s == 1) CHECK(truth == Approx(2.29851806762087178).epsilon(1e-15));
  CHECK(std::abs(e.value - truth) <= e.error);
  CHECK(e.error < (n == 32 ? 2e-2 : 2e-3) * truth);
  CHECK(result.status == Status::certified);
}

TEST_CASE("gravity as a potential is the travel time under gravity", "[oracle]") {
  TravelTimeOptions options{.potential = "9.80665 * y"};
  const Eigen::Vector2d source(0, 0), target(std::numbers::pi, -2);
  const auto cost = make_travel_time_cost(options, 2, Eigen::VectorXd(source));
  const Result result = ray(cost, source, target, 40), known = find(bead(source, target, 9.80665), 40);
  CHECK(result.curve.cost == Approx(known.curve.cost).epsilon(1e-12));
  CHECK(std::abs(result.certificate.estimate.value - std::numbers::pi / std::sqrt(9.80665)) <=
        result.certificate.estimate.error);
}

}  // namespace leastcost::test
