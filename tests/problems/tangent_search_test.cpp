// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Shortest plans in the plane: closed forms, an enumeration of visible corners, windows over the free
// cells of maps, the box of the domain, and what is said
// where the search does not come to its end. Scenes of discs are judged in tests/adversarial/planning.
#include "problems/taut/tangent_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/map.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/obstacles/map_obstacles.hpp>
#include <leastcost/problems/post_processors/shortest_plan.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;
using Obstacles = std::vector<std::shared_ptr<const Obstacle>>;

constexpr double kUnbounded = 1e6;
constexpr double kTiny = 1e-10;  ///< a clearance that tells from none by less than what is checked

std::shared_ptr<const Obstacle> box2(const Vector2d& lower, const Vector2d& upper) {
  return make_box_obstacle({lower, upper});
}

/// Whether a straight move has a part inside a box (Liang and Barsky 1984); along a side is outside.
bool goes_into(const Eigen::AlignedBox2d& box, const Vector2d& a, const Vector2d& b) {
  constexpr double kInside = 1e-12;
  double from = 0, to = 1;
  for (int k = 0; k < 2; ++k) {
    const double way = b[k] - a[k], low = box.min()[k] - a[k] + kInside, high = box.max()[k] - a[k] - kInside;
    if (way == 0 && (low >= 0 || high <= 0)) return false;
    if (way == 0) continue;
    from = std::max(from, std::min(low / way, high / way));
    to = std::min(to, std::max(low / way, high / way));
  }
  return from < to;
}

/// Over the four corners of all boxes: the straight moves that go into none, then Bellman and Ford.
double over_corners(const std::vector<Eigen::AlignedBox2d>& boxes, const Vector2d& a, const Vector2d& b) {
  const auto clear = [&](const Vector2d& p, const Vector2d& q) {
    return std::none_of(boxes.begin(), boxes.end(), [&](const auto& box) { return goes_into(box, p, q); });
  };
  std::vector<Vector2d> places = {a, b};
  for (const auto& box : boxes)
    for (const auto corner : {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight,
                              Eigen::AlignedBox2d::TopLeft, Eigen::AlignedBox2d::TopRight})
      places.push_back(box.corner(corner));
  std::vector<double> least(places.size(), std::numeric_limits<double>::infinity());
  least[0] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t j = 0; j < places.size(); ++j) {
        const double length = least[i] + (places[j] - places[i]).norm();
        if (!(length < least[j] * (1 - 1e-14)) || !clear(places[i], places[j])) continue;
        least[j] = length;
        changed = true;
      }
  }
  return least[1];
}

/// No two cells meet in a corner only, where a path may or may not go through.
OccupancyGrid random_map(test::Random& random, int side) {
  OccupancyGrid grid;
  grid.rows = grid.columns = side;
  grid.blocked.resize(static_cast<std::size_t>(side * side));
  for (std::size_t i = 1; i + 1 < grid.blocked.size(); ++i) grid.blocked[i] = random.uniform(0, 1) < 0.3;
  for (bool changed = true; changed;) {
    changed = false;
    for (int r = 0; r + 1 < side; ++r)
      for (int c = 0; c + 1 < side; ++c) {
        const bool corner = grid.free(r, c);
        if (corner != grid.free(r + 1, c + 1) || corner == grid.free(r, c + 1) || corner == grid.free(r + 1, c))
          continue;
        for (const int k : {0, 1}) grid.blocked[grid.index(r + k, c)] = grid.blocked[grid.index(r + k, c + 1)] = false;
        changed = true;
      }
  }
  return grid;
}

SurfacePoint place_on(const TriangleMesh& mesh, const Vector2d& place) {
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto& face = mesh.faces()[static_cast<std::size_t>(f)];
    Eigen::Matrix3d corners = Eigen::Matrix3d::Ones();
    for (int k = 0; k < 3; ++k) corners.col(k).head(2) = mesh.position(face[static_cast<std::size_t>(k)]).head(2);
    const Eigen::Vector3d share = corners.partialPivLu().solve(Eigen::Vector3d(place.x(), place.y(), 1));
    if (share.minCoeff() >= -1e-12) return {f, share};
  }
  FAIL("no face there");
  return {};
}

/// From a to b with a first path over `way`, pulled tight and proved.
Result plan(Obstacles obstacles, double clearance, const std::vector<Vector2d>& way, GlobalProof proof = GlobalAuto{},
            const BoxOptions& box = {}) {
  const auto plane = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2, .box = box});
  Problem problem;
  problem.manifold = std::make_shared<const FreeSpace>(plane, std::move(obstacles), clearance);
  problem.cost = make_euclidean_cost(2);
  problem.kernel = make_kernel(Expm1Square{});
  problem.source = {way.front()};
  problem.target = {way.back()};
  Points between(2, static_cast<Index>(way.size()) - 2);
  for (Index i = 0; i < between.cols(); ++i) between.col(i) = way[static_cast<std::size_t>(i) + 1];
  FindOptions options;
  options.points = 30;
  options.post_processors = {std::make_shared<const TautPostProcessor>(),
                             std::make_shared<const ShortestPlanPostProcessor>(proof)};
  return find_path(problem, WaypointsInitializer(between), NoSolver(), options);
}

}  // namespace

TEST_CASE("tangent search: the near side of a disc, whatever side the first path took") {
  const double r = 1.2, high = 0.3;
  const Vector2d a(-3, high), b(3, high);
  const double d = std::hypot(3.0, high), between = 2 * std::atan2(3.0, high);
  const double near = 2 * std::sqrt(d * d - r * r) + r * (between - 2 * std::acos(r / d));
  for (const double side : {1.0, -1.0}) {
    const Result result = plan({make_ball({Vector2d(0, 0), 1})}, 0.2, {a, {0, 3 * side}, b});
    CAPTURE(side);
    CHECK(result.status == Status::certified);
    CHECK(result.certificate.scope == Scope::global);
    REQUIRE(result.certificate.global);
    CHECK(result.certificate.global->outcome == (side > 0 ? ProofOutcome::proved : ProofOutcome::improved));
    CHECK(std::abs(result.certificate.estimate.value - near) <= result.certificate.estimate.error);
    CHECK(result.certificate.global->lower_bound == Approx(near).epsilon(2e-9));
    CHECK(result.certificate.global->lower_bound <= near * (1 + 1e-12));
  }
}

TEST_CASE("tangent search: among boxes as short as over all corners that see each other") {
  test::Random random(3);
  int bent = 0;
  for (int scene = 0; scene < 60; ++scene) {
    const Vector2d a(-0.1, 5), b(10.1, 5);
    std::vector<Eigen::AlignedBox2d> boxes;
    Obstacles obstacles;
    for (int k = 0; k < 18; ++k) {
      const Vector2d lower(random.uniform(0, 9), random.uniform(0, 9));
      const Vector2d upper = lower + Vector2d(random.uniform(0.1, 1), random.uniform(0.5, 4));
      boxes.emplace_back(lower, upper);
      obstacles.push_back(box2(lower, upper));
    }
    const ObstacleWalls walls(2, obstacles, kTiny);
    const double expected = over_corners(boxes, a, b);
    const TangentSearchResult found = shorter_tangent_path(walls, a, b, kUnbounded, {});
    CAPTURE(scene, expected, found.lower_bound);
    REQUIRE(found.shorter);
    CHECK(found.lower_bound == Approx(expected).epsilon(1e-8));
    bent += found.bends.empty() ? 0 : 1;
    // Below its own length there is none.
    const TangentSearchResult none = shorter_tangent_path(walls, a, b, found.lower_bound, {});
    CHECK(none.finished);
    CHECK_FALSE(none.shorter);
    CHECK(none.lower_bound == Approx(expected).epsilon(2e-9));
  }
  CHECK(bent > 50);
}

/// Of two ways to one circle the later was left out for the earlier one, which then could not go on through the place
/// where the discs overlap: 1.6 % too long was proved to be the shortest. The length is that of an independent graph.
TEST_CASE("tangent search: two discs that hardly overlap, from either side") {
  const Vector2d a(-4, 0), b(4, 0);
  for (const double side : {1.0, -1.0}) {
    const Result result = plan({make_ball({Vector2d(0, 0.13822096518512472), 1.5}),
                                make_ball({Vector2d(-0.11566989583102295, -1.4233365214446456), 0.065952361803632217})},
                               0, {a, {0, 3 * side}, b});
    CAPTURE(side, result.certificate.scope);
    CHECK(result.certificate.scope == Scope::global);
    CHECK(std::abs(result.certificate.estimate.value - 8.53791348119) <= result.certificate.estimate.error);
  }
}

TEST_CASE("tangent search: far from the origin the gap knows what coordinates leave open") {
  const double r = 1, far = 134217728;  // 2^27: the shift is exact
  const Vector2d a(-3, 0.25), b(3, 0.25), shift(far, -far);
  const double d = a.norm(), between = 2 * std::atan2(3.0, 0.25);
  const double near = 2 * std::sqrt(d * d - r * r) + r * (between - 2 * std::acos(r / d));
  const Vector2d source = a + shift, target = b + shift;
  const TangentSearchResult found =
      shorter_tangent_path(ObstacleWalls(2, {make_ball({shift, r})}, 0), source, target, kUnbounded, {});
  CHECK(found.shorter);
  CHECK(found.rounding < 1e-5);
  CHECK(found.lower_bound <= near);
  CHECK(found.lower_bound >= near - 2 * found.rounding);
  CHECK_THROWS_AS(shorter_tangent_path(ObstacleWalls(2, {make_ball({shift, r})}, 0), source, source, kUnbounded, {}),
                  InputError);
}

TEST_CASE("tangent search: told to stop it says how far it came") {
  const ObstacleWalls walls(2, {make_ball({Vector2d(0, 0), 1})}, 0);
  TangentSearchOptions options;
  int asked = 0;
  options.stop = [&asked] { return ++asked > 0; };
  const TangentSearchResult found = shorter_tangent_path(walls, Vector2d(-3, 0), Vector2d(3, 0), kUnbounded, options);
  CHECK(asked == 1);
  CHECK_FALSE(found.finished);
  CHECK_FALSE(found.shorter);
  CHECK(found.lower_bound == Approx(6));
}

TEST_CASE("tangent search: through maps as long as windows over their free cells, or no way for both") {
  constexpr int kSide = 16;
  constexpr double kClearance = 1e-7;
  test::Random random(2);
  int ways = 0, closed = 0;
  for (int scene = 0; scene < 40; ++scene) {
    const OccupancyGrid grid = random_map(random, kSide);
    const MapManifold map(grid);
    const Vector2d a(0.3, 0.4), b(kSide - 0.4, kSide - 0.3);
    const ExactSearch search(map.mesh());
    ExactSearch::Workspace workspace(search);
    const ExactResult windows = search.shortest(place_on(map.mesh(), a), place_on(map.mesh(), b), workspace);
    if (!windows.is_proved()) continue;
    TangentSearchOptions options;
    options.box = Eigen::AlignedBox2d(Vector2d(0, 0), Vector2d(kSide, kSide));
    const ObstacleWalls walls(2, map_obstacles(grid), kClearance);
    const TangentSearchResult found = shorter_tangent_path(walls, a, b, kUnbounded, options);
    CAPTURE(scene, windows.length, found.lower_bound);
    CHECK(found.finished);
    CHECK(found.shorter == std::isfinite(windows.length));
    ++(found.shorter ? ways : closed);
    if (found.shorter) CHECK(std::abs(found.lower_bound - windows.length) < 100 * kClearance);
  }
  CHECK(ways > 25);
  CHECK(closed > 0);
}

TEST_CASE("tangent search: a way that leaves the box of the domain is none") {
  const Vector2d a(-3, 0), b(3, 0);
  const Obstacles wall = {box2({-0.1, -1.1}, {0.1, 3})};
  BoxOptions box;
  box.lower = Vector2d(-4, -1);
  box.upper = Vector2d(4, 5);
  const Result inside = plan(wall, kTiny, {a, {0, 4}, b}, GlobalAuto{}, box);
  CHECK(inside.certificate.scope == Scope::global);
  CHECK(inside.curve.cost == Approx(2 * std::hypot(2.9, 3.0) + 0.2));
  const Result free = plan(wall, kTiny, {a, {0, 4}, b});
  CHECK(free.certificate.scope == Scope::global);
  CHECK(free.curve.cost == Approx(2 * std::hypot(2.9, 1.1) + 0.2));
}

TEST_CASE("tangent search: what it says where its budget ends, and where there is no way") {
  test::Random random(11);
  Obstacles discs;
  for (int k = 0; k < 60; ++k)
    discs.push_back(make_ball({Vector2d(random.uniform(0.5, 9.5), random.uniform(-4, 4)), 0.35}));
  const Vector2d a(0, 0), b(10, 0);
  const ObstacleWalls walls(2, discs, 0);
  const double least = shorter_tangent_path(walls, a, b, kUnbounded, {}).lower_bound;
  double before = 0;
  for (const std::int64_t most : {0, 500, 2000, 8000}) {
    TangentSearchOptions options;
    options.max_tangents = most;
    const TangentSearchResult found = shorter_tangent_path(walls, a, b, kUnbounded, options);
    CAPTURE(most, found.lower_bound, least);
    CHECK(found.lower_bound <= least * (1 + 1e-12));
    CHECK(found.lower_bound >= before);
    before = found.lower_bound;
  }
  CHECK(before > 10 * (1 - 1e-9));
  const Result bounded = plan(discs, 0, {a, {0, 5}, {10, 5}, b}, GlobalBudget{.max_windows = 1});
  CHECK(bounded.certificate.scope == Scope::least_of_class);
  REQUIRE(bounded.certificate.global);
  CHECK(bounded.certificate.global->outcome == ProofOutcome::bounded);
  CHECK(bounded.certificate.global->lower_bound <= least);
  // What a proof may leave open is asked for, and said.
  const Result loose = plan({make_ball({Vector2d(5, 0.1), 1})}, 0, {a, {5, -3}, b}, GlobalBudget{.tolerance = 0.05});
  CHECK(loose.status == Status::certified);
  CHECK(loose.certificate.scope == Scope::global);
  CHECK(loose.certificate.global->outcome == ProofOutcome::proved);
  CHECK(loose.certificate.estimate.error == Approx(0.05 * loose.curve.cost).epsilon(1e-3));
  // Closed in by four walls that overlap.
  const ObstacleWalls closed(
      2, {box2({-2, 1}, {2, 2}), box2({-2, -2}, {2, -1}), box2({1, -2}, {2, 2}), box2({-2, -2}, {-1, 2})}, kTiny);
  const TangentSearchResult none = shorter_tangent_path(closed, a, b, kUnbounded, {});
  CHECK(none.finished);
  CHECK_FALSE(none.shorter);
}

}  // namespace leastcost
