// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Where a cloud has no surface the reason is said, with the radius that has one; tried here. Paths rest on borders.
#include <cmath>
#include <numbers>
#include <random>
#include <regex>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/check/check_manifold.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include "problems/cloud/cloud_route.hpp"
#include "problems/cloud/unresolved.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;
using Eigen::Vector3d;

/// The unit sphere without the cap around the z axis, and without its lower half where `half`.
PointSamples open_sphere(int count, double hole, bool half) {
  PointSamples all = sphere_cloud(count), left;
  for (const Vector3d& p : all.positions)
    if (std::hypot(p[0], p[1]) > hole && (!half || p[2] > 0)) left.positions.push_back(p);
  return left;
}

/// Checks that there is no surface at x, and that the radius which is named, if any, has one there.
std::string reason_and_cure(const PointSamples& samples, const Vector3d& x) {
  const PointCloud cloud(samples, {});
  const CloudSurface surface(cloud);
  Vector3d moved = x;
  REQUIRE_FALSE(surface.project(moved));
  const std::string why = why_no_surface_at(cloud, surface, x);
  CAPTURE(why);
  std::smatch found;
  if (!std::regex_search(why, found, std::regex("with radius: ([0-9.]+)"))) return why;
  const PointCloud wider(samples, {.radius = std::stod(found[1])});
  CHECK(wider.share_of_support() <= PointCloud::kMostOfCloud);
  CHECK(CloudSurface(wider).project(moved));
  return why;
}

constexpr int kOnSphere = 3000;
const double kSpacing = std::sqrt(4 * std::numbers::pi / kOnSphere);

/// The unit sphere without the belt of this width around its equator.
PointSamples two_caps(double belt) {
  PointSamples all = sphere_cloud(kOnSphere), left;
  for (const Vector3d& p : all.positions)
    if (std::abs(p[2]) > belt / 2) left.positions.push_back(p);
  return left;
}

std::string why_no_route(const PointSamples& samples, const PointCloudSettings& settings, const Vector3d& a,
                         const Vector3d& b) {
  const auto domain = surface_of(PointCloud(samples, settings));
  try {
    cloud_route(between(domain, make_euclidean_cost(3), a, b), *domain, {});
  } catch (const InitializationError& error) {
    return error.what();
  }
  return "a route";
}

double number_after(const std::string& text, const std::string& name) {
  std::smatch found;
  CAPTURE(text, name);
  REQUIRE(std::regex_search(text, found, std::regex(name + ": ([0-9.]+)")));
  return std::stod(found[1]);
}

/// Certified, from the least-cost edges.
Result solved(const PointSamples& samples, const PointCloudSettings& settings, const Vector3d& a, const Vector3d& b) {
  FindOptions options;
  options.points = 63;
  return find_path(between(surface_of(PointCloud(samples, settings)), make_euclidean_cost(3), a, b),
                   DijkstraInitializer(), Newton(), options);
}

Vector3d on_sphere(double polar, double azimuth) {
  return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)};
}

/// Length of the shortest way around the cap of this angle between two points at the same polar angle.
double around_cap(double cap, double polar, double azimuth) {
  return 2 * std::acos(std::cos(polar) / std::cos(cap)) +
         (azimuth - 2 * std::acos(std::tan(cap) / std::tan(polar))) * std::sin(cap);
}

}  // namespace

TEST_CASE("a path over a cloud with a hole comes to rest on its border, and is certified") {
  const PointSamples samples = open_sphere(kOnSphere, 8 * kSpacing, false);
  const double cap = std::asin(8 * kSpacing), polar = 0.9, azimuth = 3;
  const Result result = solved(samples, {}, on_sphere(polar, 0), on_sphere(polar, azimuth));
  CAPTURE(result.certificate.estimate.value);
  CHECK(result.status == Status::certified);
  // The border is between the last samples and a spacing beyond them.
  CHECK(result.certificate.estimate.value < around_cap(cap + 0.5 * kSpacing, polar, azimuth));
  CHECK(result.certificate.estimate.value > around_cap(cap - 1.0 * kSpacing, polar, azimuth));
}

TEST_CASE("the border of a cloud is a bound that keeps what bounds promise") {
  const auto domain = surface_of(PointCloud(open_sphere(kOnSphere, 8 * kSpacing, false), {}));
  REQUIRE(find_ability<HasBounds>(*domain) != nullptr);
  const double cap = std::asin(8 * kSpacing);
  const auto near = [&](std::mt19937_64& engine) -> Eigen::VectorXd {
    std::uniform_real_distribution<double> any(0, 1);
    return on_sphere(cap + (2 * any(engine) - 1) * kSpacing, 6 * any(engine));
  };
  std::mt19937_64 engine(5);
  const std::vector<Fault> faults = check_manifold(*domain, near, engine, {.size = 0.5, .step = 0.1 * kSpacing});
  CHECK(text(faults) == "");
}

TEST_CASE("a closed cloud has no border") {
  CHECK(find_ability<HasBounds>(*surface_of(PointCloud(sphere_cloud(kOnSphere), {}))) == nullptr);
  CHECK(find_ability<HasBounds>(*surface_of(PointCloud(torus_cloud(kOnSphere), {}))) == nullptr);
}

TEST_CASE("ends in different parts of a cloud: the gap is said, and the options that are named span it") {
  const PointSamples samples = two_caps(4.5 * kSpacing);
  const Vector3d a(0.6, 0, 0.8), b(0.6, 0, -0.8);
  const std::string why = why_no_route(samples, {}, a, b);
  CAPTURE(why);
  REQUIRE_THAT(why, Contains("different parts of the cloud") && Contains("local spacings, near"));
  const PointCloudSettings wider{.radius = number_after(why, "radius"), .max_edge = number_after(why, "max_edge")};
  const Result result = solved(samples, wider, a, b);
  CHECK(result.status == Status::certified);
  CHECK(result.certificate.estimate.value == Approx(2 * std::asin(0.8)).epsilon(0.01));
}

TEST_CASE("a part of a cloud that is cut by a gap without a surface: the radius that is named spans it") {
  const PointSamples samples = two_caps(6.5 * kSpacing);
  const Vector3d a(0.6, 0, 0.8), b(0.6, 0, -0.8);
  const std::string why = why_no_route(samples, {.max_edge = 9}, a, b);
  CAPTURE(why);
  REQUIRE_THAT(why, Contains("every continuation crosses a place without a surface"));
  CHECK(why_no_route(samples, {.radius = number_after(why, "with radius"), .max_edge = 9}, a, b) == "a route");
}

TEST_CASE("parts of a cloud that are too far apart: no remedy is named") {
  const std::string why = why_no_route(two_caps(20 * kSpacing), {}, Vector3d(0, 0, 1), Vector3d(0, 0, -1));
  CHECK_THAT(why, Contains("choose both ends in one part") && !Contains("radius: "));
}

TEST_CASE("a cloud says why it has no surface: a hole, with the radius that spans it") {
  constexpr int kCount = 3000;
  const double spacing = std::sqrt(4 * std::numbers::pi / kCount);
  const std::string why = reason_and_cure(open_sphere(kCount, 4.5 * spacing, false), Vector3d(0, 0, 1));
  CHECK_THAT(why, Contains("a hole") && Contains("with radius: "));
}

TEST_CASE("a cloud says why it has no surface: beyond the border, with the radius that reaches there") {
  const double below = -0.06;  // a spacing
  const Vector3d x(std::sqrt(1 - below * below), 0, below);
  const std::string why = reason_and_cure(open_sphere(3000, 0, true), x);
  CHECK_THAT(why, Contains("outside the border") && Contains("with radius: "));
}

TEST_CASE("a cloud says why it has no surface: far beyond the border no radius helps, and that is said") {
  CHECK_THAT(reason_and_cure(open_sphere(3000, 0, true), Vector3d(0, 0, -1)),
             Contains("outside the border") && Contains("waypoints"));
}

TEST_CASE("a cloud says of a point far away from it only how far it is") {
  const std::string why = reason_and_cure(open_sphere(3000, 0, true), Vector3d(900, 1, 1));
  CHECK_THAT(why, Contains("it is 899 away from the nearest sample of a cloud that is ") &&
                      Contains("give a point on the cloud") && !Contains("radius") && !Contains("waypoints"));
}

}  // namespace leastcost::test
