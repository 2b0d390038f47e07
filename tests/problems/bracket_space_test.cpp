// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/bracket/space/space_bracket.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <leastcost/framework/errors.hpp>
#include <leastcost/framework/find_path.hpp>
#include <leastcost/problems/costs/refractive_index.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/post_processors/bracket.hpp>
#include <leastcost/solvers/newton.hpp>
#include "problems/bracket/space/space_level.hpp"
#include "tests/problems/planted_space.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr double kOfPlantedSpace = 1e-13;  // relative rounding of the planted least cost itself

int space_problems(int otherwise) {
  const char* text = std::getenv("LEASTCOST_BRACKET_PROBLEMS");  // NOLINT(concurrency-mt-unsafe)
  return text == nullptr ? otherwise : std::atoi(text);
}

std::shared_ptr<const SegmentCost> isotropic_cost(const std::string& squared) {
  return make_metric_field_cost({.field = metric::Formula{{squared, "0", "0", squared, "0", squared}, {}}}, 3);
}
std::shared_ptr<const SpaceDensity> isotropic_density(const std::string& n) {
  return space_density_of(make_refractive_index_cost({.index = refraction::Formula{n, {}}}, 3));
}

Vector3d somewhere(const AlignedBox3d& box, Random& random) {
  return {random.uniform(box.min()[0], box.max()[0]), random.uniform(box.min()[1], box.max()[1]),
          random.uniform(box.min()[2], box.max()[2])};
}

/// Largest |grad u| / n at random places where the inequality is said to be proved, over the ratio that is proved.
double worst_slope(const SpacePotential& potential, const SpaceDensity& density, const AlignedBox3d& box, int count,
                   Random& random) {
  double worst = 0;
  for (int k = 0; k < count; ++k) {
    const Vector3d x = somewhere(box, random);
    if (!potential.is_checked(x)) continue;
    worst = std::max(worst, potential.gradient(x).norm() / (potential.ratio() * density.density(x)));
  }
  return worst;
}

}  // namespace

/// A bound above a true least cost is the worst defect. LEASTCOST_BRACKET_PROBLEMS sets another number of them.
TEST_CASE("bracket in space: never above a planted least cost") {
  Random random;
  const int count = space_problems(12);
  std::vector<double> gaps;
  for (int k = 0; k < count; ++k) {
    CAPTURE(k);
    const PlantedSpace medium = PlantedSpace::random(random);
    const std::shared_ptr<const SpaceDensity> density = space_density_of(medium.cost());
    const double truth = medium.least_cost();
    const SpaceBracket bracket = bracket_least_cost(
        *density, medium.box, medium.source, medium.target,
        k % 2 == 0 ? truth * (1 + random.uniform(1e-6, 1e-3)) : kEndless,
        {.tolerance = 1e-12, .cells = random.integer(12, 18), .max_cells = k % 4 == 0 ? 72 : 36, .max_searched = 2e5});
    REQUIRE(bracket.lower <= truth * (1 + kOfPlantedSpace));
    REQUIRE(bracket.upper >= truth * (1 - kOfPlantedSpace));
    if (bracket.potential) CHECK(worst_slope(*bracket.potential, *density, medium.box, 2000, random) <= 1 + 1e-11);
    if (bracket.potential) gaps.push_back(1 - bracket.lower / truth);
  }
  std::sort(gaps.begin(), gaps.end());
  REQUIRE(static_cast<int>(gaps.size()) >= count / 2);
  CHECK(gaps[gaps.size() / 2] < 0.03);
  if (count > 100)
    WARN(gaps.size() << " of " << count << " bounded by a potential; gap: median " << gaps[gaps.size() / 2] << ", 90 % "
                     << gaps[gaps.size() * 9 / 10] << ", largest " << gaps.back());
}

TEST_CASE("bracket in space: the polyline of a planted flow costs what it has to") {
  Random random;
  for (int k = 0; k < 5; ++k) {
    const PlantedSpace medium = PlantedSpace::random(random);
    const std::shared_ptr<const SpaceDensity> density = space_density_of(medium.cost());
    Eigen::Matrix3Xd x(3, static_cast<Eigen::Index>(medium.flow.size()));
    for (std::size_t i = 0; i < medium.flow.size(); ++i) x.col(static_cast<Eigen::Index>(i)) = medium.flow[i];
    const double cost = polyline_cost_above(*density, x), truth = medium.least_cost();
    CHECK(cost >= truth);
    CHECK(cost <= truth * (1 + 1e-4));
  }
}

/// Closed forms (docs/oracles.md), and gaps that the construction is built for.
TEST_CASE("bracket in space: media with known least costs") {
  struct Case {
    const char* density;
    Vector3d source, target;
    AlignedBox3d box;
    double cost, gap;
  };
  const std::vector<Case> cases = {
      {"1",
       {-1, 0.3, 0.1},
       {1.2, -0.4, -0.3},
       {Vector3d(-1.6, -1.6, -1.6), Vector3d(1.6, 1.6, 1.6)},
       std::sqrt(5.49),
       1e-3},
      {"2 / (1 + x^2 + y^2 + z^2)",
       {0.5, -0.2, 0.1},
       {-0.7, 0.9, -0.2},
       {Vector3d(-1.4, -1, -1.4), Vector3d(1.4, 1.8, 1.4)},
       2 * std::asin(std::sqrt(2.74 / (1.3 * 2.34))),
       6e-3},
      {"1 / z",
       {0, 0.1, 1},
       {1.6, 1.3, 3},
       {Vector3d(-1, -1.2, 0.4), Vector3d(2.6, 2.4, 4)},
       std::acosh(1 + 8.0 / 6),
       8e-3},
      {"1 / (1 + 0.5 * z)",
       {0, 0, 0},
       {3.2, 2.4, 1},
       {Vector3d(-0.5, -0.5, -0.5), Vector3d(4.5, 4.5, 4.5)},
       3.05937323665641694,
       6e-3},
  };
  for (const Case& c : cases) {
    CAPTURE(c.density);
    const std::shared_ptr<const SpaceDensity> density = isotropic_density(c.density);
    const SpaceBracket found =
        bracket_least_cost(*density, c.box, c.source, c.target, kEndless, {.tolerance = c.gap, .cells = 24});
    CHECK(found.lower <= c.cost * (1 + 1e-12));
    CHECK(found.upper >= c.cost * (1 - 1e-12));
    CHECK(found.gap() <= c.gap);
    REQUIRE(found.way.cols() > 2);
    CHECK(found.way.leftCols(1) == c.source);
    CHECK(found.way.rightCols(1) == c.target);
  }
}

TEST_CASE("bracket in space: around a ball") {
  const std::shared_ptr<const SpaceDensity> density = isotropic_density("1");
  // Two tangents and an arc.
  const double least = 2 * std::sqrt(3.0) + std::acos(-1.0) / 3;
  SpaceBracketOptions options{.tolerance = 1e-6, .cells = 32, .max_cells = 64};
  options.depth = [](const Vector3d& x) { return 1 - x.norm(); };
  const SpaceBracket found = bracket_least_cost(*density, {Vector3d(-2.6, -1.8, -1.8), Vector3d(2.6, 1.8, 1.8)},
                                                Vector3d(-2, 0, 0), Vector3d(2, 0, 0), least * (1 + 1e-6), options);
  CHECK(found.lower <= least);
  CHECK(found.lower > 4.05);  // straight through it would be 4
}

TEST_CASE("bracket in space: nothing is proved of what is not known") {
  const AlignedBox3d around(Vector3d(-1, -1, -1), Vector3d(1, 1, 1));
  const Vector3d s(-0.5, 0, 0), t(0.5, 0.1, 0);
  const SpaceBracketOptions coarse{.cells = 24, .max_cells = 24};
  // Not the same in all directions, but by formula: the bound is of the cheaper direction, and holds.
  const auto metric = [](const std::string& xy, const std::string& yy) {
    return space_density_of(make_metric_field_cost({.field = metric::Formula{{"1", xy, "0", yy, "0", "9"}, {}}}, 3));
  };
  const SpaceBracket weak = bracket_least_cost(*metric("0", "4"), around, s, t, 1.1, coarse);
  CHECK(weak.lower > 0.8);
  CHECK(weak.lower <= std::hypot(1, 0.1));
  CHECK(bracket_least_cost(*metric("0.1", "1"), around, s, t, 2, coarse).lower == 0);
  // A place in the box where the formula has no value: only the surroundings of an end prove something.
  CHECK(bracket_least_cost(*isotropic_density("sqrt(log(x + 0.8)^2 + 1)"), around, s, t, 10, coarse).lower < 0.5);
  CHECK_THROWS_AS(bracket_least_cost(*metric("0", "1"), around, s, Vector3d(2, 0, 0)), InputError);
  CHECK_THROWS_AS(bracket_least_cost(*metric("0", "1"), AlignedBox3d(), s, t), InputError);
}

TEST_CASE("bracket in space: stopped at any time it keeps what is proved") {
  const std::shared_ptr<const SpaceDensity> density = isotropic_density("2 / (1 + x^2 + y^2 + z^2)");
  const double least = 2 * std::asin(std::sqrt(2.74 / (1.3 * 2.34)));
  for (const int after : {0, 3, 30, 100}) {
    int looks = 0;
    SpaceBracketOptions options{.tolerance = 1e-9, .cells = 20, .max_cells = 80};
    options.stop = [&] { return ++looks > after; };
    const SpaceBracket found =
        bracket_least_cost(*density, {Vector3d(-1.4, -1, -1.4), Vector3d(1.4, 1.8, 1.4)}, Vector3d(0.5, -0.2, 0.1),
                           Vector3d(-0.7, 0.9, -0.2), kEndless, options);
    CHECK(found.stopped);
    CHECK(looks == after + 1);
    CHECK(found.lower <= least);
  }
}

namespace {

using namespace bracket;

/// A cell of side 1 with random coefficients around a plane, and the largest length of its gradient at 9^3 places, in
/// long double.
struct RandomCube {
  CubeNet u = {};
  long double longest = 0;

  RandomCube(Random& random, double noise) {
    const double size = random.uniform(0.5, 2);
    const Vector3d along = size * Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    for (int k = 0; k < 27; ++k)
      u[static_cast<std::size_t>(k)] =
          along.dot(Vector3d(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1)) + noise * random.normal();
    constexpr int kParts = 8;
    for (int n = 0; n < (kParts + 1) * (kParts + 1) * (kParts + 1); ++n) {
      const auto at = [&](int i) { return static_cast<long double>(i % (kParts + 1)) / kParts - 0.5L; };
      longest = std::max(longest, slope({at(n), at(n / (kParts + 1)), at(n / (kParts + 1) / (kParts + 1))}));
    }
  }
  long double slope(const std::array<long double, 3>& at) const {
    std::array<std::array<long double, 3>, 3> w, d;
    for (std::size_t k = 0; k < 3; ++k) {
      const long double t = at[k];
      w[k] = {(0.5L - t) * (0.5L - t) / 2, 0.75L - t * t, (0.5L + t) * (0.5L + t) / 2};
      d[k] = {t - 0.5L, -2 * t, t + 0.5L};
    }
    long double x = 0, y = 0, z = 0;
    for (std::size_t k = 0; k < 27; ++k) {
      const std::size_t p = k % 3, q = k / 3 % 3, r = k / 9;
      x += d[0][p] * w[1][q] * w[2][r] * u[k];
      y += w[0][p] * d[1][q] * w[2][r] * u[k];
      z += w[0][p] * w[1][q] * d[2][r] * u[k];
    }
    return std::sqrt(x * x + y * y + z * z);
  }
};

/// How often the rules claim less than the gradient has.
int false_space_claims(const CubeRules& rules, double noise, Random& random) {
  CubeNet one;
  one.fill(1);
  int wrong = 0;
  for (int k = 0; k < 120; ++k) {
    const RandomCube cell(random, noise);
    wrong += static_cast<long double>(proved_ratio(cell.u, 1, 4, one, rules)) < cell.longest ? 1 : 0;
  }
  return wrong;
}

}  // namespace

/// Mutations of the check are seen by the same comparison that the check itself passes.
TEST_CASE("bracket in space: the check of a cell, and checks that are not") {
  Random random;
  for (const double noise : {0.0, 1e-14, 1e-3, 0.3})
    for (const int halvings : {0, 1}) CHECK(false_space_claims({.halvings = halvings}, noise, random) == 0);
  CHECK(false_space_claims({.rounding = -1}, 0, random) > 30);
  for (const unsigned corner : {0U, 2U, 6U, 8U, 18U, 20U, 24U, 26U}) {
    CAPTURE(corner);
    CHECK(false_space_claims({.dropped = 1U << corner}, 0.3, random) > 0);
  }
}

TEST_CASE("bracket in space: the floor of a density lies below it, and near") {
  Random random;
  for (int k = 0; k < 20; ++k) {
    const PlantedSpace medium = PlantedSpace::random(random);
    const std::shared_ptr<const SpaceDensity> density = space_density_of(medium.cost());
    const SpaceGrid grid = SpaceGrid::over(medium.box, 40);
    Place cell;
    for (std::size_t axis = 0; axis < 3; ++axis) cell[axis] = random.integer(1, grid.cells[axis]);
    // Of a cube of cells to one side, as on finer grids.
    const Vector3d middle = Vector3d(cell[0], cell[1], cell[2]) + 0.5 * Vector3d::Ones();
    for (const bool alone : {false, true}) {
      const CubeNet floor = space_floor(*density, alone ? grid.cell(cell) : grid.cube(middle, 1)).on_cell(grid, cell);
      for (int n = 0; n < 50; ++n) {
        const Vector3d t(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
        const Vector3d x = grid.node(cell) + grid.h * (t - 0.5 * Vector3d::Ones());
        if (!medium.box.contains(x)) continue;
        double value = 0;
        for (std::size_t c = 0; c < 27; ++c) {
          double weight = 1;
          const std::array<std::size_t, 3> number = {c % 3, c / 3 % 3, c / 9};
          for (int axis = 0; axis < 3; ++axis) {
            const double s = t[axis];
            weight *= std::array<double, 3>{(1 - s) * (1 - s), 2 * s * (1 - s), s * s}[number[axis]];
          }
          value += weight * floor[c];
        }
        CHECK(value <= medium.density(x));
        CHECK(value >= medium.density(x) - 0.05);
      }
    }
  }
}

/// The cells around the ends: with those that the check left out the bound holds, with fewer it uses a part of the
/// potential that nobody has checked.
TEST_CASE("bracket in space: an end region that is too small is caught") {
  const std::shared_ptr<const SpaceDensity> density = isotropic_density("1");
  const std::function<bool()> never;
  const StopLook look(never);
  const Vector3d source(0.262, 0.512, 0.512), target(0.762, 0.512, 0.512);
  const std::function<double(const Vector3d&)> open;
  const SpaceLevel level =
      whole_space_level({*density, open}, {Vector3d(0, 0.2, 0.2), Vector3d(1, 0.8, 0.8)}, 40, look);
  const SpaceGrid& grid = level.grid;
  const EndBall s = end_ball(*density, grid, source, 3), t = end_ball(*density, grid, target, 3);
  REQUIRE(s.valid);
  REQUIRE(t.valid);
  REQUIRE(s.k == 3);
  std::vector<double> u(level.density.size()), ratios;
  for (int node = 0; node < level.nodes.none(); ++node)
    u[static_cast<std::size_t>(node)] = grid.coordinate(0, level.nodes.place(node)[0]);
  // Within the region of the source, seen by no cell outside.
  u[static_cast<std::size_t>(level.nodes.find(s.middle))] -= 0.3;
  const auto bound = [&](const EndBall& around_s, double ratio) {
    return rim_minimum(grid, level.nodes, around_s, level.searched, u, -1, ratio) +
           rim_minimum(grid, level.nodes, t, level.searched, u, 1, ratio);
  };
  const double truth = 0.5, ratio = check(level, u, s, t, ratios, look);
  CHECK(ratio < 1 + 1e-9);
  CHECK(bound(s, ratio) <= truth);
  CHECK(bound(s, ratio) > 0.9 * truth);
  EndBall small = s;
  small.k = 0;
  CHECK(bound(small, ratio) > truth);  // what a wrong region would claim
  CHECK(check(level, u, small, t, ratios, look) > 2);
  CHECK(bound(small, check(level, u, small, t, ratios, look)) <= truth);
}

/// v of the regions around the ends, against the costs of planted media: along their flow, whichever way it goes on.
TEST_CASE("bracket in space: the cone at an end lies below the cost") {
  Random random;
  int valid = 0;
  for (int k = 0; k < 40; ++k) {
    const PlantedSpace medium = PlantedSpace::random(random);
    const std::shared_ptr<const SpaceDensity> density = space_density_of(medium.cost());
    const SpaceGrid grid = SpaceGrid::over(medium.box, random.integer(20, 80));
    const EndBall region = end_ball(*density, grid, medium.source, random.integer(1, 6));
    if (!region.valid) continue;
    ++valid;
    for (const Vector3d& x : medium.flow) {
      if (!region.holds(grid.place_at(x))) break;
      const Vector3d d = x - medium.source;
      const double cone = std::min(region.cone<double>({d[0], d[1], d[2]}), region.most);
      CHECK(cone <= (medium.u(x) - medium.u(medium.source)) * (1 + 1e-12) + 1e-15);
    }
  }
  CHECK(valid > 32);
}

namespace {

Problem in_space(const AlignedBox3d& box, const std::shared_ptr<const SegmentCost>& cost, const Vector3d& source,
                 const Vector3d& target) {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(
      EuclideanManifoldOptions{3, {Eigen::VectorXd(box.min()), Eigen::VectorXd(box.max())}});
  problem.cost = cost;
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = source;
  problem.target.u = target;
  return problem;
}

FindOptions bracketed(double tolerance) {
  FindOptions options;
  options.points = 40;
  options.post_processors = {std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = tolerance})};
  return options;
}

}  // namespace

TEST_CASE("bracket in space: find_path says that no path in the box is cheaper") {
  const AlignedBox3d box(Vector3d(-1, -1.2, 0.4), Vector3d(2.6, 2.4, 4));
  const Problem problem = in_space(box, isotropic_cost("1 / z^2"), {0, 0.1, 1}, {1.6, 1.3, 3});
  const Result result = find_path(problem, StraightInitializer(), Newton(), bracketed(5e-3));
  CHECK(result.status == Status::certified);
  CHECK(result.certificate.scope == "global");
  REQUIRE(result.certificate.global);
  const GlobalBound& bound = *result.certificate.global;
  CHECK(bound.outcome == "proved");
  CHECK(bound.category == BoundCategory::proved);
  CHECK(bound.gap <= 5e-3);
  const double least = std::acosh(1 + 8.0 / 6);
  CHECK(bound.lower_bound <= least);
  REQUIRE(bound.grid);
  CHECK(bound.grid->upper >= least);
  CHECK(bound.grid->cells.size() == 3);
  CHECK(bound.grid->box.max() == Vector3d(2.6, 2.4, 4));
  CHECK(bound.grid->potential.values.empty());
}

TEST_CASE("bracket in space: from the dearer side of a hill the cheaper way is delivered") {
  const AlignedBox3d box(Vector3d(-2.3, -1.9, -1), Vector3d(2.3, 1.9, 1));
  const Problem problem =
      in_space(box, isotropic_cost("(1 + 2 * exp(-x^2 - (y + 0.4)^2 - z^2 / 9))^2"), {-2, 0, 0}, {2, 0, 0});
  Points below(3, 1);
  below.col(0) << 0, -1.6, 0;
  const Result result = find_path(problem, WaypointsInitializer(below), Newton(), bracketed(0.05));
  REQUIRE(result.certificate.global);
  CHECK(result.certificate.global->outcome == "improved");
  CHECK(result.curve.x.row(1).maxCoeff() > 0.5);
}

TEST_CASE("bracket in space: blocked, with a reason") {
  const AlignedBox3d box(Vector3d(-2, -2, -2), Vector3d(2, 2, 2));
  const auto reason = [](const Problem& problem) {
    const Result result = find_path(problem, StraightInitializer(), Newton(), bracketed(1e-2));
    CHECK(result.certificate.scope == "local");
    const GlobalBound bound = result.curve.global.value();
    CHECK(bound.outcome == "blocked");
    CHECK_FALSE(bound.proved);
    return bound.reason;
  };
  const auto stretched = make_metric_field_cost({.field = metric::Formula{{"1", "0", "0", "2", "0", "1"}, {}}}, 3);
  CHECK_THAT(reason(in_space(box, stretched, {-1, 0, 0}, {1, 0.5, 0})), Catch::Contains("same in all directions"));
  Problem open = in_space(box, isotropic_cost("1 + x^2"), {-1, 0, 0}, {1, 0.5, 0});
  open.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{3, {}});
  CHECK_THAT(reason(open), Catch::Contains("finite bounds"));
}

}  // namespace leastcost::test
