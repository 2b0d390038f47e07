// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Every domain with bounds: paths that must rest on one, against closed forms. What counts as an active bound is tested
// in manifold_contract.hpp, which of them hold in framework/frames_test.cpp.
#include <cmath>
#include <numbers>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/initializers/coordinate_circle.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include "tests/contracts/manifold_contract.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"

namespace leastcost::test {
namespace {

/// Two tangents and an arc around the unit disc from (-2, 0) to (2, 0), docs/oracles.md D5.
const double kAroundDisc = 2 * std::sqrt(3.0) + kPi / 3;

/// A certified path that rests on bounds: the bar covers the true error and is not wider than `widest` of the length.
void check_hugging(const Result& result, double length, double widest) {
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(result.path.u.cols(), e.value, e.error, e.method, length, failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(std::abs(e.value - length) <= e.error);
  CHECK(e.error <= widest * length);
}

/// How many points of a path a bound holds: an outward move would shorten it.
int held_points(const Problem& problem, const CoordinatePath& path) {
  PathEnergy energy(problem, 1);
  Points gradient;
  energy.value_and_gradient(path, gradient);
  const auto& bounds = dynamic_cast<const HasBounds&>(*problem.manifold);
  Points normals(path.u.rows(), path.u.rows());
  int held = 0;
  for (Index i = 0; i < path.free_count(); ++i) {
    const int count = bounds.active_bounds(path, path.free_begin() + i, normals);
    if (count > 0 && (normals.leftCols(count).transpose() * gradient.col(i)).minCoeff() < 0) ++held;
  }
  return held;
}

ParametricOptions polar_plane() {
  ParametricOptions options;
  options.surface = parametric::Formula{.x = "v * cos(u)", .y = "v * sin(u)", .z = "0", .period_u = 2 * kPi};
  options.box.lower = Eigen::Vector2d(-1e3, 1);
  return options;
}

std::shared_ptr<const LevelSet> boxed(const char* f, const std::optional<Eigen::VectorXd>& lower,
                                      const std::optional<Eigen::VectorXd>& upper, int dimension = 3) {
  return make_implicit_manifold(
      {.surface = leastcost::implicit::Formula{.f = f, .dimension = dimension}, .box = {lower, upper}});
}

/// A flat mesh over [-3, 3]^2 of squares of side 1 / m, without those in [-1, 1]^2.
std::shared_ptr<const MeshManifold> sheet_with_hole(int m) {
  PolygonSoup soup;
  const int n = 6 * m;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) soup.positions.emplace_back(-3 + 1.0 * i / m, -3 + 1.0 * j / m, 0);
  const auto in_hole = [m](int i) { return i >= 2 * m && i < 4 * m; };
  const auto vertex = [n](int i, int j) { return i * (n + 1) + j; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if (!in_hole(i) || !in_hole(j))
        add_polygon(soup, {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
  return std::make_shared<const MeshManifold>(TriangleMesh(soup));
}

/// A flat mesh between the circles with radii 1 and 3.
std::shared_ptr<const MeshManifold> ring_sheet(int sectors) {
  PolygonSoup soup;
  constexpr int kRows = 12;
  for (int i = 0; i < sectors; ++i)
    for (int j = 0; j <= kRows; ++j) {
      const double r = 1 + 2.0 * j / kRows, angle = 2 * kPi * i / sectors;
      soup.positions.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
  const auto vertex = [sectors](int i, int j) { return (i % sectors) * (kRows + 1) + j; };
  for (int i = 0; i < sectors; ++i)
    for (int j = 0; j < kRows; ++j)
      add_polygon(soup, {vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)});
  return std::make_shared<const MeshManifold>(TriangleMesh(soup));
}

Result find_on_mesh(const Problem& problem, const Initializer& initializer, int points,
                    const std::vector<std::shared_ptr<const PostProcessor>>& steps) {
  FindOptions options;
  options.points = points;
  options.post_processors = steps;
  return find_path(problem, initializer, Lbfgs(), options);
}

}  // namespace

TEST_CASE("bounds contract: parametric, around a hole in the chart", "[contract]") {
  const int n = GENERATE(20, 80, 199);
  const Problem problem = between(make_parametric_manifold(polar_plane()), make_euclidean_cost(3),
                                  Eigen::Vector2d(0, 2), Eigen::Vector2d(kPi, 2));
  const Result result = find(problem, n);
  // The bar is the bracket of chords and curve: the arc's chords are short by h^2 / 24 of it.
  check_hugging(result, kAroundDisc, 1 / (1.0 * n * n));
  CHECK(held_points(problem, result.path) > n / 6);
}

TEST_CASE("bounds contract: parametric, rings along an edge of the chart", "[contract]") {
  ParametricOptions catenoid, strip;
  catenoid.surface = parametric::Catenoid{};
  catenoid.box.lower = Eigen::Vector2d(-100, 0.5);
  const Problem cut = closed(make_parametric_manifold(catenoid), make_euclidean_cost(3));
  const int n = GENERATE(40, 200);
  // All of it lies on the edge: a circle.
  check_hugging(find(cut, n, CoordinateCircleInitializer({0, Eigen::Vector2d(0, 0.9), 1})), 2 * kPi * std::cosh(0.5),
                4 / (1.0 * n * n));
  // Partly on the edge of a strip of finite width, which a ring of two turns follows twice.
  strip.surface = parametric::MoebiusStrip{};
  const Problem moebius = closed(make_parametric_manifold(strip), make_euclidean_cost(3));
  const Result one = find(moebius, n, CoordinateCircleInitializer({0, Eigen::Vector2d(0.3, 0), 1}));
  const Result two = find(moebius, n, CoordinateCircleInitializer({0, Eigen::Vector2d(0.3, 0.45), 2}));
  CAPTURE(failures(one.certificate), failures(two.certificate), one.solve.iterations, two.solve.iterations);
  CHECK((one.path.u.row(1).array().abs() == 0.5).count() > n / 4);
  CHECK(one.status == Status::certified);
  CHECK(two.status == Status::certified);
  const CostEstimate &a = one.certificate.estimate, &b = two.certificate.estimate;
  CHECK(std::abs(b.value - 2 * a.value) <= 2 * a.error + b.error);
  CHECK(b.error <= 64 / (1.0 * n * n) * b.value);
}

TEST_CASE("bounds contract: euclidean, a metric that pushes the path against the wall", "[contract]") {
  // The half-plane metric above y = 1/2 with a ceiling at y = 1.2, under the semicircle between (-1, 1) and (1, 1),
  // whose top is sqrt 2: two arcs of circles about the axis that touch the ceiling, and the piece of it between them.
  MetricFieldOptions metric;
  metric.field = leastcost::metric::HalfPlane{};
  const Problem problem = between(box(Eigen::Vector2d(-9, 0.5), Eigen::Vector2d(9, 1.2)),
                                  make_metric_field_cost(metric, 2), Eigen::Vector2d(-1, 1), Eigen::Vector2d(1, 1));
  const double top = 1.2, reach = std::sqrt(top * top - 1);
  const double length = 2 * std::acosh(top) + (2 - 2 * reach) / top;  // arc from angle asin(1 / top) to pi / 2
  const int n = GENERATE(20, 80, 199);
  const Result result = find(problem, n);
  check_hugging(result, length, 20 / (1.0 * n * n));
  CHECK(held_points(problem, result.path) > n / 4);
}

TEST_CASE("bounds contract: implicit, an obstacle cut out of a sphere", "[contract]") {
  // Without the cap above latitude 0.6: arcs of great circles that touch its edge, and the piece of the edge between
  // them.
  const double edge = 0.6, latitude = 0.2, apart = 3.0;
  const auto at = [](double u, double v) -> Eigen::VectorXd {
    return Eigen::Vector3d(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
  };
  const auto sphere = boxed("x^2 + y^2 + z^2 - 1", {}, Eigen::Vector3d(9, 9, std::sin(edge)));
  const Problem problem = between(sphere, make_euclidean_cost(3), at(0, latitude), at(apart, latitude));
  const double touch = std::acos(std::tan(latitude) / std::tan(edge));
  const double length = 2 * std::acos(std::sin(latitude) / std::sin(edge)) + (apart - 2 * touch) * std::cos(edge);
  const int n = GENERATE(20, 80, 199);
  const Result result = find(problem, n);
  check_hugging(result, length, 20 / (1.0 * n * n));
  CHECK(held_points(problem, result.path) > n / 10);
  CHECK(result.path.u.row(2).maxCoeff() == std::sin(edge));
}

TEST_CASE("bounds contract: implicit, the plane without a half-space", "[contract]") {
  // A wall on the saddle z = x y: the ruling x = 0.2 is a straight line of the surface, and shorter than any path
  // beyond it.
  const auto saddle = boxed("z - x*y", Eigen::Vector3d(0.2, -9, -9), {});
  const Problem problem =
      between(saddle, make_euclidean_cost(3), Eigen::Vector3d(0.2, -1, -0.2), Eigen::Vector3d(0.2, 1, 0.2));
  Points through(3, 1);
  through << 0.6, 0, 0;
  const Result result = find(problem, 40, WaypointsInitializer(through));
  CAPTURE(failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(std::abs(result.certificate.estimate.value - std::hypot(2, 0.4)) <= 1e-9);
}

TEST_CASE("manifold contract: implicit, in a box", "[contract]") {
  const auto cut = boxed("x^2/9 + y^2/4 + z^2 - 1", Eigen::Vector3d(-9, -1, -9), Eigen::Vector3d(2, 1.5, 9));
  const auto on = [cut](const Eigen::Vector3d& x) -> Eigen::VectorXd {
    CoordinatePath path{x, {}, true};
    REQUIRE(cut->project(path).failed.empty());
    return path.u.col(0);
  };
  ManifoldCase c{.manifold = cut,
                 .near = [on](Random& random) -> Eigen::VectorXd {
                   return on(Eigen::Vector3d(random.uniform(-1.5, 1), random.uniform(-0.5, 0.8), 0.9)) +
                          0.02 * random.vector(3);
                 },
                 .size = 3};
  for (const double off : {0.0, 1e-8, -1e-8})  // on a bound and beside it; then where two bounds meet
    for (const Eigen::Vector3d& x :
         {Eigen::Vector3d(2.4, 0.3, 0.6), Eigen::Vector3d(0.2, 1.8, 0.5), Eigen::Vector3d(0.3, -1.5, -0.8)})
      c.special.emplace_back(on(x) + off * Eigen::Vector3d::Ones());
  c.special.push_back(on(Eigen::Vector3d(2.4, -1.5, 0.5)));
  check_manifold_contract(c);
}

TEST_CASE("implicit in a box: nearest points against a search, and what is empty", "[contract]") {
  const auto cut = boxed("x^2 + y^2 + z^2 - 1", Eigen::Vector3d(-9, -9, -0.5), Eigen::Vector3d(0.6, 0.7, 9));
  Random random;
  for (int repeat = 0; repeat < 30; ++repeat) {
    Eigen::Vector3d x;
    do x = 1.2 * random.vector(3);
    while (x.norm() < 0.7 || x.norm() > 1.3);
    double moved = 0;
    const PathEnd end = project_end(*cut, x, &moved);
    double least = 10;  // over a grid of the sphere
    for (int i = 0; i < 400; ++i)
      for (int j = 0; j < 200; ++j) {
        const double u = 2 * kPi * i / 400, v = kPi * (j + 0.5) / 200;
        const Eigen::Vector3d y(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), std::cos(v));
        if (y.x() <= 0.6 && y.y() <= 0.7 && y.z() >= -0.5) least = std::min(least, (y - x).norm());
      }
    CAPTURE(x.transpose(), end.u.transpose(), moved, least);
    CHECK(cut->residual({end.u, {}, true}) <= 1e-14);
    // Newton steps end within O(d^2) of the nearest point; the grid is 0.016 wide.
    CHECK(moved <= least + 0.25 * moved * moved);
    CHECK(moved >= least - 0.04);
  }
  const auto empty = boxed("x^2 + y^2 + z^2 - 1", Eigen::Vector3d(2, -9, -9), {});
  CHECK_THROWS_AS(project_end(*empty, Eigen::Vector3d(1, 0.1, 0)), InputError);
  CHECK_THROWS_AS(boxed("x^2 + y^2 - 1", Eigen::Vector3d(0, 0, 0), {}, 2), OptionError);
}

TEST_CASE("bounds contract: mesh, around a hole", "[contract]") {
  const auto trace = std::make_shared<const TracePostProcessor>();
  const auto straighten = std::make_shared<const StraightenPostProcessor>();
  const auto square = sheet_with_hole(3);
  const Problem over_corners =
      between(square, make_euclidean_cost(3), Eigen::Vector3d(-2, 0.05, 0), Eigen::Vector3d(2, 0.05, 0));
  const Result exact = find_on_mesh(over_corners, DijkstraInitializer(), 40, {trace, straighten});
  CAPTURE(failures(exact.certificate));
  CHECK(exact.status == Status::certified);
  CHECK(exact.curve.cost == Approx(2 * std::hypot(1, 0.95) + 2).epsilon(1e-12));  // over (-1, 1) and (1, 1)
  // Not straightened, the chain itself rests against the border.
  const int sectors = 72;
  const Problem around =
      between(ring_sheet(sectors), make_euclidean_cost(3), Eigen::Vector3d(-2, 0.05, 0), Eigen::Vector3d(2, 0.05, 0));
  const Result taut = find_on_mesh(around, DijkstraInitializer(), 60, {trace, straighten});
  CHECK(taut.status == Status::certified);
  const Result chain = find_on_mesh(around, DijkstraInitializer(), 60, {trace});
  check_hugging(chain, taut.curve.cost, 0.01);
  CHECK(held_points(around, chain.path) > 10);
}

}  // namespace leastcost::test
