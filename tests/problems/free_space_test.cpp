// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Steps among walls that points do not lie on yet, and margins that are fitted anew.
#include <leastcost/problems/obstacles/free_space.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <leastcost/framework/domain/fits_segments.hpp>
#include <leastcost/framework/domain/reuses_margins.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/wall_margins.hpp>
#include "framework/energy/solve_fitted.hpp"
#include "framework/energy/spacing.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;

std::shared_ptr<const ConstraintManifold> plane(const std::vector<std::shared_ptr<const Obstacle>>& obstacles,
                                                const BoxOptions& box = {}) {
  return std::make_shared<const FreeSpace>(
      std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2, .box = box}), obstacles, 0);
}

std::shared_ptr<const Obstacle> disc(double x, double y, double r) { return make_ball({Vector2d(x, y), r}); }

Problem across(std::shared_ptr<const ConstraintManifold> domain) {
  return {std::move(domain), make_euclidean_cost(2), make_kernel<Expm1Square>(), {Vector2d(-2, 0)}, {Vector2d(2, 0)}};
}

/// Along a circle about the origin from (-r, 0) to (r, 0), and straight from and to the ends of across().
CoordinatePath along_circle(double r, Index points) {
  CoordinatePath path{Points(2, points), {}, false};
  for (Index i = 0; i < points; ++i) {
    const double angle = std::acos(-1.0) * (1 - static_cast<double>(i) / static_cast<double>(points - 1));
    path.u.col(i) << r * std::cos(angle), r * std::sin(angle);
  }
  path.u.col(0) << -2, 0;
  path.u.col(points - 1) << 2, 0;
  return path;
}

int at_rest(const ConstraintManifold& domain, const CoordinatePath& path) {
  Points normals(2, 2);
  int count = 0;
  for (Index i = 1; i + 1 < path.u.cols(); ++i)
    count += find_ability<HasBounds>(domain)->active_bounds(path, i, normals) > 0 ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("free space: bounds are seen as far as a step goes, with their slopes, and those of the box") {
  BoxOptions box;
  box.lower = Vector2d(-3, -3);
  box.upper = Vector2d(3, 1.05);
  const auto domain = plane({disc(0, 0, 1), disc(2.5, 0, 0.25)}, box);
  const auto* sees = find_ability<SeesBounds>(*domain);
  REQUIRE(sees != nullptr);
  const CoordinatePath path{Vector2d(-0.6, 0.9), {}, true};
  std::vector<NearBound> found;
  sees->bounds_within(path, 0, 0.1, found);
  REQUIRE(found.size() == 1);
  CHECK(found[0].number == 0);
  CHECK(found[0].gap == Approx(std::hypot(0.6, 0.9) - 1));
  CHECK(found[0].slope.isApprox(Vector2d(-0.6, 0.9).normalized()));
  sees->bounds_within(path, 0, 0.2, found);
  REQUIRE(found.size() == 2);
  CHECK(found[0].number == NearBound::kNone);
  CHECK(found[0].gap == Approx(0.15));
  CHECK(found[0].slope == Vector2d(0, -1));
}

TEST_CASE("free space: a step comes to rest on the walls it is to end on, unless it meets another before") {
  const auto domain = plane({disc(0, 0, 1), disc(0, 3, 1)});
  const auto* sees = find_ability<SeesBounds>(*domain);
  REQUIRE(sees != nullptr);
  CoordinatePath from{Points(2, 3), {}, false}, to;
  from.u << -2, 0.3, 2, 1, 1.5, 1;
  const auto gap_of = [&](double y) { return (to.u.col(1) - Vector2d(0, y)).norm() - 1; };
  // The tangent at the nearest point of the first disc: a step along it ends beside the wall, beyond second order.
  const Vector2d out = from.u.col(1).normalized();
  const Vector2d along = -(from.u.col(1).norm() - 1) * out + 0.1 * Vector2d(out.y(), -out.x());
  sees->retract_onto(from, along, {{}}, to);
  CHECK(gap_of(0) > 1e-4);
  sees->retract_onto(from, along, {{0}}, to);
  CHECK(std::abs(gap_of(0)) <= 1e-11);
  CHECK((to.u.col(1) - from.u.col(1) - along).norm() <= 0.01);
  // Into the second disc, whatever it is told about the first.
  sees->retract_onto(from, Vector2d(0, 1.5), {{0}}, to);
  CHECK(std::abs(gap_of(3)) <= 1e-11);
  CHECK(gap_of(0) > 0.5);
}

TEST_CASE("free space: points at rest come with their walls when margins are fitted anew") {
  Problem problem = across(plane({disc(0, 0, 1)}));
  CoordinatePath path = along_circle(1.2, 25);
  problem.manifold = find_ability<FitsSegments>(*problem.manifold)->unfitted(path);
  problem.manifold->project(path);
  int fits = 0;
  for (;; ++fits) {
    REQUIRE(fits < 10);
    PathEnergy energy(problem, 4.0 / 24);
    CHECK(is_solved(Newton().solve(energy, path, {}).termination));
    const int resting = at_rest(*problem.manifold, path);
    CHECK(resting > 5);
    const auto fitted = find_ability<FitsSegments>(*problem.manifold)->fitted(path).domain;
    if (fitted == nullptr) break;
    problem.manifold = fitted;
    CoordinatePath carried = path;
    problem.manifold->project(carried);
    path.u.middleCols(1, 23) = carried.u.middleCols(1, 23);
    CHECK(at_rest(*problem.manifold, path) == resting);
  }
  CHECK(fits >= 2);
}

TEST_CASE("free space: points a hair before walls do not hold up the others") {
  // Over three discs, a hair above them: no point lies on one.
  struct Disc {
    double x, y, r;
  };
  const std::vector<Disc> discs = {{-1, -0.4, 0.55}, {0, -0.45, 0.65}, {1, -0.4, 0.55}};
  std::vector<std::shared_ptr<const Obstacle>> obstacles;
  for (const Disc& d : discs) obstacles.push_back(disc(d.x, d.y, d.r));
  const auto domain = plane(obstacles);
  const Problem problem = across(domain);
  CoordinatePath path{Points(2, 61), {}, false};
  for (Index i = 0; i < 61; ++i) {
    const double x = -2 + 4 * static_cast<double>(i) / 60;
    double y = 0;
    for (const Disc& d : discs)
      if (std::abs(x - d.x) < d.r) y = std::max(y, d.y + std::sqrt(d.r * d.r - (x - d.x) * (x - d.x)) + 1e-9);
    path.u.col(i) << x, y;
  }
  PathEnergy energy(problem, 4.0 / 60);
  const SolveReport report = Newton().solve(energy, path, {});
  CHECK(report.termination == Termination::converged);
  CAPTURE(report.iterations, report.counters.energies);
  CHECK(report.counters.energies <= report.iterations + 3);
  CHECK(report.iterations <= 12);
  CHECK(at_rest(*domain, path) >= 1);
}

TEST_CASE("free space: points come to rest on the sides of its box") {
  // A slide above a floor that the free curve would dip below, with a disc that is far from it.
  for (const double floor : {-0.82, -0.9, -1.0}) {
    CAPTURE(floor);
    BoxOptions box;
    box.lower = Vector2d(0, floor);
    box.upper = Vector2d(3, 0);
    Problem problem = across(plane({disc(2.5, -0.02, 0.02)}, box));
    problem.cost = make_travel_time_cost({}, 2, Vector2d(0, 0));
    CoordinatePath path{Points(2, 42), {}, false};
    path.u.row(0).setLinSpaced(0, 3);
    path.u.row(1).setLinSpaced(0, -0.6);
    PathEnergy energy(problem, 3.0 / 41);
    const SolveReport report = Newton().solve(energy, path, {});
    CHECK(report.termination == Termination::converged);
    CHECK((path.u.row(1).array() == floor).count() > 0);
  }
}

TEST_CASE("free space: points that are pushed out of walls are spaced again") {
  // A straight path through the middle of a disc: the points on it are pushed to one side or the other of its rim.
  Problem problem = across(plane({disc(0, -0.05, 1)}));
  CoordinatePath path{Points::Zero(2, 42), {}, false};
  path.u.row(0).setLinSpaced(-2, 2);
  const FittedSolve solved = solve_fitted(problem, Newton(), 4.0 / 41, path, {});
  const SolveReport& report = solved.report;
  CHECK(report.termination == Termination::converged);
  CAPTURE(report.iterations);
  CHECK(report.iterations <= 20);
  const Eigen::VectorXd costs = PathEnergy(solved.problem, 1).costs(path);
  CHECK(costs.maxCoeff() <= 1.01 * costs.minCoeff());
}

TEST_CASE("free space: margins of walls that hold no point change nothing") {
  const WallMargins margins(0.1, 0, {{0, 0.02}, {1, 0.02}});
  const WallMargins::Fit closely{1e-3, 1e-14, 1e-10};
  const auto wall = [](int number, double gap) { return std::pair(number, Wall{.obstacle = number, .gap = gap}); };
  CHECK_FALSE(margins.fitted({}, 0.1, closely).has_value());
  CHECK_FALSE(margins.fitted({wall(0, 0.021), wall(1, 5e-4)}, 0.1, closely).has_value());
  CHECK(margins.fitted({wall(0, 0.019)}, 0.1, closely).has_value());  // kept away from for nothing
  CHECK(margins.fitted({wall(0, -0.001)}, 0.1, closely).value().widths().at(0) > 0.02);
  CHECK(margins.fitted({wall(2, -0.001)}, 0.1, closely).value().widths().at(2) > 0);
}

TEST_CASE("free space: margins that are kept leave a quarter of what a fit allows") {
  const WallMargins margins(0.1, 0, {{0, 0.02}, {1, 0.02}, {2, 0.02}, {3, 0.02}});
  const WallMargins::Fit closely{1e-3, 1e-14, 1e-10};
  const auto kept = margins.widths_for_next({{0, 0}, {1, 9e-4}, {2, 0.03}}, closely);
  CHECK(kept.at(0) == Approx(0.02025));
  CHECK(kept.at(1) == Approx(0.01935));
  CHECK(kept.at(2) == 0.02);  // it holds no point
  CHECK(kept.at(3) == 0.02);  // nothing is known of it
}

TEST_CASE("free space: a chain comes along with the walls that it rested on") {
  const auto among = [](double shift) { return across(plane({disc(0, -0.05 + shift, 1)})); };
  Problem problem = among(0);
  CoordinatePath path{Points::Zero(2, 42), {}, false};
  path.u.row(0).setLinSpaced(-2, 2);
  const FittedSolve solved = solve_fitted(problem, Newton(), 4.0 / 41, path, {});
  const auto& fitted = *find_ability<ReusesMargins>(*solved.problem.manifold);
  const KeptMargins kept = fitted.kept_margins(path, solved.gaps);
  REQUIRE(kept.walls == 1);
  REQUIRE(kept.widths.size() == 1);
  const auto resting =
      std::count_if(kept.resting.begin(), kept.resting.end(), [](const auto& w) { return !w.empty(); });
  CHECK(resting > 5);
  for (const double shift : {0.01, -0.01}) {  // onto the path, and away from it
    CAPTURE(shift);
    Problem moved = among(shift);
    const auto domain = find_ability<ReusesMargins>(*moved.manifold)->unfitted_with(kept, path, 1e-4);
    REQUIRE(domain != nullptr);
    CoordinatePath carried = path;
    find_ability<ReusesMargins>(*domain)->carry_along(kept, carried, {});
    const auto now = find_ability<ReusesMargins>(*domain)->kept_margins(carried, {}).resting;
    CHECK(now == kept.resting);
    CoordinatePath warm = path, cold = path;
    const SolveReport quick = solve_fitted(moved, Newton(), 4.0 / 41, warm, {}, {1e-4, &kept}).report;
    const SolveReport slow = solve_fitted(moved, Newton(), 4.0 / 41, cold, {}).report;
    CHECK(is_solved(quick.termination));
    CHECK(is_solved(slow.termination));
    const auto cost = [&](const CoordinatePath& p) { return PathEnergy(moved, 1).costs(p).sum(); };
    CHECK(std::abs(cost(warm) - cost(cold)) < 1e-4 * cost(cold));
  }
  const Problem of_two = across(plane({disc(0, 0, 1), disc(9, 9, 1)}));
  CHECK(find_ability<ReusesMargins>(*of_two.manifold)->unfitted_with(kept, path, 1e-4) == nullptr);
}

TEST_CASE("free space: a finer chain is placed for its own moves, not for those of the chain that was solved") {
  // Past a disc smaller than a move: points keep half a move from it.
  Problem problem = across(plane({disc(0, 0.1, 0.02)}));
  CoordinatePath path{Points::Zero(2, 12), {}, false};
  path.u.row(0).setLinSpaced(-2, 2);
  const FittedSolve solved = solve_fitted(problem, Newton(), 4.0 / 11, path, {});
  REQUIRE(is_solved(solved.report.termination));
  const CoordinatePath fine = refine(solved.problem, path);
  for (Index i = 1; i < fine.u.cols(); i += 2) {
    const Vector2d middle = (fine.u.col(i - 1) + fine.u.col(i + 1)) / 2;
    CHECK((fine.u.col(i) - middle).norm() < 0.01);
  }
}

TEST_CASE("free space: a chain with too few points for a gate ends soon") {
  Problem problem =
      across(plane({disc(0, 0.08, 0.05), disc(0, -0.08, 0.05), disc(0.5, 0.3, 0.2), disc(0.5, -0.3, 0.2)}));
  CoordinatePath path{Points::Zero(2, 7), {}, false};
  path.u.row(0).setLinSpaced(-2, 2);
  const SolveReport report = solve_fitted(problem, Newton(), 4.0 / 6, path, {}).report;
  CAPTURE(report.iterations, report.counters.energies, word_of(report.termination));
  CHECK(report.counters.energies < 200);
}

/// An arm in a cage: a solve of a chain without room pushed its points and spaced them for minutes.
TEST_CASE("free space: a chain whose points have no room is not solved at all") {
  BoxOptions box;
  box.lower = Vector2d(-3, -0.3);
  box.upper = Vector2d(3, 0.3);
  FreeSpace::Obstacles sides;
  for (double x = -1.5; x < 1.55; x += 0.1)
    for (const double y : {-0.1, 0.1}) sides.push_back(disc(x, y, 0.02));
  Problem problem = across(plane(sides, box));
  for (const int segments : {8, 64}) {
    CAPTURE(segments);
    CoordinatePath path{Points::Zero(2, segments + 1), {}, false};
    path.u.row(0).setLinSpaced(-2, 2);
    const FittedSolve solved = solve_fitted(problem, Newton(), 4.0 / segments, path, {});
    CAPTURE(solved.report.message);
    CHECK(solved.torn == (segments == 8));
    CHECK(is_solved(solved.report.termination) == (segments == 64));
    if (solved.torn) CHECK(solved.report.counters.energies == 0);
  }
}

}  // namespace leastcost::test
