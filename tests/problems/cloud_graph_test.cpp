// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/cloud/cloud_graph.hpp>

#include <algorithm>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include "problems/cloud/cloud_route.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

/// Two copies of a gently curved sheet, `apart` over each other.
PointSamples two_sheets(int count, double apart) {
  PointSamples both = sheet_cloud(count, [](double x, double y) { return 0.1 * x * y; });
  for (int i = 0; i < count; ++i) {
    // Not the same points: shifted by a fraction of the spacing.
    const Eigen::Vector3d p = both.positions[static_cast<std::size_t>(i)];
    both.positions.emplace_back(p[0] + 0.3 / std::sqrt(count), p[1], p[2] + apart);
  }
  return both;
}

Problem on(std::shared_ptr<const PointCloudManifold> domain, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return between(std::move(domain), make_euclidean_cost(3), a, b);
}

}  // namespace

TEST_CASE("the neighbour graph of a closed cloud is one part with links both ways") {
  const PointCloud cloud(torus_cloud(2000), {});
  const CloudGraph graph(cloud);
  REQUIRE(graph.component_sizes() == std::vector<std::int32_t>{2000});
  for (std::int32_t i = 0; i < cloud.size(); ++i) {
    const std::span<const std::int32_t> neighbours = graph.neighbours(i);
    CHECK(neighbours.size() >= static_cast<std::size_t>(cloud.neighbour_count()));
    for (const std::int32_t j : neighbours) {
      const std::span<const std::int32_t> back = graph.neighbours(j);
      CHECK(std::count(back.begin(), back.end(), i) == 1);
    }
  }
  CHECK(graph.notes().empty());
}

TEST_CASE("parts of a cloud are counted, and ends in different parts named with their sizes") {
  PointSamples two = sphere_cloud(1500);
  const PointSamples other = sphere_cloud(700, Eigen::Vector3d(5, 0, 0));
  two.positions.insert(two.positions.end(), other.positions.begin(), other.positions.end());
  const auto domain = std::make_shared<const PointCloudManifold>(PointCloud(two, {}));
  CHECK(domain->graph().component_sizes() == std::vector<std::int32_t>{1500, 700});
  const Problem problem = on(domain, Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(5, 1, 0));
  try {
    cloud_route(problem, *domain, {});
    FAIL("a route between two spheres");
  } catch (const InitializationError& error) {
    CHECK(std::string(error.what()).find("with 1500 and 700 points") != std::string::npos);
  }
}

// The graph does not jump, and neither does the path, between sheets from three spacings on. Closer ones look like
// noise.
TEST_CASE("a path stays on its sheet where another one is a few spacings away") {
  const int count = 1600;
  const double spacing = 1.0 / 40, apart = GENERATE(3.0, 4.5) * spacing;
  CAPTURE(apart);
  const auto domain = std::make_shared<const PointCloudManifold>(PointCloud(two_sheets(count, apart), {}));
  const CloudGraph& graph = domain->graph();
  REQUIRE(graph.component_sizes().size() >= 2);
  CHECK(graph.component_sizes()[0] <= count);
  const Problem problem = on(domain, Eigen::Vector3d(0.2, 0.3, 0.006), Eigen::Vector3d(0.8, 0.6, 0.048));
  const CloudRoute route = cloud_route(problem, *domain, {});
  for (const Eigen::Vector3d& p : route.points) CHECK(std::abs(p[2] - 0.1 * p[0] * p[1]) < 0.5 * apart);
}

TEST_CASE("sheets too close to be told apart are reported") {
  const PointCloud cloud(two_sheets(1600, 1.5 / 40), {});
  REQUIRE(cloud.notes().size() == 1);
  CHECK(cloud.notes()[0].find("sheets closer than two spacings") != std::string::npos);
}

TEST_CASE(
    "routes on a cloud: close to the true length, around what costs infinitely much, and to the sample next door") {
  const auto domain = std::make_shared<const PointCloudManifold>(PointCloud(sphere_cloud(3000), {}));
  const Eigen::Vector3d top(0, 0, 1), side(1, 0, 0);
  const CloudRoute route = cloud_route(on(domain, top, side), *domain, {});
  double length = 0;
  for (std::size_t i = 1; i < route.points.size(); ++i) length += (route.points[i] - route.points[i - 1]).norm();
  const double truth = std::numbers::pi / 2;
  CHECK(length > 0.99 * truth);  // chords of a sphere, 0.03 rad each
  CHECK(length < 1.1 * truth);   // a graph with 12 neighbours zigzags by less
  CHECK(route.vertices == static_cast<int>(route.points.size()) - 2);

  const CloudRoute next_door = cloud_route(on(domain, top, Eigen::Vector3d(0.01, 0, 1)), *domain, {});
  CHECK(next_door.points.size() == 2);

  // A bead that starts at rest cannot climb: from low to high there is no route, and the report says how far one gets.
  TravelTimeOptions options;
  options.gravity = 1;
  Problem bead = on(domain, side, top);
  bead.cost = make_travel_time_cost(options, 3, bead.source.u);
  CHECK_THROWS_AS(cloud_route(bead, *domain, {}), InitializationError);
}

}  // namespace leastcost::test
