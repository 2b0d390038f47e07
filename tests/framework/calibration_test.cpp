// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Proofs of minima: their bounds hold closed-form values, and what the points of a chain did not see makes them fail.
#include "framework/calibration.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <leastcost/framework/refinement.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"

namespace leastcost::test {
namespace {

std::shared_ptr<const SegmentCost> tensor(const std::vector<std::string>& entries) {
  MetricFieldOptions options;
  options.field = metric::Formula{entries, {}};
  return make_metric_field_cost(options, entries.size() == 3 ? 2 : 3);
}
/// c = n |dx|.
std::shared_ptr<const SegmentCost> index(const std::string& n) {
  return tensor({"(" + n + ")^2", "0", "(" + n + ")^2"});
}

/// The proof for the finest chain of the certificate.
Calibration proof(const Problem& problem, int points) {
  const CoordinatePath chain = find(problem, points).path;
  return calibrate(problem, refine_levels(problem, chain, {}).paths.at(2), {chain.segment_count(), 1e-9, 200}, {});
}

/// Certified, with an error bar that does not hold the truth.
bool is_false(const Result& result, double truth) {
  return result.status == Status::certified &&
         std::abs(result.certificate.estimate.value - truth) > result.certificate.estimate.error + 1e-13 * truth;
}

}  // namespace

TEST_CASE("bounds of a proof hold the closed form", "[calibration]") {
  SECTION("half-plane") {
    const Problem problem =
        between(space(2), tensor({"1/y^2", "0", "1/y^2"}), Eigen::Vector2d(-1, 0.5), Eigen::Vector2d(1, 0.6));
    const double truth = std::acosh(1 + (4 + 0.01) / (2 * 0.5 * 0.6));
    for (const int points : {32, 64}) {
      const Calibration c = proof(problem, points);
      REQUIRE(c.proved);
      CHECK(c.lower <= truth);
      CHECK(truth <= c.upper.value());
      CHECK(c.upper.value() - c.lower < 1e-4);
    }
  }
  SECTION("a constant tensor in space") {
    const Problem problem = between(space(3), tensor({"2", "0.3", "0", "1", "0.1", "3"}), Eigen::Vector3d(0, 0, 0),
                                    Eigen::Vector3d(1, 2, -1));
    Eigen::Matrix3d m;
    m << 2, 0.3, 0, 0.3, 1, 0.1, 0, 0.1, 3;
    const Eigen::Vector3d d(1, 2, -1);
    const double truth = std::sqrt(d.dot(m * d));
    const Calibration c = proof(problem, 20);
    REQUIRE(c.proved);
    CHECK(c.lower <= truth);
    CHECK(truth <= c.upper.value());
    CHECK(c.upper.value() - c.lower < 1e-11);
  }
  SECTION("a sphere in stereographic coordinates, before and beyond the antipode") {
    const std::string g = "4/(1 + x^2 + y^2)^2";
    const auto on_sphere = [&](double length) {  // along the x axis, from the angle -1
      const auto x = [](double angle) { return std::tan(angle / 2); };
      return between(space(2), tensor({g, "0", g}), Eigen::Vector2d(x(-1), 0), Eigen::Vector2d(x(length - 1), 0));
    };
    const Calibration before = proof(on_sphere(2.5), 64);
    REQUIRE(before.proved);
    CHECK(before.lower <= 2.5);
    CHECK(2.5 <= before.upper);
    const Problem beyond = on_sphere(3.6);
    const CoordinatePath straight = sample_equally(beyond, StraightInitializer().first_path(beyond, {}).path, 127);
    CHECK_FALSE(calibrate(beyond, straight, {64, 1e-9}, {}).proved);
  }
}

TEST_CASE("no proof of what a chain did not see", "[calibration]") {
  SECTION("a wall a fiftieth of a segment wide, met at an angle") {
    CHECK_FALSE(proof(between(space(2), index("1 + 10*exp(-((x-0.123)/2e-4)^2)"), Eigen::Vector2d(-1, 0),
                              Eigen::Vector2d(1, 1)),
                      63)
                    .proved);
  }
  SECTION("a shallow trench beside the path, a fiftieth of a segment wide") {
    CHECK_FALSE(proof(between(space(2), index("1 - 5e-4*exp(-((y-0.003)/3e-4)^2)"), Eigen::Vector2d(0, 0),
                              Eigen::Vector2d(1, 0)),
                      64)
                    .proved);
  }
}

TEST_CASE("problems finer than the segments are not certified with an error beyond the bar", "[calibration]") {
  SECTION("ripples that fit all levels") {
    const Result r =
        find(between(space(2), index("1 - 0.5*cos(2*pi*256*x)"), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0)), 63);
    CHECK_FALSE(is_false(r, 1));
    CHECK(r.status == Status::uncertified);
    CHECK(std::isnan(r.certificate.estimate.error));
  }
  SECTION("a wall that no point meets") {
    const Result r = find(
        between(space(2), index("1 + 10*exp(-((x-0.123)/2e-4)^2)"), Eigen::Vector2d(-1, 0), Eigen::Vector2d(1, 1)), 63);
    CHECK(r.status == Status::uncertified);
  }
  SECTION("a condition of 7e7") {
    const Result r = find(between(space(2), tensor({"30161626.53531196", "-36296095.80716718", "43678236.090502486"}),
                                  Eigen::Vector2d(0, 0), Eigen::Vector2d(0.913668311176993, 0.7592475403307616)),
                          63);
    CHECK_FALSE(is_false(r, 1.18795900813));
  }
  SECTION("smooth and resolved: certified, with a proof") {
    const Result r = find(between(space(2), index("1 + 0.3*exp(-6*((x-0.5)^2+(y-0.1)^2))"), Eigen::Vector2d(0, 0),
                                  Eigen::Vector2d(1, 0.1)),
                          64);
    REQUIRE(r.status == Status::certified);
    REQUIRE(r.certificate.resolution);
    CHECK(r.certificate.resolution->verdict == ResolutionVerdict::proved);
    CHECK(r.certificate.resolution->minimum_proved);
    CHECK(r.certificate.estimate.value >= *r.certificate.resolution->lower - r.certificate.estimate.error);
    CHECK(*r.certificate.resolution->lower <= *r.certificate.resolution->upper);
  }
}

}  // namespace leastcost::test
