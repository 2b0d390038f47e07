// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Fields on charts that close on themselves: against great circles, unrolled cylinders and exact distances on a mesh.
#include <leastcost/problems/fields/cost_field.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/manifolds/earth.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include "problems/mesh/surface_path.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
constexpr double kHalfTurn = std::numbers::pi;

Problem on_surface(std::shared_ptr<const ConstraintManifold> domain, const Vector2d& source) {
  Problem problem;
  problem.manifold = std::move(domain);
  problem.cost = make_euclidean_cost(3);
  problem.source.u = source;
  problem.target.u = source + Vector2d(0.1, 0);
  return problem;
}

std::shared_ptr<const ConstraintManifold> closed_surface(const parametric::Surface& named) {
  return make_parametric_manifold({named, {}});
}

double great_circle_between(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

Vector3d on_unit_sphere(double longitude, double latitude) {
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
}

/// The largest difference from the truth, which is within the estimate.
double largest_error_within(const CostField& field, const std::function<double(const Vector2d&)>& truth) {
  double worst = 0;
  for (std::int32_t j = 0; j < field.count[1]; ++j)
    for (std::int32_t i = 0; i < field.count[0]; ++i) {
      REQUIRE(std::isfinite(field.value(i, j)));
      worst = std::max(worst, std::abs(field.value(i, j) - truth(field.node(i, j))));
    }
  CHECK(worst <= field.error);
  return worst;
}

}  // namespace

TEST_CASE("closed field: great circles on a sphere from any place of it") {
  std::mt19937 random(7);
  for (int world = 0; world < 6; ++world) {
    const double longitude = std::uniform_real_distribution<double>(-kHalfTurn, kHalfTurn)(random);
    const double latitude = std::asin(std::uniform_real_distribution<double>(-0.99, 0.99)(random));
    const Problem problem = on_surface(closed_surface(parametric::Sphere{}), Vector2d(longitude, latitude));
    const CostField field = costs_from(problem, {problem.source.u}, {.resolution = 2 * kHalfTurn / 96});
    CHECK(field.seams.size() == 1);
    CHECK(field.count[0] == 97);
    const Vector3d from = on_unit_sphere(longitude, latitude);
    CHECK(largest_error_within(
              field, [&](const Vector2d& u) { return great_circle_between(from, on_unit_sphere(u[0], u[1])); }) < 0.06);
    for (std::int32_t j = 0; j < field.count[1]; ++j) CHECK(field.value(0, j) == field.value(96, j));
  }
}

TEST_CASE("closed field: over the date line and back on a way") {
  const auto earth = std::make_shared<const EarthManifold>(EarthOptions{6371000, 0});
  const Problem problem = on_surface(earth, Vector2d(-41, 174));
  const CostField field = costs_from(problem, {problem.source.u}, {.resolution = 2.5});
  CHECK(field.lower == Vector2d(-90, -180));
  const auto place = [](const Vector2d& u) { return on_unit_sphere(u[1] * kHalfTurn / 180, u[0] * kHalfTurn / 180); };
  const auto distance = [&](const Vector2d& u) { return 6371000 * great_circle_between(place({-41, 174}), place(u)); };
  CHECK(largest_error_within(field, distance) < 0.02 * kHalfTurn * 6371000);
  for (const Vector2d& to : {Vector2d(-33, -71), Vector2d(61, -150), Vector2d(-33, 289), Vector2d(35, 139)}) {
    const std::vector<Vector2d> way = way_down(field, problem, to);
    CHECK(cost_of_way(problem, way) == Approx(distance(to)).epsilon(0.002));
    CHECK(cost_of_way(problem, way) > (1 - 1e-7) * distance(to));  // no sum of chords
    CHECK((place(way.back()) - place(to)).norm() < 1e-9);
    CHECK((place(way.front()) - place({-41, 174})).norm() < 1e-9);
    CHECK(value_at(field, to) == Approx(distance(to)).epsilon(0.02));
  }
}

TEST_CASE("closed field: an unrolled cylinder, and places by any of their names") {
  const Problem problem = on_surface(closed_surface(parametric::Cylinder{0.7}), Vector2d(9, 0.2));
  Problem with_target = problem;
  with_target.target.u = Vector2d(9, 2);
  const CostField field = costs_from(with_target, {problem.source.u}, {.resolution = 0.07});
  const double worst = largest_error_within(
      field, [](const Vector2d& u) { return std::hypot(0.7 * std::remainder(u[0] - 9, 2 * kHalfTurn), u[1] - 0.2); });
  CHECK(worst < 0.02);
  const CostField back = costs_from(with_target, {Vector2d(6, 1.5)}, {.resolution = 0.07, .to_places = true});
  const CostField detour = corridor(field, back);
  CHECK(*std::min_element(detour.values.begin(), detour.values.end()) == 0);
}

TEST_CASE("closed field: exact distances on a fine mesh of a torus") {
  constexpr std::int32_t kAround = 192, kTube = 96;
  const auto domain = closed_surface(parametric::Torus{2, 1});
  PolygonSoup soup;
  for (std::int32_t i = 0; i < kAround; ++i)
    for (std::int32_t j = 0; j < kTube; ++j) {
      const Vector2d u(-kHalfTurn + 2 * kHalfTurn * i / kAround, -kHalfTurn + 2 * kHalfTurn * j / kTube);
      soup.positions.emplace_back(positions(*domain, {u, {}, true}).col(0));
      const auto corner = [](std::int32_t a, std::int32_t b) { return a % kAround * kTube + b % kTube; };
      for (const std::int32_t v :
           {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)})
        soup.corners.push_back(v);
    }
  for (std::int32_t k = 0; k <= static_cast<std::int32_t>(soup.corners.size()); k += 3) soup.polygon_begin.push_back(k);
  const TriangleMesh mesh(soup);
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  for (const std::array<std::int32_t, 2>& at : {std::array{10, 7}, std::array{100, 48}}) {
    const std::int32_t vertex = at[0] * kTube + at[1];
    const std::int32_t face = mesh.faces_of_vertex(vertex)[0];
    const auto exact = search.distances(point_on_face(mesh, face, mesh.position(vertex)), workspace);
    const Vector2d source(-kHalfTurn + 2 * kHalfTurn * at[0] / kAround, -kHalfTurn + 2 * kHalfTurn * at[1] / kTube);
    const Problem problem = on_surface(domain, source);
    const CostField field = costs_from(problem, {source}, {.resolution = 2 * kHalfTurn / kTube});
    const double worst = largest_error_within(field, [&](const Vector2d& u) {
      const auto i = static_cast<std::int32_t>(std::lround((u[0] + kHalfTurn) / (2 * kHalfTurn) * kAround)) % kAround;
      const auto j = static_cast<std::int32_t>(std::lround((u[1] + kHalfTurn) / (2 * kHalfTurn) * kTube)) % kTube;
      return exact.distance[std::size_t(i * kTube + j)];
    });
    CHECK(worst < 0.3);  // where the two sides meet behind the source; 0.003 on average
  }
}

TEST_CASE("closed field: a seam that turns the other coordinate over") {
  const Problem problem = on_surface(closed_surface(parametric::MoebiusStrip{0.5}), Vector2d(1.2, 0.3));
  const CostField field = costs_from(problem, {problem.source.u}, {.resolution = kHalfTurn / 60});
  const std::int32_t last = field.count[0] - 1;
  for (std::int32_t j = 0; j < field.count[1]; ++j)
    CHECK(field.value(0, j) == field.value(last, field.count[1] - 1 - j));
  Problem other = problem;
  other.source.u = Vector2d(1.2 - kHalfTurn, -0.3);  // the same place
  const CostField same = costs_from(other, {other.source.u}, {.resolution = kHalfTurn / 60});
  for (std::size_t k = 0; k < field.values.size(); ++k) CHECK(same.values[k] == Approx(field.values[k]));
}

}  // namespace leastcost::test
