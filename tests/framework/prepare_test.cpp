// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The coarser versions of clouds and grids: made once, told apart from the certificate, and no dearer than the domain.
#include <ctime>

#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/data/signed_distance.hpp>
#include "problems/distance/cloud_distance.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

template <class Work>
double processor_seconds(Work work) {
  const auto now = [] {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  };
  const double begin = now();
  work();
  return now() - begin;
}

std::shared_ptr<const ConstraintManifold> grid_from_cloud() {
  const auto source = make_cloud_distance(PointCloud(sphere_cloud(2000), {}), true);
  return std::make_shared<const SignedDistanceManifold>(build_distance_grid(*source, {.cell = 0.08}), source);
}

std::shared_ptr<const ConstraintManifold> cloud_of_sphere() {
  return std::make_shared<const PointCloudManifold>(PointCloud(sphere_cloud(4000), {}));
}

Problem quarter_circle(std::shared_ptr<const ConstraintManifold> domain) {
  return between(std::move(domain), make_euclidean_cost(3), Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0.8, 0.6, 0));
}

/// The straight line leads too deep below the surface.
WaypointsInitializer around() {
  Points waypoints(3, 3);
  waypoints << 0.27, 0.53, 0.71, 0.2, 0.4, 0.53, 0.94, 0.75, 0.47;
  return WaypointsInitializer(waypoints);
}

}  // namespace

TEST_CASE("coarser versions are made by the first search, apart from its certificate, and kept",
          "[framework][slow_sanitized]") {
  for (const auto& domain : {grid_from_cloud(), cloud_of_sphere()}) {
    const Problem problem = quarter_circle(domain);
    const Result first = find(problem, 31, around()), second = find(problem, 31, around());
    CHECK(first.status == Status::certified);
    CHECK(first.seconds.prepare > 20 * second.seconds.prepare);
    const auto* coarse = find_ability<HasCoarserVersion>(*domain);
    REQUIRE(coarse != nullptr);
    CHECK(coarse->coarser() == coarse->coarser());
    CHECK(second.certificate.geometry_error == first.certificate.geometry_error);
  }
  CHECK(find(between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)), 7)
            .seconds.prepare == 0);
}

TEST_CASE("coarser versions take no longer than the domain itself", "[framework][slow]") {
  for (const auto make : {grid_from_cloud, cloud_of_sphere}) {
    std::shared_ptr<const ConstraintManifold> domain;
    const double made = processor_seconds([&] { domain = make(); });
    const Problem problem = quarter_circle(domain);
    const double coarser = processor_seconds([&] { prepare(problem); });
    CAPTURE(made, coarser);
    CHECK(coarser < made);  // 0.5 to 0.9 of it
  }
}

TEST_CASE("a certificate on a cloud or on a grid from one takes some solves, not thousands", "[framework][slow]") {
  for (const auto make : {grid_from_cloud, cloud_of_sphere}) {
    const Problem problem = quarter_circle(make());
    prepare(problem);
    FindOptions options{.points = 63};
    options.certificate.enabled = false;
    const double solve = processor_seconds([&] { find_path(problem, around(), Newton(), options); });
    options.certificate.enabled = true;
    Result result;
    const double all = processor_seconds([&] { result = find_path(problem, around(), Newton(), options); });
    CAPTURE(solve, all);
    CHECK(all - solve < 20 * solve);  // measured 2 to 6: benchmarks/certify_table
  }
}

}  // namespace leastcost::test
