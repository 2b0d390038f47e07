// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/free_space.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include <leastcost/solvers/newton.hpp>
#include "problems/obstacles/broad_phase.hpp"
#include "tests/support/catch.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Vector = Eigen::VectorXd;
using ObstaclePtr = std::shared_ptr<const Obstacle>;

Problem among(FreeSpace::Obstacles obstacles, double clearance, const Vector& source, const Vector& target) {
  const int d = static_cast<int>(source.size());
  const auto space = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = d});
  Problem problem;
  problem.manifold = std::make_shared<const FreeSpace>(space, std::move(obstacles), clearance);
  problem.cost = make_euclidean_cost(d);
  problem.kernel = make_kernel(Expm1Square{});
  problem.source = {source};
  problem.target = {target};
  return problem;
}

Result solve(const Problem& problem, int points, const Initializer& initializer) {
  FindOptions options;
  options.points = points;
  return find_path(problem, initializer, Newton(), options);
}

/// Around a ball at the origin, on one side of it: two tangents and an arc.
double around_ball(const Vector& a, const Vector& b, double r) {
  const double p = a.norm(), q = b.norm();
  const double angle = std::acos(a.dot(b) / (p * q));
  const auto tangent = [r](double away) { return std::sqrt(std::max(0.0, away * away - r * r)); };
  const auto turned = [r](double away) { return std::acos(std::min(1.0, r / away)); };
  return tangent(p) + tangent(q) + r * (angle - turned(p) - turned(q));
}

}  // namespace

TEST_CASE("obstacles: the broad phase finds what a search through all of them finds") {
  std::mt19937 engine(20261125);
  std::uniform_real_distribution<double> place(-10, 10), size(0, 1);
  for (const int d : {2, 3, 5}) {
    const auto random_box = [&] {
      const Vector lower = Vector::NullaryExpr(d, [&] { return place(engine); });
      return BroadPhase::Box(lower, lower + Vector::NullaryExpr(d, [&] { return size(engine); }));
    };
    std::vector<BroadPhase::Box> boxes;
    for (int i = 0; i < 1000; ++i) boxes.push_back(random_box());
    const BroadPhase tree(boxes);
    std::vector<int> found, expected;
    for (int k = 0; k < 100; ++k) {
      const BroadPhase::Box box = random_box();
      expected.clear();
      for (int i = 0; i < 1000; ++i)
        if (boxes[static_cast<std::size_t>(i)].intersects(box)) expected.push_back(i);
      tree.meeting(box, found);
      CHECK(found == expected);
    }
  }
}

TEST_CASE("obstacles: around a disc, at second order and never through it") {
  const double truth = 2 * std::sqrt(3.0) + std::numbers::pi / 3;  // ORACLES D5
  double before = 0;
  for (const int n : {49, 99, 199}) {
    CAPTURE(n);
    const Problem problem = among({make_ball({Vector2d(0, 0), 1})}, 0, Vector2d(-2, 0), Vector2d(2, 0));
    const Result r = solve(problem, n, BowInitializer());
    REQUIRE(r.status == Status::certified);
    CHECK(std::abs(r.certificate.estimate.value - truth) <= r.certificate.estimate.error);
    const double excess = r.curve.cost - truth;
    CHECK(excess > 0);
    if (before > 0) CHECK(before / excess == Approx(4).epsilon(0.1));
    before = excess;
    REQUIRE(r.certificate.clearance);
    CHECK(r.certificate.clearance->lower >= -1e-12);
    CHECK(r.certificate.clearance->upper <= 1e-6);  // contact
    CHECK(r.certificate.clearance->obstacle == "the ball at (0, 0) (number 0)");
  }
  CHECK(before / truth < 1.1e-5);
}

TEST_CASE("obstacles: around a ball in space, and ends that touch it") {
  const double r = 0.7;
  for (const auto& [a, b] :
       {std::pair{Vector3d(-1.5, 0.1, 0.2), Vector3d(1.2, 0.5, -0.3)},
        std::pair{Vector3d(-0.7, 0, 0), Vector3d(0.7 / std::sqrt(2.0), 0.7 / std::sqrt(2.0), 0)}}) {
    const Problem problem = among({make_ball({Vector3d(0, 0, 0), r})}, 0, a, b);
    const Result result = solve(problem, 80, BowInitializer());
    CAPTURE(a.transpose(), b.transpose(), result.curve.cost);
    const double truth = around_ball(a, b, r);
    CHECK(result.curve.cost > truth);
    CHECK(result.curve.cost < truth * (1 + 1e-3));
    REQUIRE(result.certificate.clearance);
    CHECK(result.certificate.clearance->lower >= -1e-12);
    REQUIRE(result.status == Status::certified);
    CHECK(std::abs(result.certificate.estimate.value - truth) <= result.certificate.estimate.error);
  }
}

TEST_CASE("obstacles: a search leaves an end that touches an obstacle") {
  const double r = 0.7;
  const Vector2d a(-r, 0), b(r * std::sqrt(0.5), r * std::sqrt(0.5));
  const Result result = solve(among({make_ball({Vector2d(0, 0), r})}, 0, a, b), 60, RrtInitializer());
  REQUIRE(result.status == Status::certified);
  const double near = around_ball(a, b, r), far = 2 * std::numbers::pi * r - near;  // on one side or the other
  const double off =
      std::min(std::abs(result.certificate.estimate.value - near), std::abs(result.certificate.estimate.value - far));
  CHECK(off <= result.certificate.estimate.error);
}

TEST_CASE("obstacles: around a cap of a sphere, on either side") {
  const auto at = [](double longitude, double latitude) {
    return Vector3d(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                    std::sin(latitude));
  };
  const Vector3d a = at(-1, 0), b = at(1, 0.05), pole = at(0, 0.1);
  const double alpha = 0.4;  // angular radius of the cap
  Problem problem = among({make_ball({pole, 2 * std::sin(alpha / 2)})}, 0, a, b);
  problem.manifold =
      std::make_shared<const FreeSpace>(make_implicit_manifold({.surface = implicit::Sphere{}}),
                                        FreeSpace::Obstacles{make_ball({pole, 2 * std::sin(alpha / 2)})}, 0);
  // Two arcs of great circles, tangent to the cap, and one along its border (right spherical triangles).
  const auto from_pole = [&](const Vector3d& p) { return std::acos(p.dot(pole)); };
  const auto tangent = [&](const Vector3d& p) { return std::acos(std::cos(from_pole(p)) / std::cos(alpha)); };
  const auto turned = [&](const Vector3d& p) { return std::acos(std::tan(alpha) / std::tan(from_pole(p))); };
  const auto direction = [&](const Vector3d& p) { return (p - p.dot(pole) * pole).normalized(); };
  const double between = std::acos(direction(a).dot(direction(b)));
  for (const auto& [bow, angle] : {std::pair{0.0, between}, std::pair{180.0, 2 * std::numbers::pi - between}}) {
    const double truth = tangent(a) + tangent(b) + std::sin(alpha) * (angle - turned(a) - turned(b));
    const Result result = solve(problem, 64, BowInitializer({.height = 0.5, .angle = bow}));
    CAPTURE(bow, truth, result.certificate.estimate.value, result.certificate.estimate.error);
    REQUIRE(result.status == Status::certified);
    CHECK(std::abs(result.certificate.estimate.value - truth) <= result.certificate.estimate.error);
    CHECK(result.certificate.estimate.error < 1e-5);
    REQUIRE(result.certificate.clearance);
    CHECK(result.certificate.clearance->lower >= -1e-12);
  }
}

TEST_CASE("obstacles: over a box with a clearance, along its side and round two corners") {
  const double r = 0.3, d = std::sqrt(5.0);  // a tangent to an arc, the arc, half of the side; and back
  const double truth = 2 * (std::sqrt(d * d - r * r) + r * (std::atan2(1, 2) + std::asin(r / d)) + 1);
  Eigen::MatrixXd corners(4, 2);
  corners << -1, -5, -1, 0, 1, 0, 1, -5;
  for (const ObstaclePtr& box : {make_box_obstacle({Vector2d(-1, -5), Vector2d(1, 0)}), make_polygon({corners})}) {
    const Result result =
        solve(among({box}, r, Vector2d(-3, -1), Vector2d(3, -1)), 120, BowInitializer(BowOptions{.height = 0.4}));
    CAPTURE(box->name(), result.curve.cost, truth);
    REQUIRE(result.certificate.clearance);
    CHECK(result.certificate.clearance->lower >= -1e-12);
    CHECK(result.curve.cost > truth);
    CHECK(result.curve.cost < truth * (1 + 1e-3));
    REQUIRE(result.status == Status::certified);
    CHECK(std::abs(result.certificate.estimate.value - truth) <= result.certificate.estimate.error);
  }
}

TEST_CASE("obstacles: random scenes of discs, nothing certified goes through one", "[slow_sanitized]") {
  std::mt19937 engine(20261126);
  std::uniform_real_distribution<double> place(0, 10), radius(0.2, 0.9);
  int certified = 0;
  constexpr int kScenes = 30;
  for (int scene = 0; scene < kScenes; ++scene) {
    CAPTURE(scene);
    const Vector2d source(0, 0), target(10, 10);
    FreeSpace::Obstacles discs;
    std::vector<std::pair<Vector2d, double>> known;
    while (known.size() < 25) {
      const Vector2d center(place(engine), place(engine));
      const double r = radius(engine);
      if ((center - source).norm() < r + 0.1 || (center - target).norm() < r + 0.1) continue;
      known.emplace_back(center, r);
      discs.push_back(make_ball({center, r}));
    }
    Result result;
    try {
      result = solve(among(discs, 0, source, target), 100, RrtInitializer());
    } catch (const InitializationError&) {
      continue;  // no way through, or none found
    }
    if (result.status != Status::certified) continue;
    ++certified;
    const Points& x = result.curve.x;
    for (const auto& [center, r] : known)
      for (Index i = 0; i + 1 < x.cols(); ++i) {
        const Vector2d a = x.col(i), way = x.col(i + 1) - a;
        const double t = std::clamp((center - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
        CHECK((a + t * way - center).norm() >= r - 1e-9);
      }
  }
  CHECK(certified >= kScenes * 8 / 10);
}

TEST_CASE("obstacles: a wall does not push a path out of its box") {
  Problem problem = among({}, 0, Vector2d(-2, 0.5), Vector2d(2, 0.5));
  EuclideanManifoldOptions options;
  options.box.lower = Vector2d(-3, -3);
  options.box.upper = Vector2d(3, 1.05);
  const auto box = std::make_shared<const EuclideanManifold>(options);
  problem.manifold = std::make_shared<const FreeSpace>(box, FreeSpace::Obstacles{make_ball({Vector2d(0, 0), 1})}, 0);
  CoordinatePath path{Points(2, 3), {}, false};
  path.u << -0.2, 0.01, 0.3, 2, 0.9, 1.2;
  const Projection projection = problem.manifold->project(path);
  CHECK(projection.failed.empty());
  CHECK(problem.manifold->residual(path) <= 1e-12);
  const Result result = solve(problem, 100, RrtInitializer());
  CHECK(result.status == Status::certified);
  CHECK(result.curve.cost > around_ball(problem.source.u, problem.target.u, 1));
  CHECK(result.curve.cost < 1.001 * around_ball(problem.source.u, problem.target.u, 1));
}

TEST_CASE("obstacles: a step through a polygon ends where it enters") {
  Eigen::MatrixXd corners(4, 2);  // the first edge is the one at the far side
  corners << 1, -1, 1, 1, 0, 1, 0, -1;
  double t = -1;
  CHECK(make_polygon({corners})->distance_of_segment(Vector2d(-1, 0), Vector2d(3, 0.1), t) == 0);
  CHECK(t == Approx(0.25));
}

TEST_CASE("obstacles: a loop around a disc is its circle, and stays around it with three points") {
  Points square(2, 4);
  square << 2, 0, -2, 0, 0, 2, 0, -2;
  Problem problem = among({make_ball({Vector2d(0, 0), 1})}, 0, Vector2d(0, 0), Vector2d(0, 0));
  problem.source = problem.target = {};
  problem.ring = true;
  const Result result = solve(problem, 100, WaypointsInitializer(square));
  REQUIRE(result.certificate.clearance);
  CHECK(result.certificate.clearance->lower >= -1e-12);
  CHECK(result.curve.cost > 2 * std::numbers::pi);
  CHECK(result.curve.cost < 2 * std::numbers::pi * 1.001);
  const Result coarse = solve(problem, 3, WaypointsInitializer(square));
  CHECK(coarse.curve.cost > 2 * std::numbers::pi);
  REQUIRE(coarse.status == Status::certified);
  CHECK(std::abs(coarse.certificate.estimate.value - 2 * std::numbers::pi) <= coarse.certificate.estimate.error);
}

TEST_CASE("obstacles: what is between two points of a path is not missed") {
  const auto space = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{});
  const FreeSpace free(space, {make_ball({Vector2d(0.5, 0.0005), 1e-3})}, 0);
  const Points line = (Points(2, 2) << 0, 1, 0, 0).finished();
  const auto clearance = measure_clearance(free, line, false, {});
  REQUIRE(clearance);
  CHECK(clearance->upper == Approx(-5e-4));
  CHECK(clearance->place.isApprox(Vector2d(0.5, 0), 1e-12));
  CHECK(clearance->segment == 0);
}

namespace {

/// A user's own checker, on a domain that does not keep points away from anything.
class Watched final : public ConstraintManifold, public ChecksMoves {
 public:
  /// `unknown`: added to what it says; a NaN makes it one that does not know.
  explicit Watched(double unknown = 0) : unknown_(unknown) {}
  Dimensions dimensions() const override { return plane_.dimensions(); }
  Shape shape() const override { return plane_.shape(); }
  Projection project(CoordinatePath& path) const override { return plane_.project(path); }
  void tangent_bases(const CoordinatePath& path, Points& bases) const override { plane_.tangent_bases(path, bases); }
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override {
    plane_.retract(from, step, to);
  }
  double residual(const CoordinatePath& path) const override { return plane_.residual(path); }
  MoveClearance clearance(const Vector& a, const Vector& b) const override {
    double t = 0;
    const double distance = post_->distance_of_segment(a, b, t) - post_->radius() + unknown_;
    return {distance, distance, 0, a + t * (b - a)};
  }
  std::string obstacle_name(int) const override { return "the post"; }

 private:
  double unknown_;
  EuclideanManifold plane_{EuclideanManifoldOptions{}};
  ObstaclePtr post_ = make_ball({Vector2d(0.5, 0), 0.01});
};

/// Passes what it is given to the other side of the x axis.
class Mirrors final : public Solver {
 public:
  std::string_view name() const override { return "mirrors"; }

 private:
  SolveReport do_solve(PathEnergy&, CoordinatePath& path, const Monitor&) const override {
    path.u.row(1) *= -1;
    SolveReport report;
    report.termination = Termination::converged;
    return report;
  }
};

/// Never fits a path, whatever it does.
class Restless final : public ConstraintManifold, public ChecksMoves, public FitsSegments {
 public:
  Dimensions dimensions() const override { return plane_.dimensions(); }
  Shape shape() const override { return plane_.shape(); }
  Projection project(CoordinatePath& path) const override { return plane_.project(path); }
  void tangent_bases(const CoordinatePath& path, Points& bases) const override { plane_.tangent_bases(path, bases); }
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override {
    plane_.retract(from, step, to);
  }
  double residual(const CoordinatePath& path) const override { return plane_.residual(path); }
  MoveClearance clearance(const Vector& a, const Vector& b) const override {
    const double gap = a == b ? 0 : -1;  // the ends are clear
    return {gap, gap, 0, a};
  }
  std::string obstacle_name(int) const override { return "everything"; }
  std::shared_ptr<const ConstraintManifold> unfitted(const CoordinatePath&, double) const override {
    return std::make_shared<Restless>();
  }
  SegmentFit fitted(const CoordinatePath&) const override { return {std::make_shared<Restless>(), {}}; }
  std::vector<MarginCost> margin_costs(const CoordinatePath&, const Points&) const override { return {}; }

 private:
  EuclideanManifold plane_{EuclideanManifoldOptions{}};
};

bool fails_by(const Result& result, std::string_view name) {
  const auto& failures = result.certificate.failures;
  return std::any_of(failures.begin(), failures.end(), [&](const auto& failure) { return failure.name() == name; });
}

}  // namespace

TEST_CASE("obstacles: a path through one is not certified, and says where") {
  Problem problem = among({}, 0, Vector2d(0, 0), Vector2d(1, 0));
  problem.manifold = std::make_shared<const Watched>();
  const Result result = solve(problem, 20, StraightInitializer());
  CHECK(result.status == Status::uncertified);
  REQUIRE(result.certificate.failures.size() == 1);
  CHECK(result.certificate.failures.front().name() == "touches");
  CHECK_THAT(result.certificate.failures.front().message, Catch::Contains("the post"));
}

TEST_CASE("obstacles: a checker that does not know has not said that the way is clear") {
  const Watched blind(std::numeric_limits<double>::quiet_NaN());
  const Points line = (Points(2, 3) << 0, 1, 2, 5, 5, 5).finished();
  const auto clearance = measure_clearance(blind, line, false, {});
  REQUIRE(clearance);
  CHECK(clearance->lower == -std::numeric_limits<double>::infinity());
  CHECK(clearance->obstacle == "the post");
}

TEST_CASE("obstacles: ends within a clearance, sharp corners without one, and other faults have names") {
  const ObstaclePtr ball = make_ball({Vector2d(0, 0), 1});
  CHECK_THROWS_WITH(solve(among({ball}, 0.5, Vector2d(-1.2, 0), Vector2d(3, 0)), 20, StraightInitializer()),
                    Catch::Contains("end_in_clearance: the source is 0.3 too close to the ball at (0, 0)"));
  CHECK_THROWS_WITH(solve(among({ball}, 0.5, Vector2d(-0.7, 0), Vector2d(3, 0)), 20, StraightInitializer()),
                    Catch::Contains("end_in_clearance: the source lies 0.3 deep inside the ball at (0, 0)"));
  CHECK_THROWS_WITH(among({make_box_obstacle({Vector2d(0, 0), Vector2d(1, 1)})}, 0, Vector2d(-1, 0), Vector2d(3, 0)),
                    Catch::Contains("sharp corners"));
  CHECK_THROWS_WITH(among({make_ball({Vector3d(0, 0, 0), 1})}, 0, Vector2d(-1, 0), Vector2d(3, 0)),
                    Catch::Contains("has 3 dimensions, but the domain has 2"));
  CHECK_THROWS_WITH(make_ball({Vector2d(0, 0), 0}), Catch::Contains("greater than 0"));
  Eigen::MatrixXd bow(4, 2);
  bow << 0, 0, 1, 1, 1, 0, 0, 1;
  CHECK_THROWS_WITH(make_polygon({bow}), Catch::Contains("cross"));
}

TEST_CASE("obstacles: no passage, a class that was lost and a fit without an end have names") {
  FreeSpace::Obstacles ring;
  for (int k = 0; k < 12; ++k) {
    const double angle = 2 * std::numbers::pi * k / 12;
    ring.push_back(make_ball({Vector2d(std::cos(angle), std::sin(angle)), 0.4}));
  }
  GridOptions coarse;
  coarse.refinements = 1;
  coarse.trees = false;
  CHECK_THROWS_WITH(solve(among(ring, 0, Vector2d(0, 0), Vector2d(3, 0)), 20, GridInitializer(coarse)),
                    Catch::StartsWith("no_passage: grid: no passage at this resolution"));
  RrtOptions few;
  few.max_nodes = 500;
  CHECK_THROWS_WITH(solve(among(ring, 0, Vector2d(0, 0), Vector2d(3, 0)), 20, RrtInitializer(few)),
                    Catch::StartsWith("no_passage: rrt: no path after"));

  const Problem disc = among({make_ball({Vector2d(0, 0), 1})}, 0, Vector2d(-2, 0), Vector2d(2, 0));
  FindOptions options;
  options.points = 30;
  const WaypointsInitializer above(Vector2d(0, 1.5));
  CHECK(fails_by(find_path(disc, above, Mirrors(), options), "class_lost"));
  const Result kept = find_path(disc, above, Newton(), options);
  CHECK(kept.status == Status::certified);
  CHECK_FALSE(kept.solve.cycling);

  Problem restless = among({}, 0, Vector2d(0, 0), Vector2d(1, 0));
  restless.manifold = std::make_shared<const Restless>();
  const Result result = find_path(restless, StraightInitializer(), Newton(), options);
  CHECK(result.solve.cycling);
  CHECK(fails_by(result, "active_set_cycling"));
}

}  // namespace leastcost
