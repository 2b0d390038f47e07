// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <filesystem>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/layers.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/costs/walking.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/initializers/plane_cut.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/mesh/edge_graph.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/post_processors/cell_bound.hpp>
#include <leastcost/problems/post_processors/fastest_refraction.hpp>
#include <leastcost/problems/post_processors/on_surface.hpp>
#include <leastcost/problems/post_processors/refract.hpp>
#include <leastcost/problems/post_processors/refract_cells.hpp>
#include <leastcost/problems/post_processors/shortest.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/switchbacks.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include "framework/energy/spacing.hpp"
#include "problems/mesh/mesh_curve.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/random.hpp"
#include "tests/support/words.hpp"

namespace leastcost::test {
namespace {

constexpr int kPoints = 12;
constexpr double kBarycentricRounding =
    1e-14;  // length units: points go through barycentric coordinates; the ball has size 1

std::shared_ptr<const MeshManifold> small_ball() {
  static const auto mesh = std::make_shared<const MeshManifold>(TriangleMesh(sphere(3)));
  return mesh;
}

std::shared_ptr<const ConstantMetricCost> stretched() {
  MetricTensorOptions options;
  options.matrix = Eigen::Vector3d(1, 2, 3).asDiagonal();
  return make_metric_tensor_cost(options, 3);
}

/// Typical, nearly degenerate (an end 1e-8 off a vertex) and random ends, under two costs.
std::vector<Problem> problems() {
  Random random;
  const Eigen::Vector3d a(0.1, 0.2, 0.97), b(0.9, -0.3, -0.3), v = small_ball()->mesh().position(5), off(1e-8, 2e-8, 0);
  std::vector<Problem> all;
  for (const auto& cost : {make_euclidean_cost(3), stretched()})
    for (const auto& [from, to] : std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>{
             {a, b}, {v, b}, {v + off, a}, {random.vector(3), random.vector(3)}})
      all.push_back(between(small_ball(), cost, from, to));
  return all;
}

/// Every segment of the curve lies in the face that carries it, and the reported costs are those of the curve.
void check_curve(const Problem& problem, const Curve& curve) {
  const Index segments = curve.x.cols() - 1;
  REQUIRE(segments >= 1);
  REQUIRE(static_cast<Index>(curve.segment_sites.size()) == segments);
  for (Index i = 0; i < segments; ++i) {
    const Site face = curve.segment_sites[static_cast<std::size_t>(i)];
    REQUIRE((face >= 0 && face < small_ball()->mesh().face_count()));
    for (const double t : {0.0, 0.5, 1.0}) {
      const Eigen::Vector3d x = (1 - t) * curve.x.col(i) + t * curve.x.col(i + 1);
      const auto& [p, q, r] = small_ball()->mesh().face(face);
      const TriangleMesh alone(
          {{small_ball()->mesh().position(p), small_ball()->mesh().position(q), small_ball()->mesh().position(r)},
           {0, 1, 2},
           {0, 3},
           "face"});
      CHECK(ClosestPointTree(alone).nearest(x).distance <= kBarycentricRounding);
    }
  }
  const Eigen::VectorXd costs = segment_costs(*problem.cost, {{curve.x.data(), 3, curve.x.cols()}, {}, false});
  CHECK(curve.cost == Approx(costs.sum()).epsilon(1e-12));
}

/// The curve joins the ends on the surface, the chain lies on the curve with as many points as before.
PostProcessed check_post_processor_contract(const PostProcessor& post_processor, const Problem& problem) {
  CAPTURE(post_processor.name(), problem.source.u.transpose(), problem.target.u.transpose());
  CHECK_FALSE(post_processor.name().empty());
  const FirstPath first = DijkstraInitializer().first_path(problem, {});
  const CoordinatePath chain = sample_equally(problem, first.path, kPoints);
  PostProcessed made = post_processor.apply(problem, first, as_delivered(problem, chain), {});
  check_curve(problem, made.curve);
  REQUIRE(made.chain.u.cols() == chain.u.cols());
  CHECK(problem.manifold->residual(made.chain) <= kBarycentricRounding);
  for (const Points& points : {made.curve.x, made.chain.u}) {
    CHECK((points.col(0) - problem.source.u).norm() <= kBarycentricRounding);
    CHECK((points.rightCols(1) - problem.target.u).norm() <= kBarycentricRounding);
  }
  REQUIRE(made.curve_costs.size() == made.chain.segment_count());
  CHECK(made.curve_costs.sum() == Approx(made.curve.cost).epsilon(1e-12));
  return made;
}

}  // namespace

TEST_CASE("post_processor contract: trace", "[contract]") {
  for (const Problem& problem : problems()) check_post_processor_contract(TracePostProcessor(), problem);
}

TEST_CASE("post_processor contract: straighten", "[contract]") {
  for (const Problem& problem : problems()) {
    const PostProcessed made = check_post_processor_contract(StraightenPostProcessor(), problem);
    const CoordinatePath edges = DijkstraInitializer().first_path(problem, {}).path;
    CHECK(made.curve.cost <= PathEnergy(problem, 1).cost(edges) * (1 + 1e-12));  // no step may lengthen the path
    REQUIRE(made.curve.straightness);
    CHECK(*made.curve.straightness >= -1e-7);  // radians; angles of lengths with rounding 1e-16 near pi
    CHECK(spread(made.curve_costs) <= 1e-9);
  }
}

/// After straighten: never longer, straight, on the surface, with a bound below it; refused where it cannot unfold.
TEST_CASE("post_processor contract: shortest", "[contract]") {
  for (const Problem& problem : problems()) {
    const FirstPath first = DijkstraInitializer().first_path(problem, {});
    const PostProcessed chain = as_delivered(problem, sample_equally(problem, first.path, kPoints));
    const PostProcessed straight = StraightenPostProcessor().apply(problem, first, chain, {});
    const PostProcessed made = ShortestPostProcessor().apply(problem, first, straight, {});
    check_curve(problem, made.curve);
    REQUIRE(made.curve.global);
    CHECK(made.curve.global->proved);
    CHECK(made.curve.global->gap <= 1e-9);
    CHECK(made.curve.global->lower_bound <= made.curve.cost * (1 + 1e-14));
    CHECK(made.curve.cost <= straight.curve.cost);
    REQUIRE(made.curve.straightness);
    CHECK(*made.curve.straightness >= -1e-7);
    CHECK(spread(made.curve_costs) <= 1e-9);
    CHECK(made.chain.u.cols() == chain.chain.u.cols());
    CHECK(made.chain.u.col(0) == problem.source.u);
    CHECK(made.chain.u.rightCols(1) == problem.target.u);
    CHECK_FALSE(ShortestPostProcessor(GlobalOff{}).apply(problem, first, straight, {}).curve.global);
  }
}

/// One object, two domains, landmarks of each: made, written, read again, and of the other domain refused.
TEST_CASE("post_processor contract: shortest with an index on disk", "[contract]") {
  const auto file = std::filesystem::temp_directory_path() / "leastcost_shortest_test.landmarks";
  std::filesystem::remove(file);
  const ShortestPostProcessor with_index(GlobalBudget{.landmarks = 3, .index = file.string()});
  const std::vector<Problem> all = problems();
  const auto prove = [&](const ShortestPostProcessor& shortest, const Problem& problem) {
    const FirstPath first = DijkstraInitializer().first_path(problem, {});
    const PostProcessed chain = as_delivered(problem, sample_equally(problem, first.path, kPoints));
    const PostProcessed straight = StraightenPostProcessor().apply(problem, first, chain, {});
    return shortest.apply(problem, first, straight, {}).curve.global.value();
  };
  const GlobalBound made = prove(with_index, all.front());
  CHECK(made.bound == "euclid + 3 landmarks");
  CHECK(made.proved);
  CHECK(std::filesystem::exists(file));
  CHECK(prove(with_index, all.front()).steps == made.steps);  // kept
  const ShortestPostProcessor again(GlobalBudget{.index = file.string()});
  CHECK(prove(again, all.front()).steps == made.steps);  // read
  bool refused = false;
  for (const Problem& problem : all) {
    const auto* cost = find_ability<HasConstantMetric>(*problem.cost);
    if (cost->metric().isIdentity()) continue;
    refused = true;
    CHECK_THROWS_WITH(prove(again, problem), Catch::Contains("another metric"));
  }
  CHECK(refused);
  std::filesystem::remove(file);
}

/// The long way round a ball: the shortest path of all is delivered in its place, and the note says so.
TEST_CASE("post_processor contract: shortest leaves a class that is not the best", "[contract]") {
  const Problem problem = between(small_ball(), make_euclidean_cost(3), Eigen::Vector3d(1, 0, 0.1),
                                  Eigen::Vector3d(std::cos(2.5), std::sin(2.5), -0.1));
  const TriangleMesh& mesh = small_ball()->mesh();
  const PostProcessed chain =
      as_delivered(problem, sample_equally(problem, DijkstraInitializer().first_path(problem, {}).path, kPoints));
  PostProcessed longer =
      StraightenPostProcessor().apply(problem, DijkstraInitializer().first_path(problem, {}), chain, {});
  const double shortest = longer.curve.cost;
  // A detour over the pole, not straight: that it is as straight as it says is not what is asked here.
  EdgeGraphSearch graph(mesh);
  const auto length = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (b - a).norm(); };
  const SurfacePoint pole = vertex_point(mesh, 0);
  const std::vector<SurfacePoint> ends = surface_points(mesh, chain.chain);
  SurfacePath way = graph.shortest(ends.front(), pole, length).path;
  const SurfacePath on = graph.shortest(pole, ends.back(), length).path;
  way.points.insert(way.points.end(), on.points.begin() + 1, on.points.end());
  way.faces.insert(way.faces.end(), on.faces.begin(), on.faces.end());
  longer.curve = as_curve(problem, way);
  longer.curve.straightness = 0;
  const PostProcessed made = ShortestPostProcessor().apply(problem, {}, longer, {});
  CHECK(made.curve.global->outcome == ProofOutcome::improved);
  CHECK(made.curve.cost <= shortest * (1 + 1e-12));
  CHECK(made.curve.straightness.value() >= -1e-7);
  REQUIRE(made.notes.size() == longer.notes.size() + 1);
  CHECK_THAT(made.notes.back(), Catch::Contains("a shorter path than the straightened one was found"));
}

/// The curve joins the ends clear of the obstacles, the chain lies on it with as many points as before.
TEST_CASE("post_processor contract: taut", "[contract]") {
  Problem problem = between(space(2), make_euclidean_cost(2), Eigen::Vector2d(-2, 0), Eigen::Vector2d(2, 0));
  const auto disc = make_ball({.center = Eigen::Vector2d(0, 0.1), .radius = 0.7});
  problem.manifold = std::make_shared<const FreeSpace>(problem.manifold, FreeSpace::Obstacles{disc}, 0.1);
  FirstPath first;
  first.path.u = Eigen::Matrix2Xd{{-2, 0, 2}, {0, -1.5, 0}};
  const CoordinatePath chain = sample_equally(problem, first.path, kPoints);
  const PostProcessed made = TautPostProcessor().apply(problem, first, as_delivered(problem, chain), {});
  REQUIRE(made.chain.u.cols() == chain.u.cols());
  CHECK(problem.manifold->residual(made.chain) <= kBarycentricRounding);
  for (const Points& points : {made.curve.x, made.chain.u}) {
    CHECK(points.col(0) == problem.source.u);
    CHECK(points.rightCols(1) == problem.target.u);
  }
  CHECK(measure_clearance(*problem.manifold, made.curve.x, false, {})->lower >= -1e-13);
  const Eigen::VectorXd costs =
      segment_costs(*problem.cost, {{made.curve.x.data(), 2, made.curve.x.cols()}, {}, false});
  CHECK(made.curve.cost == Approx(costs.sum()).epsilon(1e-13));
  CHECK(made.curve_costs.sum() == Approx(made.curve.cost).epsilon(1e-13));
  CHECK(spread(made.curve_costs) <= 1e-12);
  CHECK(*made.curve.least_of_class <= made.curve.cost);
  CHECK(made.curve.straightness == 0);
}

TEST_CASE("post_processor contract: refract_cells", "[contract]") {
  RasterGrid raster;
  raster.rows = 4, raster.columns = 5;
  raster.cell = {0.5, 1};
  raster.values = {2, 1, 4, 3, 1, 5, 2, 2, 7, 3, 1, 6, 1, 2, 2, 4, 3, 8, 1, 1};
  const Problem problem = between(space(2), make_cost_map(raster, CostMapInterpolation::cells, 2),
                                  Eigen::Vector2d(0.2, 0.3), Eigen::Vector2d(2.4, 3.9));
  const FirstPath first = StraightInitializer().first_path(problem, {});
  const PostProcessed chain = as_delivered(problem, sample_equally(problem, first.path, kPoints));
  const PostProcessed made = RefractCellsPostProcessor().apply(problem, first, chain, {});
  for (const Points& points : {made.curve.x, made.chain.u}) {
    CHECK(points.col(0) == problem.source.u);
    CHECK(points.rightCols(1) == problem.target.u);
  }
  REQUIRE(made.chain.u.cols() == chain.chain.u.cols());
  const Eigen::VectorXd costs =
      segment_costs(*problem.cost, {{made.curve.x.data(), 2, made.curve.x.cols()}, {}, false});
  CHECK(made.curve.cost == Approx(costs.sum()).epsilon(1e-13));
  CHECK(made.curve_costs.sum() == Approx(made.curve.cost).epsilon(1e-13));
  CHECK(spread(made.curve_costs) <= 1e-12);
  CHECK(made.curve.cost < chain.curve.cost);
  REQUIRE(made.curve.least_of_class);
  CHECK(*made.curve.least_of_class <= made.curve.cost);
  CHECK(*made.curve.least_of_class >= made.curve.cost * (1 - 1e-12));
  CHECK(made.curve.straightness >= -1e-12);
  const PostProcessed bounded = CellBoundPostProcessor().apply(problem, first, made, {});
  REQUIRE(bounded.curve.global);
  CHECK(bounded.curve.global->lower_bound <= made.curve.cost);
  CHECK(bounded.curve.x == made.curve.x);
  const Problem other = between(space(2), make_euclidean_cost(2), problem.source.u, problem.target.u);
  CHECK_THROWS_WITH(RefractCellsPostProcessor().apply(other, first, chain, {}),
                    Catch::Contains("refract_cells needs a cost map that is constant in each cell"));
}

TEST_CASE("post_processor contract: refract", "[contract]") {
  const int d = GENERATE(2, 3);
  LayersOptions options;
  options.interfaces = Eigen::Vector2d(0, 1);
  options.indices = Eigen::Vector3d(0.6, 1.5, 1);
  options.normals = Eigen::MatrixXd::Zero(2, d);
  options.normals->rightCols(1).setOnes();
  options.normals->col(0) << 0.1, -0.05;
  Eigen::VectorXd source = Eigen::VectorXd::Zero(d), target = source;
  source[0] = -2;
  target[0] = 2;
  source[d - 1] = -1;
  target[d - 1] = 2;
  const Problem problem = between(space(d), make_layers_cost(options, d), source, target);
  const FirstPath first = StraightInitializer().first_path(problem, {});
  const PostProcessed chain = as_delivered(problem, sample_equally(problem, first.path, kPoints));
  const PostProcessed made = RefractPostProcessor().apply(problem, first, chain, {});
  for (const Points& points : {made.curve.x, made.chain.u}) {
    CHECK(points.col(0) == problem.source.u);
    CHECK(points.rightCols(1) == problem.target.u);
  }
  REQUIRE(made.chain.u.cols() == chain.chain.u.cols());
  const Eigen::VectorXd costs =
      segment_costs(*problem.cost, {{made.curve.x.data(), d, made.curve.x.cols()}, {}, false});
  CHECK(made.curve.cost == Approx(costs.sum()).epsilon(1e-13));
  CHECK(made.curve_costs.sum() == Approx(made.curve.cost).epsilon(1e-13));
  CHECK(spread(made.curve_costs) <= 1e-12);
  CHECK(made.curve.cost < chain.curve.cost);
  REQUIRE(made.curve.least_of_class);
  CHECK(*made.curve.least_of_class <= made.curve.cost);
  CHECK(*made.curve.least_of_class >= made.curve.cost * (1 - 1e-12));
  CHECK(*made.curve.straightness == 0);
  const PostProcessed all = FastestRefractionPostProcessor().apply(problem, first, made, {});
  REQUIRE(all.curve.global);
  CHECK(all.curve.global->proved);
  CHECK(all.curve.cost <= made.curve.cost);
  CHECK_FALSE(FastestRefractionPostProcessor(GlobalOff{}).apply(problem, first, made, {}).curve.global);
  // A polyline that does not obey Snell's law is told from one that does.
  Points off = made.curve.x;
  off.col(1) += 1e-6 * Eigen::VectorXd::Unit(d, 0);
  CHECK(find_ability<HasInterfaces>(*problem.cost)->crossings(off, *problem.manifold).front().mismatch > 1e-8);
}

TEST_CASE("post_processor contract: on_surface", "[contract]") {
  ImplicitManifoldOptions options;
  options.surface = form<implicit::Surface>(GENERATE("sphere", "torus", "genus2", "gyroid"));
  const auto manifold = make_implicit_manifold(options);
  const Problem problem =
      between(manifold, make_euclidean_cost(3), Eigen::Vector3d(0.9, 1, 0.3), Eigen::Vector3d(0.9, -1, 0.5));
  const FirstPath first = StraightInitializer().first_path(problem, {});
  const PostProcessed chain = as_delivered(problem, sample_equally(problem, first.path, kPoints));
  double before = chain.curve.cost;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    CAPTURE(type_of(options.surface), tolerance);
    const PostProcessed made = OnSurfacePostProcessor({tolerance}).apply(problem, first, chain, {});
    const Points& x = made.curve.x;
    const Index m = x.cols() - 1;
    CHECK(made.notes.empty());
    CHECK(made.chain.u == chain.chain.u);
    CHECK(x.col(0) == problem.source.u);
    CHECK(x.col(m) == problem.target.u);
    CHECK(manifold->residual({x, {}, true}) <= kBarycentricRounding);
    for (const double t : {0.1, 0.25, 0.5, 0.8})
      CHECK(manifold->residual({(1 - t) * x.leftCols(m) + t * x.rightCols(m), {}, true}) <= tolerance);
    REQUIRE(made.curve_costs.size() == chain.chain.segment_count());
    CHECK(made.curve_costs.sum() == Approx(made.curve.cost).epsilon(1e-12));
    const Eigen::VectorXd costs = segment_costs(*problem.cost, {{x.data(), 3, x.cols()}, {}, false});
    CHECK(made.curve.cost == Approx(costs.sum()).epsilon(1e-12));
    CHECK(made.curve.cost >= before * (1 - 1e-14 * kPoints));  // points are only put in
    before = made.curve.cost;
  }
}

TEST_CASE("VFCS Eq. (16): on_surface puts the points over a segment into the plane of chord and mean normal",
          "[contract]") {
  ImplicitManifoldOptions options;
  options.surface = form<implicit::Surface>(GENERATE("torus", "genus2", "gyroid"));
  const auto manifold = make_implicit_manifold(options);
  const Problem problem =
      between(manifold, make_euclidean_cost(3), Eigen::Vector3d(0.9, 1, 0.3), Eigen::Vector3d(0.9, -1, 0.5));
  const FirstPath first = StraightInitializer().first_path(problem, {});
  const PostProcessed chain = as_delivered(problem, sample_equally(problem, first.path, 7));
  const PostProcessed made = OnSurfacePostProcessor({1e-4}).apply(problem, first, chain, {});
  const auto normal = [&](const Eigen::Vector3d& x) {
    Eigen::VectorXd value(1);
    Points gradient(3, 1);
    manifold->function().evaluate(x, value, gradient);
    return Eigen::Vector3d(gradient.normalized());
  };
  const Points& u = made.chain.u;
  Index segment = 0, inside = 0;
  for (Index i = 1; i < made.curve.x.cols(); ++i) {
    const Eigen::Vector3d a = u.col(segment), b = u.col(segment + 1), x = made.curve.x.col(i);
    CHECK(std::abs((x - a).dot(((normal(a) + normal(b)) / 2).cross(b - a).normalized())) <= 1e-11);
    if (x == b)
      ++segment;
    else
      ++inside;
  }
  CHECK(segment == 8);
  CHECK(inside > 16);
}

TEST_CASE("post_processor contract: on_surface, rings", "[contract]") {
  ImplicitManifoldOptions options;
  options.surface = implicit::Torus{};
  const Problem problem = closed(make_implicit_manifold(options), make_euclidean_cost(3));
  Points equator(3, 12);
  for (Index i = 0; i < 12; ++i) {
    const double t = static_cast<double>(i) * std::acos(-1) / 6;
    equator.col(i) = Eigen::Vector3d(std::cos(t), std::sin(t), 0);
  }
  const PostProcessed made =
      OnSurfacePostProcessor({1e-6}).apply(problem, {}, as_delivered(problem, {equator, {}, true}), {});
  CHECK(made.curve.x.col(0) == made.curve.x.rightCols(1));
  // Chords with sagittas s <= 1e-6 of the unit circle: too short by 4 s / 3 of their length at most.
  CHECK(std::abs(made.curve.cost - 2 * std::acos(-1)) <= 1.4e-6 * 2 * std::acos(-1));
  CHECK(made.curve_costs.size() == 12);
}

TEST_CASE("post_processor contract: straighten, rings", "[contract]") {
  // A torus has closed geodesics around its hole and around its tube; a ring on the ball contracts.
  const auto torus = std::make_shared<const MeshManifold>(TriangleMesh(grid(12, 9, Closing::kRound, true)));
  const StraightenPostProcessor straighten;
  for (const auto& cost : {make_euclidean_cost(3), stretched()}) {
    const Problem problem = closed(torus, cost), on_ball = closed(small_ball(), cost);
    for (const PlaneCutOptions& cut : {PlaneCutOptions{Eigen::Vector3d(-2, 0, 0.1), Eigen::Vector3d(0.1, 0.2, 1)},
                                       PlaneCutOptions{Eigen::Vector3d(3, 0.1, 0), Eigen::Vector3d(0.2, 1, 0.1)}}) {
      const FirstPath first = PlaneCutInitializer(cut).first_path(problem, {});
      const CoordinatePath chain = sample_equally(problem, first.path, kPoints);
      const PostProcessed traced = TracePostProcessor().apply(problem, first, as_delivered(problem, chain), {});
      const PostProcessed made = straighten.apply(problem, first, traced, {});
      REQUIRE_FALSE(made.collapsed);
      CHECK(made.chain.ring);
      REQUIRE(made.chain.u.cols() == kPoints);
      CHECK(problem.manifold->residual(made.chain) <= 4 * kBarycentricRounding);
      CHECK(made.curve.x.col(0) == made.curve.x.rightCols(1));
      CHECK(made.curve.cost <= PathEnergy(problem, 1).cost(first.path) * (1 + 1e-12));
      REQUIRE(made.curve.straightness);
      CHECK(*made.curve.straightness >= -1e-9);
      REQUIRE(made.curve_costs.size() == kPoints);
      CHECK(made.curve_costs.sum() == Approx(made.curve.cost).epsilon(1e-12));
      CHECK(spread(made.curve_costs) <= 1e-9);
    }
    const PlaneCutOptions parallel{Eigen::Vector3d(0, 0, 0.4), Eigen::Vector3d(0.1, 0.2, 1)};
    const FirstPath first = PlaneCutInitializer(parallel).first_path(on_ball, {});
    const CoordinatePath chain = sample_equally(on_ball, first.path, kPoints);
    CHECK(straighten.apply(on_ball, first, as_delivered(on_ball, chain), {}).collapsed);
  }
}

TEST_CASE("post_processor contract: a ring that slid onto another component gives way to the first one", "[contract]") {
  PolygonSoup two = grid(12, 9, Closing::kRound, true);
  const auto vertices = static_cast<std::int32_t>(two.positions.size());
  const PolygonSoup one = two;
  for (const Eigen::Vector3d& p : one.positions) two.positions.push_back(p + Eigen::Vector3d(20, 0, 0));
  for (const std::int32_t corner : one.corners) two.corners.push_back(corner + vertices);
  for (std::size_t f = 1; f < one.polygon_begin.size(); ++f)
    two.polygon_begin.push_back(one.polygon_begin[f] + one.polygon_begin.back());
  const auto mesh = std::make_shared<const MeshManifold>(TriangleMesh(two));
  const Problem problem = closed(mesh, make_euclidean_cost(3));
  const FirstPath first =
      PlaneCutInitializer(PlaneCutOptions{Eigen::Vector3d(-2, 0, 0.1), Eigen::Vector3d(0.1, 0.2, 1)})
          .first_path(problem, {});
  CoordinatePath chain = sample_equally(problem, first.path, kPoints);
  for (Index i = 0; i < kPoints / 2; ++i) chain.u(0, i) += 20;
  mesh->project(chain);
  const PostProcessed made = TracePostProcessor().apply(problem, first, as_delivered(problem, chain), {});
  CHECK(made.chain.ring);
  CHECK(made.chain.u.cols() == kPoints);
  CHECK(made.chain.u.row(0).maxCoeff() < 10);
  CHECK(made.curve.x.col(0) == made.curve.x.rightCols(1));
  REQUIRE_FALSE(made.notes.empty());
  CHECK_THAT(made.notes[0], Catch::Contains("slid onto another component"));
}

TEST_CASE("post_processor contract: switchbacks", "[contract]") {
  ParametricOptions options;
  options.surface = parametric::Formula{.x = "u", .y = "v", .z = "0.6 * v + 0.1 * sin(u)"};
  const auto hill = make_parametric_manifold(options);
  const SwitchbackPostProcessor switchbacks({.width = 0.1});
  const Problem uphill = between(hill, make_walking_cost({.length = MapLength::kilometres}, 3), Eigen::Vector2d(0, 0),
                                 Eigen::Vector2d(0.4, 1));
  const FirstPath first = StraightInitializer().first_path(uphill, {});
  const CoordinatePath chain = sample_equally(uphill, first.path, kPoints);
  const PostProcessed made = switchbacks.apply(uphill, first, as_delivered(uphill, chain), {});
  CHECK(made.chain.u == chain.u);
  CHECK(made.curve.x.cols() > 4 * kPoints);
  CHECK((made.curve.x.leftCols(1) - positions(*hill, chain).leftCols(1)).norm() < 1e-14);
  CHECK((made.curve.x.rightCols(1) - positions(*hill, chain).rightCols(1)).norm() < 1e-14);
  for (Index i = 0; i < made.curve.x.cols(); ++i) {
    const Eigen::Vector3d x = made.curve.x.col(i);
    CHECK(x[2] == Approx(0.6 * x[1] + 0.1 * std::sin(x[0])).margin(1e-12));
  }
  REQUIRE(made.curve_costs.size() == chain.segment_count());
  CHECK(made.curve_costs.sum() == Approx(made.curve.cost).epsilon(1e-12));
  CHECK(made.curve.cost >= as_delivered(uphill, chain).curve.cost * (1 - 1e-6));
  CHECK_THROWS_AS(SwitchbackPostProcessor({.width = 0}), OptionError);
  const Problem level = between(hill, make_euclidean_cost(3), Eigen::Vector2d(0, 0), Eigen::Vector2d(0.4, 1));
  CHECK_THROWS_AS(switchbacks.apply(level, first, as_delivered(level, chain), {}), InputError);
}

TEST_CASE("post_processor contract: what does not fit is refused", "[contract]") {
  const Problem plane = between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0));
  const FirstPath first = StraightInitializer().first_path(plane, {});
  CHECK_THROWS_AS(TracePostProcessor().apply(plane, first, as_delivered(plane, first.path), {}), InputError);
  CHECK_THROWS_AS(OnSurfacePostProcessor().apply(plane, first, as_delivered(plane, first.path), {}), InputError);
  CHECK_THROWS_AS(StraightenPostProcessor().apply(plane, first, as_delivered(plane, first.path), {}), InputError);
}

}  // namespace leastcost::test
