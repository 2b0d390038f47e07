// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fstream>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/initializers/cell_graph.hpp>
#include <leastcost/problems/initializers/coordinate_circle.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/initializers/eikonal.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/initializers/mirrored.hpp>
#include <leastcost/problems/initializers/plane_cut.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include "problems/readers/waypoint_reader.hpp"
#include "tests/contracts/initializer_contract.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/problems/sample_rasters.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/data.hpp"
#include "tests/support/random.hpp"
#include "tests/support/words.hpp"

namespace leastcost::test {
namespace {

std::shared_ptr<const MeshManifold> ball() {
  static const auto mesh = std::make_shared<const MeshManifold>(TriangleMesh(sphere(3)));
  return mesh;
}

/// Typical, nearly degenerate (ends 1e-8 apart, an end on or 1e-8 off a sample) and random ends on a sampled sphere.
std::vector<Problem> problems_on_cloud() {
  static const auto cloud = std::make_shared<const PointCloudManifold>(PointCloud(sphere_cloud(2000), {}));
  Random random;
  const Eigen::Vector3d a(0.1, 0.2, 0.97), b(0.9, -0.3, -0.3), off(1e-8, 2e-8, 0);
  const Eigen::Vector3d sample = cloud->cloud().sample(5).position + cloud->cloud().centre();
  const Eigen::Vector3d c = random.vector(3).normalized(), d = random.vector(3).normalized();
  std::vector<Problem> all;
  for (const auto& [from, to] : std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>{
           {a, b}, {a, a + off}, {sample, b}, {a, sample}, {sample + off, b}, {c, d}})
    all.push_back(between(cloud, make_euclidean_cost(3), from, to));
  return all;
}

/// Typical, nearly degenerate (ends 1e-8 apart, an end on or 1e-8 off a vertex) and random ends on the ball.
std::vector<Problem> problems_on_mesh() {
  Random random;
  const Eigen::Vector3d a(0.1, 0.2, 0.97), b(0.9, -0.3, -0.3), v = ball()->mesh().position(5);
  const Eigen::Vector3d off(1e-8, 2e-8, 0);
  std::vector<Problem> all;
  for (const auto& [from, to] : std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>{
           {a, b}, {a, a + off}, {v, b}, {a, v}, {v + off, b}, {random.vector(3), random.vector(3)}})
    all.push_back(between(ball(), make_euclidean_cost(3), from, to));
  return all;
}

/// The same in the plane, with a bead whose straight line is infinitely slow.
std::vector<Problem> problems_in_plane() {
  Random random;
  const Eigen::Vector2d zero(0, 0), off(1e-8, 0), side(1, 0);
  return {between(space(2), make_euclidean_cost(2), zero, side), between(space(2), make_euclidean_cost(2), zero, off),
          between(space(2), make_euclidean_cost(2), random.vector(2), random.vector(2)), bead(zero, side),
          bead(zero, Eigen::Vector2d(1, -1e-8))};
}

Points triangle_around_z() {
  Points points(3, 3);
  points << 1, -0.5, -0.5, 0, 0.8, -0.8, 0.1, 0.1, 0.1;
  return points;
}

}  // namespace

TEST_CASE("initializer contract: straight", "[contract]") {
  for (const Problem& problem : problems_in_plane()) check_initializer_contract(StraightInitializer(), problem);
  check_initializer_contract(StraightInitializer(), problems_on_mesh().front());
  CHECK_THROWS_AS(StraightInitializer().first_path(closed(space(2), make_euclidean_cost(2)), {}), InitializationError);
}

TEST_CASE("initializer contract: bow", "[contract]") {
  const BowInitializer bow({GENERATE(0.1, 0.5), GENERATE(0.0, 120.0, 180.0)});
  const auto ends = [](int d) { return std::pair(Eigen::VectorXd::Zero(d), Eigen::VectorXd::Ones(d)); };
  for (const int d : {2, 3, 7}) {
    const auto [a, b] = ends(d);
    check_initializer_contract(bow, between(space(d), make_euclidean_cost(d), a, b));
  }
  check_initializer_contract(bow, problems_on_mesh().front());
}

TEST_CASE("initializer contract: eikonal", "[contract]") {
  for (const Problem& problem : problems_in_plane()) check_initializer_contract(EikonalInitializer(), problem);
}

TEST_CASE("initializer contract: cell_graph", "[contract]") {
  const RasterGrid raster = with_gap(raster_of(8, 9, [](double x, double y) { return 2 + std::sin(3 * x + y); }), 4, 4);
  const Problem problem =
      between(space(2), make_cost_map(raster, CostMapInterpolation::cells, 2), raster.place(1, 0), raster.place(7, 8));
  for (const int points : {0, 3}) check_initializer_contract(CellGraphInitializer({points}), problem);
  Problem within = problem;
  within.target.u = raster.place(4, 4);
  CHECK_THROWS_WITH(CellGraphInitializer().first_path(within, {}), Catch::Contains("is in a cell without data"));
}

TEST_CASE("initializer contract: coordinate_circle", "[contract]") {
  const Problem strip =
      closed(make_parametric_manifold({.surface = parametric::MoebiusStrip{}}), make_euclidean_cost(3));
  const Problem torus = closed(make_parametric_manifold({.surface = parametric::Torus{}}), make_euclidean_cost(3));
  check_initializer_contract(CoordinateCircleInitializer({1, Eigen::Vector2d(0.3, 0.1), 1}), torus);
  check_initializer_contract(CoordinateCircleInitializer({0, Eigen::Vector2d(0.3, 0), 1}), strip);
  check_initializer_contract(CoordinateCircleInitializer({0, Eigen::Vector2d(0.3, 0.2), 2}), strip);
  // Off the middle one turn ends on the other side of the strip.
  CHECK_THROWS_WITH(CoordinateCircleInitializer({0, Eigen::Vector2d(0.3, 0.2), 1}).first_path(strip, {}),
                    Catch::Contains("even number of turns"));
  CHECK_THROWS_AS(CoordinateCircleInitializer({1, Eigen::Vector2d(0.3, 0), 1}).first_path(strip, {}), OptionError);
}

namespace {

std::shared_ptr<const LevelSet> surface(const char* type) {
  return make_implicit_manifold({.surface = form<implicit::Surface>(type)});
}

/// Problems on smooth surfaces; `across`: also such whose straight line runs through the middle.
std::vector<Problem> problems_on_surfaces(bool across) {
  const auto sphere = surface("sphere"), torus = surface("torus"), genus2 = surface("genus2");
  const auto cost = make_euclidean_cost(3);
  Random random;
  const Eigen::Vector3d x(1, 0, 0), off(0, 1e-8, 0);
  std::vector<Problem> all = {between(sphere, cost, x, Eigen::Vector3d(0, 0.6, 0.8)), between(sphere, cost, x, x + off),
                              between(sphere, cost, random.vector(3), random.vector(3)),
                              between(torus, cost, 3 * x, Eigen::Vector3d(0, 3, 0)),
                              between(genus2, cost, Eigen::Vector3d(0.5, 1, 0.3), Eigen::Vector3d(-0.5, -1, 0.5))};
  if (!across) return all;
  all.push_back(between(sphere, cost, x, -x));
  all.push_back(between(sphere, cost, x, -x + off));
  all.push_back(between(torus, cost, 3 * x, -3 * x));
  all.push_back(between(torus, cost, 3 * x, x));
  return all;
}

/// Largest move between neighbours, in lengths of the path.
double longest_move(const CoordinatePath& path) {
  const Index m = path.u.cols() - 1;
  const Eigen::VectorXd moves = (path.u.rightCols(m) - path.u.leftCols(m)).colwise().norm();
  return moves.maxCoeff() / moves.sum();
}

}  // namespace

TEST_CASE("initializer contract: straight, on smooth surfaces", "[contract]") {
  for (const Problem& problem : problems_on_surfaces(false)) check_initializer_contract(StraightInitializer(), problem);
  // Through the middle there is no continuous projection, whatever the number of points: an error, never a path with a
  // jump.
  const auto refused = [](const std::shared_ptr<const LevelSet>& domain, const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b) {
    try {
      StraightInitializer().first_path(between(domain, make_euclidean_cost(3), a, b), {});
      return std::string("accepted");
    } catch (const InitializationError& error) {
      return std::string(error.what());
    }
  };
  const Eigen::Vector3d x(1, 0, 0);
  CHECK_THAT(refused(surface("sphere"), x, -x), Catch::Contains("no continuous projection"));
  CHECK_THAT(refused(surface("torus"), 3 * x, -3 * x), Catch::Contains("no continuous projection"));
  CHECK_THAT(refused(surface("torus"), 3 * x, x), Catch::Contains("no continuous projection"));
}

TEST_CASE("initializer contract: mirrored", "[contract]") {
  const MirroredInitializer bow(std::make_shared<const BowInitializer>(BowOptions{0.3, 0}));
  for (const int d : {2, 3, 7}) {
    const Problem problem =
        between(space(d), make_euclidean_cost(d), Eigen::VectorXd::Zero(d), Eigen::VectorXd::Ones(d));
    check_initializer_contract(bow, problem);
    const Points a = BowInitializer({0.3, 0}).first_path(problem, {}).path.u, b = bow.first_path(problem, {}).path.u;
    CHECK((BowInitializer({0.3, 180}).first_path(problem, {}).path.u - b).cwiseAbs().maxCoeff() <= 1e-14);
    CHECK((a - b).cwiseAbs().maxCoeff() > 0.1);
  }
  check_initializer_contract(bow, problems_on_surfaces(false).front());
  check_initializer_contract(bow, problems_on_mesh().front());
  // On a sphere the mirror image of a detour is the detour to the other side.
  Points through(3, 1);
  through << 0.7, 0.7, 0.1;
  const Problem sphere =
      between(surface("sphere"), make_euclidean_cost(3), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1));
  const MirroredInitializer way(std::make_shared<const WaypointsInitializer>(through));
  CHECK(WaypointsInitializer(through).first_path(sphere, {}).path.u.row(1).maxCoeff() > 0.5);
  CHECK(way.first_path(sphere, {}).path.u.row(1).minCoeff() < -0.5);
  CHECK_THROWS_AS(bow.first_path(closed(space(2), make_euclidean_cost(2)), {}), InitializationError);
}

TEST_CASE("initializer contract: rrt", "[contract]") {
  for (const Problem& problem : problems_on_surfaces(true)) {
    check_initializer_contract(RrtInitializer(), problem);
    CHECK(longest_move(RrtInitializer({}, 3).first_path(problem, {}).path) < 0.2);
  }
  for (const Problem& problem : problems_in_plane()) check_initializer_contract(RrtInitializer(), problem);
  CHECK_THROWS_AS(RrtInitializer().first_path(closed(space(2), make_euclidean_cost(2)), {}), InitializationError);
  CHECK_THROWS_AS(RrtInitializer().first_path(problems_on_mesh().front(), {}), InitializationError);
}

TEST_CASE("initializer contract: rrt, seeds and failures", "[contract]") {
  const Problem across = problems_on_surfaces(true)[7];
  const auto path = [&](int seed) { return RrtInitializer({}, seed).first_path(across, {}).path.u; };
  CHECK(path(1) == path(1));
  CHECK((path(1).cols() != path(2).cols() || path(1) != path(2)));
  RrtOptions own;
  own.seed = 1;
  CHECK(RrtInitializer(own, 2).first_path(across, {}).path.u == path(1));

  const auto message = [](const Problem& problem, const RrtOptions& options, const Monitor& monitor = {}) {
    try {
      RrtInitializer(options).first_path(problem, monitor);
      return std::string("found");
    } catch (const Error& error) {  // InitializationError, or Interrupted
      return std::string(error.what());
    }
  };
  // Two spheres that do not touch: no tree gets from one to the other.
  implicit::Formula two;
  two.f = "((x - 2)^2 + y^2 + z^2 - 1) * ((x + 2)^2 + y^2 + z^2 - 1)";
  const Problem apart = between(make_implicit_manifold({.surface = two}), make_euclidean_cost(3),
                                Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(-3, 0, 0));
  CHECK_THROWS_AS(RrtInitializer({.step = 0}), OptionError);
  CHECK_THROWS_AS(RrtInitializer({.shell = -1}), OptionError);
  RrtOptions few;
  few.max_nodes = 300;
  CHECK_THAT(message(apart, few), Catch::Contains("no path after ") && Catch::Contains("came within"));
  few.max_nodes = 3;
  CHECK_THAT(message(across, few), Catch::Contains("no path after 3 nodes"));
  CHECK_THAT(message(across, {}, {.observe = {}, .stop_requested = [] { return true; }, .deadline = {}}),
             Catch::Contains("interrupted after 2 nodes"));
}

TEST_CASE("initializer contract: dijkstra", "[contract]") {
  for (const Problem& problem : problems_on_mesh()) check_initializer_contract(DijkstraInitializer(), problem);
  for (const Problem& problem : problems_on_cloud()) check_initializer_contract(DijkstraInitializer(), problem);
  for (const int rank : {2, 3}) {
    for (const Problem& problem : problems_on_mesh())
      check_initializer_contract(DijkstraInitializer({.routes = 1, .rank = rank}), problem);
    check_initializer_contract(DijkstraInitializer({.routes = 1, .rank = rank}), problems_on_cloud().front());
  }
  CHECK_THROWS_AS(DijkstraInitializer({.routes = 2, .rank = 2}).first_path(problems_on_mesh().front(), {}),
                  OptionError);
  CHECK_THROWS_AS(DijkstraInitializer({2}).first_path(problems_on_cloud().front(), {}), InputError);
  CHECK_THROWS_AS(DijkstraInitializer().first_path(problems_in_plane().front(), {}), InputError);
  CHECK_THROWS_AS(DijkstraInitializer().first_path(closed(ball(), make_euclidean_cost(3)), {}), InitializationError);
}

TEST_CASE("initializer contract: plane_cut", "[contract]") {
  Random random;
  const Eigen::Vector3d v = ball()->mesh().position(5), x(1, 0, 0);
  for (const auto& [point, normal] : std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>{
           {{0.1, 0.2, 0.3}, {1, 2, 3}},
           {{0, 0, 0}, {0, 0, 1}},  // edges and vertices in the plane
           {v, x},
           {v + Eigen::Vector3d::Constant(1e-8), x},
           {0.5 * random.vector(3).normalized(), random.vector(3)}})
    check_initializer_contract(PlaneCutInitializer({point, normal}), closed(ball(), make_euclidean_cost(3)));
  const PlaneCutInitializer equator({x, Eigen::Vector3d(0, 0, 1)}), outside({2 * x, x});
  CHECK_THROWS_AS(outside.first_path(closed(ball(), make_euclidean_cost(3)), {}), InitializationError);
  CHECK_THROWS_AS(equator.first_path(problems_on_mesh().front(), {}), InitializationError);
  CHECK_THROWS_AS(equator.first_path(closed(space(3), make_euclidean_cost(3)), {}), InputError);
  CHECK_THROWS_AS(PlaneCutInitializer({x, Eigen::Vector3d(0, 0, 0)}), OptionError);
  CHECK_THROWS_AS(PlaneCutInitializer({Eigen::Vector2d(1, 0), x}), OptionError);
}

TEST_CASE("initializer contract: waypoints", "[contract]") {
  const WaypointsInitializer below(Eigen::Vector2d(0.3, -0.5)), around(triangle_around_z());
  for (const Problem& problem : problems_in_plane()) check_initializer_contract(below, problem);
  for (const Problem& problem : problems_on_mesh()) check_initializer_contract(around, problem);
  check_initializer_contract(around, closed(space(3), make_euclidean_cost(3)));
  check_initializer_contract(around, closed(ball(), make_euclidean_cost(3)));
  CHECK_THROWS_AS(WaypointsInitializer(Points(2, 0)), OptionError);
}

TEST_CASE("initializer contract: file", "[contract]") {
  const ScratchDir folder;
  std::ofstream(folder / "tour.csv") << "x,y,z\n1,0,0.1\n-0.5,0.8,0.1\n-0.5,-0.8,0.1\n";
  const WaypointsInitializer around(read_waypoints(folder / "tour.csv", {"x", "y", "z"}));
  for (const Problem& problem : problems_on_mesh()) check_initializer_contract(around, problem);
  check_initializer_contract(around, closed(ball(), make_euclidean_cost(3)));
}

namespace {

template <class Work>
std::string why_there_is_none(const Work& work) {
  try {
    work();
    return "there is a path";
  } catch (const InitializationError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("initializer contract: grid", "[contract]") {
  const auto among = [](std::shared_ptr<const ConstraintManifold> domain, FreeSpace::Obstacles obstacles) {
    return std::make_shared<const FreeSpace>(std::move(domain), std::move(obstacles), 0.1);
  };
  const GridInitializer grid;
  SECTION("in the plane, without a box") {
    const auto wall = make_box_obstacle({Eigen::Vector2d(0.4, -3), Eigen::Vector2d(0.6, 0.5)});
    const Problem problem =
        between(among(space(2), {wall}), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0));
    check_initializer_contract(grid, problem);
    const Points u = grid.first_path(problem, {}).path.u;
    // Around the corners, 0.1 off them, it is 2 x 0.67 + 0.2 + a little; a route over the grid is at most 8 % longer.
    const double length = (u.rightCols(u.cols() - 1) - u.leftCols(u.cols() - 1)).colwise().norm().sum();
    CHECK(length > 2 * std::hypot(0.4, 0.6) + 0.2);
    CHECK(length < 1.08 * (2 * std::hypot(0.4, 0.6) + 0.3));
    const auto* obstacles = find_ability<ChecksMoves>(*problem.manifold);
    for (Index k = 0; k + 1 < u.cols(); ++k) CHECK(obstacles->clearance(u.col(k), u.col(k + 1)).lower >= 0);
  }
  SECTION("in a box in space") {
    const auto domain = box(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(2, 1, 1));
    const auto wall = make_box_obstacle({Eigen::Vector3d(0.4, -1, -1), Eigen::Vector3d(0.6, 1, 0.5)});
    const Problem problem =
        between(among(domain, {wall}), make_euclidean_cost(3), Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0.2, -0.1));
    check_initializer_contract(grid, problem);
    CHECK(grid.first_path(problem, {}).path.u.row(2).maxCoeff() > 0.6);
  }
  SECTION("a cost that is infinite somewhere, and no obstacles") {
    check_initializer_contract(grid, bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(3, -2)));
  }
  SECTION("a gap that only a finer grid sees") {
    const auto domain = box(Eigen::Vector2d(-2, -2), Eigen::Vector2d(3, 2));
    const auto lower = make_box_obstacle({Eigen::Vector2d(0.4, -2), Eigen::Vector2d(0.6, 0.7)});
    const auto upper = make_box_obstacle({Eigen::Vector2d(0.4, 0.94), Eigen::Vector2d(0.6, 2)});
    const Problem problem =
        between(among(domain, {lower, upper}), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0));
    GridOptions once{.resolution = 0.5, .refinements = 0};
    check_initializer_contract(GridInitializer(once), problem);  // by random trees
    once.trees = false;
    const GridInitializer coarse(once), fine({.resolution = 0.5, .refinements = 5});
    CHECK_THAT(why_there_is_none([&] { coarse.first_path(problem, {}); }),
               Catch::Contains("no passage at this resolution: 10 x 8 cells of 0.5"));
    check_initializer_contract(fine, problem);
  }
  SECTION("what it does not work on") {
    CHECK_THAT(why_there_is_none([&] {
                 grid.first_path(
                     between(space(4), make_euclidean_cost(4), Eigen::Vector4d::Zero(), Eigen::Vector4d::Ones()), {});
               }),
               Catch::Contains("in the plane and in space"));
    CHECK_THROWS_AS(GridInitializer({.resolution = -1.0}), OptionError);
  }
}

}  // namespace leastcost::test
