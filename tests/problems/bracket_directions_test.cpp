// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/bracket/search/bracket.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/post_processors/bracket.hpp>
#include <leastcost/solvers/newton.hpp>
#include "problems/bracket/cells/dual_check.hpp"
#include "problems/bracket/cells/end_square.hpp"
#include "tests/problems/planted_directions.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kOfPlanted = 1e-9;  // what the integration of the planted flow may miss

std::shared_ptr<const SegmentCost> wind(const std::string& speed, const std::string& wx, const std::string& wy) {
  return make_zermelo_cost({.speed = speed, .flow = flow::Formula{{wx, wy}}}, 2);
}
std::shared_ptr<const SegmentCost> metric_of(const std::string& xx, const std::string& xy, const std::string& yy) {
  return make_metric_field_cost({.field = metric::Formula{{xx, xy, yy}, {}}}, 2);
}
AlignedBox2d plane(double x0, double y0, double x1, double y1) { return {Vector2d(x0, y0), Vector2d(x1, y1)}; }

/// Brackets of planted problems, of which every fifth is refined; returns their gaps below the truth, sorted.
template <class Make>
std::vector<double> planted_gaps(const Make& make, int count, Random& random) {
  std::vector<double> gaps;
  for (int k = 0; k < count; ++k) {
    CAPTURE(k);
    const PlantedDirections planted = make(random);
    const std::shared_ptr<const CostDual> dual = dual_of(planted.cost());
    const AlignedBox2d& box = planted.medium.box;
    const double truth = planted.least_cost();
    const double known = k % 2 == 0 ? truth * (1 + random.uniform(1e-6, 1e-3)) : kUnbounded;
    const bool fine = k % 5 == 0;
    const Bracket bracket = bracket_least_cost(
        *dual, box, planted.medium.source, planted.target, known,
        {.tolerance = 1e-3, .cells = fine ? 28 : random.integer(16, 24), .max_cells = fine ? 112 : 24});
    REQUIRE(bracket.lower <= truth * (1 + kOfPlanted));
    REQUIRE(bracket.upper >= truth * (1 - kOfPlanted));
    if (bracket.potential) CHECK(worst_dual(*bracket.potential, *dual, box, random) <= 1 + 1e-9);
    if (fine) gaps.push_back(1 - bracket.lower / truth);
  }
  std::sort(gaps.begin(), gaps.end());
  if (count > 100)
    WARN("gap: median " << gaps[gaps.size() / 2] << ", 90 % " << gaps[gaps.size() * 9 / 10] << ", largest "
                        << gaps.back());
  return gaps;
}

}  // namespace

/// A bound above a true least cost is the worst defect. LEASTCOST_BRACKET_PROBLEMS sets another number of them.
TEST_CASE("bracket of metrics: never above a planted least cost") {
  Random random;
  const auto make = [](Random& r) { return PlantedDirections::metric(r, r.uniform(1, 2)); };
  const std::vector<double> gaps = planted_gaps(make, planted_problems(16), random);
  CHECK(gaps[gaps.size() / 2] < 0.2);
}

TEST_CASE("bracket of winds: never above a planted least cost") {
  Random random;
  const auto make = [](Random& r) { return PlantedDirections::windy(r, r.uniform(0.2, 1)); };
  const std::vector<double> gaps = planted_gaps(make, planted_problems(16), random);
  CHECK(gaps[gaps.size() / 2] < 0.2);
}

TEST_CASE("bracket of metrics and winds: the polyline of a planted flow costs what it has to") {
  Random random;
  for (int k = 0; k < 10; ++k) {
    const PlantedDirections planted =
        k % 2 == 0 ? PlantedDirections::metric(random, 3) : PlantedDirections::windy(random, 0.9);
    const std::shared_ptr<const CostDual> dual = dual_of(planted.cost());
    Eigen::Matrix2Xd x(2, static_cast<Eigen::Index>(planted.flow.size()));
    for (std::size_t i = 0; i < planted.flow.size(); ++i) x.col(static_cast<Eigen::Index>(i)) = planted.flow[i];
    const double cost = polyline_cost_above(*dual, x), truth = planted.least_cost();
    CHECK(cost >= truth);
    CHECK(cost <= truth * (1 + 1e-4));
  }
}

/// Closed forms (docs/oracles.md).
TEST_CASE("bracket of metrics and winds: known least costs") {
  struct Case {
    std::shared_ptr<const SegmentCost> cost;
    Vector2d source, target;
    AlignedBox2d box;
    double least, gap;
  };
  const Vector2d o(0, 0), a(3, 1), b(2, -0.8), c(0, 0.6);
  const AlignedBox2d round = plane(-1, -2, 4, 3), strip = plane(-1.5, -0.95, 3, 0.95);
  const std::vector<Case> cases = {
      // d'Gd = 9 * 2 + 6 * 0.5 + 1.
      {metric_of("2", "0.5", "1"), o, a, round, std::sqrt(22.0), 1e-4},
      {wind("1", "0.4", "0.3"), o, a, round, 2.16333199893226547, 1e-4},
      {wind("1", "0.4", "0.3"), a, o, round, 6.16333199893226547, 1e-3},
      // Up to 0.95 of the speed: coarse grids bound little.
      {wind("1", "-y", "0"), b, c, strip, 2.40961645307160186, 0.6},
      {wind("1", "-y", "0"), c, b, strip, 2.14281188063285385, 0.6},
  };
  for (const Case& known : cases) {
    CAPTURE(known.least);
    const std::shared_ptr<const CostDual> dual = dual_of(known.cost);
    REQUIRE(dual);
    const Bracket found = bracket_least_cost(*dual, known.box, known.source, known.target, kUnbounded,
                                             {.tolerance = known.gap, .cells = 96, .max_cells = 400});
    CHECK(found.lower <= known.least * (1 + 1e-12));
    CHECK(found.upper >= known.least * (1 - 1e-12));
    CHECK(found.gap() <= known.gap);
  }
}

TEST_CASE("bracket of winds: where the wind is the faster") {
  // Bryson and Ho: the source lies in a current that is faster than the boat, where no cone is known.
  const std::shared_ptr<const CostDual> shear = dual_of(wind("1", "-y", "0"));
  const Bracket none = bracket_least_cost(*shear, plane(-1, -3, 7, 2), Vector2d(3.66, -1.86), Vector2d(0, 0),
                                          5.45786526356, {.cells = 64, .max_cells = 64});
  CHECK(none.lower <= 5.45786526356);
  // A jet of twice the speed of the boat between two slow places: it carries it through.
  const std::shared_ptr<const CostDual> jet = dual_of(wind("1", "2 * exp(-2 * (x - 1)^2)", "0"));
  const Bracket found = bracket_least_cost(*jet, plane(-2, -2, 4, 2), Vector2d(-1, 0), Vector2d(3, 0.5), kUnbounded,
                                           {.tolerance = 5e-3, .cells = 96, .max_cells = 400});
  CHECK(found.lower > 0);
  CHECK(found.gap() <= 5e-3);
}

namespace {

using namespace bracket;

/// A cell of side 1 with random coefficients around a plane and a norm that is linear in the place; the largest H of
/// the gradient at 33 x 33 places, in long double.
struct DualRandomCell {
  Net<2> u = {};
  DualCell cell;
  long double largest = 0;

  DualRandomCell(Random& random, double noise) {
    const double angle = random.uniform(0, 6.3);
    for (int k = 0; k < 9; ++k) {
      const int column = k % 3, row = k / 3;
      u[static_cast<std::size_t>(k)] =
          std::cos(angle) * (column - 1) + std::sin(angle) * (row - 1) + noise * random.normal();
    }
    const auto entry = [&](Quadratic& q, double value) {
      q.v = value, q.x = 0.1 * noise * random.normal(), q.y = 0.1 * noise * random.normal();
      q.size = std::abs(q.v) + 0.5 * (std::abs(q.x) + std::abs(q.y));
    };
    entry(cell.xx, 2), entry(cell.xy, random.uniform(-0.8, 0.8)), entry(cell.yy, 1);
    entry(cell.wx, random.uniform(-0.5, 0.5)), entry(cell.wy, random.uniform(-0.5, 0.5));
    for (int q = 0; q <= 32; ++q)
      for (int p = 0; p <= 32; ++p) largest = std::max(largest, norm(p / 32.0L - 0.5L, q / 32.0L - 0.5L));
  }
  long double norm(long double a, long double b) const {
    const auto w = [](long double t) {
      return std::array<long double, 3>{(0.5L - t) * (0.5L - t) / 2, 0.75L - t * t, (0.5L + t) * (0.5L + t) / 2};
    };
    const auto d = [](long double t) { return std::array<long double, 3>{t - 0.5L, -2 * t, t + 0.5L}; };
    const auto wa = w(a), wb = w(b), da = d(a), db = d(b);
    long double x = 0, y = 0;
    for (std::size_t k = 0; k < 9; ++k) {
      x += da[k % 3] * wb[k / 3] * u[k];
      y += wa[k % 3] * db[k / 3] * u[k];
    }
    const auto at = [&](const Quadratic& f) { return f.v + f.x * a + f.y * b; };
    return std::sqrt(at(cell.xx) * x * x + 2 * at(cell.xy) * x * y + at(cell.yy) * y * y) + at(cell.wx) * x +
           at(cell.wy) * y;
  }
};

/// How often the rules claim less than the gradient has.
int false_dual_claims(const CheckRules<2>& rules, double noise, Random& random) {
  int wrong = 0;
  for (int k = 0; k < 300; ++k) {
    const DualRandomCell cell(random, noise);
    wrong += static_cast<long double>(proved_dual_ratio(cell.u, 1, 3, 1, cell.cell, rules)) < cell.largest;
  }
  return wrong;
}

}  // namespace

/// Mutations of the check are seen by the same comparison that the check itself passes.
TEST_CASE("bracket of metrics and winds: the check of a cell, and checks that are not") {
  Random random;
  for (const double noise : {0.0, 1e-14, 1e-3, 0.3}) CHECK(false_dual_claims({}, noise, random) == 0);
  CHECK(false_dual_claims({.rounding = -1}, 0, random) > 100);
  for (unsigned k = 0; k < 9; ++k) {
    if (k == 4) continue;  // the mean of others
    CAPTURE(k);
    CHECK(false_dual_claims({.dropped = 1U << k, .halvings = 0}, 0.3, random) > 0);
  }
  for (const double noise : {1e-3, 0.3}) CHECK(false_dual_claims({.halvings = 0}, noise, random) == 0);
}

/// Whole cells against the norm itself, between and beside the rims of the box.
TEST_CASE("bracket of metrics and winds: what is known of a cell holds, and is narrow") {
  Random random;
  for (int k = 0; k < 20; ++k) {
    const PlantedDirections planted =
        k % 2 == 0 ? PlantedDirections::metric(random, 2) : PlantedDirections::windy(random, 0.9);
    const std::shared_ptr<const CostDual> dual = dual_of(planted.cost());
    const AlignedBox2d& box = planted.medium.box;
    const Grid<2> grid = Grid<2>::over(box, 200);
    const int i = random.integer(1, grid.cells[0]), j = random.integer(1, grid.cells[1]);
    const DualCell cell = dual_cell(*dual, grid, {i, j});
    for (int n = 0; n < 40; ++n) {
      const Vector2d d = grid.h * Vector2d(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
      const Vector2d x = grid.node({i, j}) + d;
      if (!box.contains(x)) continue;
      const DualNorm<double> norm = dual->dual(x);
      const auto off = [&](const Quadratic& q, double value) {
        const double p =
            q.v + q.x * d[0] + q.y * d[1] + 0.5 * (q.xx * d[0] * d[0] + q.yy * d[1] * d[1]) + q.xy * d[0] * d[1];
        CHECK(std::abs(p - value) <= q.slack + 1e-12 * (1 + std::abs(value)));
        CHECK(q.slack <= 0.05 * (1 + std::abs(value)));
      };
      off(cell.xx, norm.xx), off(cell.xy, norm.xy), off(cell.yy, norm.yy), off(cell.wx, norm.wx), off(cell.wy, norm.wy);
    }
  }
}

TEST_CASE("bracket of metrics and winds: the cone at an end lies below the cost") {
  Random random;
  int valid = 0;
  for (int k = 0; k < 60; ++k) {
    const PlantedDirections planted =
        k % 2 == 0 ? PlantedDirections::metric(random, 2) : PlantedDirections::windy(random, 0.9);
    const std::shared_ptr<const CostDual> dual = dual_of(planted.cost());
    const Grid<2> grid = Grid<2>::over(planted.medium.box, random.integer(100, 400));
    const bool back = random.integer(0, 1) == 1;
    const Vector2d& end = back ? planted.target : planted.medium.source;
    const EndSquare<DualCone> region = end_square(*dual, grid, end, random.integer(2, 6), back);
    if (!region.valid) continue;
    ++valid;
    for (const Vector2d& x : planted.flow) {
      if (x == end || !region.holds(grid.place_at(x))) continue;
      const double cost = std::abs(planted.u(x) - planted.u(end));
      const double cone = std::min(region.cone.value(x[0] - end[0], x[1] - end[1]), region.cone.most);
      CHECK(cone <= cost * (1 + kOfPlanted) + 1e-13);
    }
  }
  CHECK(valid > 40);
}

TEST_CASE("bracket of metrics and winds: find_path says that no path in the box is cheaper") {
  Problem problem;
  const AlignedBox2d box = plane(-1.5, -0.95, 3, 0.95);
  problem.manifold = std::make_shared<EuclideanManifold>(
      EuclideanManifoldOptions{2, {Eigen::VectorXd(box.min()), Eigen::VectorXd(box.max())}});
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = Vector2d(2, -0.8);
  problem.target.u = Vector2d(0, 0.6);
  FindOptions options;
  options.points = 60;
  options.post_processors = {std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = 1e-3})};
  for (const auto& cost : {wind("1", "-0.5 * y", "0"), metric_of("1 + y^2", "0.3 * y", "2")}) {
    problem.cost = cost;
    const Result result = find_path(problem, StraightInitializer(), Newton(), options);
    REQUIRE(result.certificate.global);
    CHECK(result.certificate.scope == Scope::global);
    CHECK(result.certificate.global->outcome == ProofOutcome::proved);
    CHECK(result.certificate.global->category == BoundCategory::proved);
    CHECK(result.certificate.global->lower_bound <= result.certificate.global->grid.value().upper);
  }
}

}  // namespace leastcost::test
