// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Brackets of costs that are known by their values: planted least costs, closed forms on terrain, black boxes.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/bracket/search/bracket.hpp>
#include <leastcost/problems/costs/walking.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/terrain.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/post_processors/bracket.hpp>
#include <leastcost/solvers/newton.hpp>
#include "problems/bracket/cells/sampled_cone.hpp"
#include "problems/bracket/cells/sampled_norms.hpp"
#include "problems/bracket/cubic_minimum.hpp"
#include "tests/problems/planted_directions.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr double kUnknown = std::numeric_limits<double>::infinity();

std::shared_ptr<const ConstraintManifold> plane() {
  return std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
}

/// Heights at the nodes of a raster of square cells of 10 m from the origin on.
template <class Height>
std::shared_ptr<const TerrainManifold> terrain(int rows, int columns, const Height& height) {
  RasterGrid raster;
  raster.rows = rows;
  raster.columns = columns;
  raster.cell = Vector2d(10, 10);
  raster.source = "made";
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Vector2d place = raster.place(row, column);
      raster.values.push_back(height(place[0], place[1]));
    }
  return std::make_shared<TerrainManifold>(raster);
}

Problem walk_over(std::shared_ptr<const ConstraintManifold> ground, const Vector2d& source, const Vector2d& target) {
  Problem problem;
  problem.manifold = std::move(ground);
  problem.cost = make_walking_cost({}, 3);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = source;
  problem.target.u = target;
  return problem;
}

FindOptions with_bracket(double tolerance, int points = 60) {
  FindOptions options;
  options.points = points;
  options.post_processors = {
      std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = tolerance, .max_windows = 300000})};
  return options;
}

/// The length, by values: nothing else is known of it.
struct Unknown {
  static constexpr int dim = 2;
  CostTraits traits() const { return {}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    const Point<S, 2> d = b - a;
    const S x = 0.5 * (a[0] + b[0]);
    return (1.0 + x * x) * (d[0] * d[0] + d[1] * d[1]);
  }
};

/// The length of moves to the right; there are no others.
struct OneWay {
  static constexpr int dim = 2;
  CostTraits traits() const { return {.symmetric = false}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    const Point<S, 2> d = b - a;
    if (innermost(d[0]) < 0) return S(kUnknown);
    return S(d[0] * d[0] + d[1] * d[1]);
  }
  double line_element(const Eigen::VectorXd&, const Eigen::VectorXd& v) const { return v[0] < 0 ? kUnknown : v.norm(); }
};

}  // namespace

TEST_CASE("sampled bracket: dual norms by values are those in closed form") {
  Random random;
  for (int k = 0; k < trials(200); ++k) {
    const PlantedDirections planted = random.integer(0, 1) == 0
                                          ? PlantedDirections::metric(random, random.uniform(1, 4))
                                          : PlantedDirections::windy(random, 0.9);
    const std::shared_ptr<const SegmentCost> cost = planted.cost();
    const CoordinateCost values(plane(), cost);
    const AlignedBox2d& box = planted.medium.box;
    const Vector2d x = box.min() + box.sizes().cwiseProduct(Vector2d(random.uniform(0, 1), random.uniform(0, 1))),
                   p(random.normal(), random.normal());
    const double exact = dual_of(cost)->dual(x)(p[0], p[1]);
    const CoordinateCost::Element element(values, x);
    CHECK(bracket::dual_norm(element, p, std::atan2(p[1], p[0])) == Approx(exact).epsilon(1e-5));
    CHECK(bracket::dual_norm(element, p, random.uniform(-4, 4)) == Approx(exact).epsilon(1e-5));
    bracket::SampledNorms norms;
    norms.reset(3, bracket::directions_for(values, box));
    norms.learn(1, element);
    CHECK(norms.dual(1, p) == Approx(exact).epsilon(1e-3));
    const Vector2d v = norms.steepest(1, p);
    CHECK(p.dot(v) == Approx(exact).epsilon(1e-3));
    CHECK(element(v) == Approx(1).epsilon(1e-3));
    CHECK_FALSE(norms.knows(0));
    CHECK(std::isnan(norms.dual(0, p)));
  }
}

TEST_CASE("sampled bracket: a cubic's least value between its values") {
  Random random;
  for (int k = 0; k < trials(100); ++k) {
    const double at = random.uniform(1, 2), bend = random.uniform(0.1, 3), twist = random.uniform(-0.1, 0.1) * bend;
    const auto f = [&](double t) { return 3 + (t - at) * (t - at) * (bend + twist * (t - at)); };
    const bracket::CubicMinimum least = bracket::cubic_minimum({f(0), f(1), f(2), f(3)}, 1, 2);
    CHECK(least.at == Approx(at).margin(1e-9));
    CHECK(least.value == Approx(3).epsilon(1e-12));
  }
  CHECK(bracket::cubic_minimum({3, 2, 1, 0}, 1, 2).value == 1);
  CHECK(bracket::cubic_minimum({0, 1, 2, 3}, 1, 2).value == 1);
}

TEST_CASE("sampled bracket: bounds of planted metrics and winds", "[slow]") {
  Random random;
  std::vector<double> gaps;
  for (int k = 0, count = planted_problems(4); k < count; ++k) {
    CAPTURE(k);
    const PlantedDirections planted =
        k % 2 == 0 ? PlantedDirections::metric(random, 2) : PlantedDirections::windy(random, 0.8);
    const AlignedBox2d& box = planted.medium.box;
    const double truth = planted.least_cost();
    const CoordinateCost cost(plane(), planted.cost());
    const Bracket bracket =
        bracket_least_cost(cost, box, planted.medium.source, planted.target, k % 4 < 2 ? truth : kUnknown,
                           {.tolerance = 1e-4, .cells = 48, .max_cells = 192});
    // Sampled: what lies between four places of a cell is not seen.
    CHECK(bracket.lower <= truth * (1 + 1e-4));
    CHECK(bracket.upper >= truth * (1 - 1e-5));
    if (bracket.potential) CHECK(worst_dual(*bracket.potential, *dual_of(planted.cost()), box, random) <= 1 + 0.03);
    gaps.push_back(1 - bracket.lower / truth);
  }
  std::sort(gaps.begin(), gaps.end());
  CHECK(gaps[gaps.size() / 2] < 2e-3);
  if (gaps.size() > 100)
    WARN("gap: least " << gaps.front() << ", median " << gaps[gaps.size() / 2] << ", 90 % "
                       << gaps[gaps.size() * 9 / 10] << ", largest " << gaps.back());
}

TEST_CASE("sampled bracket: the cone around an end is below all costs from it") {
  Random random;
  for (int k = 0; k < trials(20); ++k) {
    const PlantedDirections planted = PlantedDirections::metric(random, 2);
    const AlignedBox2d& box = planted.medium.box;
    const CoordinateCost cost(plane(), planted.cost());
    const Vector2d end = planted.medium.source;
    const double reach = 0.03 * box.sizes().minCoeff();
    const auto cone = bracket::sampled_cone(cost, box, end, reach, k % 2 == 1);
    REQUIRE(cone);
    CHECK(cone->factor > 0.9);
    for (int i = 0; i < 20; ++i) {
      const double angle = random.uniform(0, 6.3);
      const Vector2d d = reach * random.uniform(0.1, 1) * Vector2d(std::cos(angle), std::sin(angle));
      Eigen::Matrix2Xd move(2, 2);
      move << end, end + d;
      if (k % 2 == 1) move.col(0).swap(move.col(1));
      CHECK(std::min(cone->value(d), cone->most) <= polyline_cost(cost, move));
    }
  }
}

TEST_CASE("sampled bracket: walking straight over a plane slope", "[slow_sanitized]") {
  const double slope = 0.2;
  const auto ground = terrain(31, 31, [&](double x, double) { return slope * x; });
  for (const bool up : {true, false}) {
    const Vector2d low(60, 100), high(230, 180);
    const Result result = find_path(walk_over(ground, up ? low : high, up ? high : low), StraightInitializer(),
                                    Newton(), with_bracket(3e-3));
    // Tobler's law; the kink at -0.05 is far away.
    const double map = (high - low).norm() / 1000,
                 steepness = (up ? 1 : -1) * slope * (high - low)[0] / (high - low).norm();
    const double hours = map * std::exp(3.5 * std::abs(steepness + 0.05)) / 6;
    const GlobalBound& bound = result.certificate.global.value();
    CHECK(bound.category == BoundCategory::sampled);
    CHECK(bound.outcome == ProofOutcome::sampled);
    CHECK_FALSE(bound.proved);
    CHECK(result.certificate.scope == Scope::local);
    CHECK(bound.lower_bound <= hours * (1 + 1e-6));
    CHECK(bound.lower_bound >= hours * (1 - 3e-3));
    CHECK(bound.grid.value().upper == Approx(hours).epsilon(1e-6));
  }
}

TEST_CASE("sampled bracket: from one side of a hill to the quicker way round it", "[slow_sanitized]") {
  // A hill, and a lower one in its north: straight, the path slips to the north; the quicker way is in the south.
  const auto ground = terrain(61, 61, [](double x, double y) {
    const auto hill = [&](double north) {
      return std::exp(-((x - 300) * (x - 300) + (y - north) * (y - north)) / 9000);
    };
    return 70 * hill(290) + 25 * hill(430);
  });
  const Problem problem = walk_over(ground, Vector2d(80, 300), Vector2d(520, 300));
  FindOptions options = with_bracket(0.02);
  const Result result = find_path(problem, StraightInitializer(), Newton(), options);
  const GlobalBound& bound = result.certificate.global.value();
  CHECK(result.curve.x.row(1).minCoeff() < 250);
  CHECK(bound.lower_bound <= bound.grid.value().upper);
  CHECK(bound.gap < 0.02);
  options.post_processors.clear();
  const Result north = find_path(problem, StraightInitializer(), Newton(), options);
  CHECK(north.curve.x.row(1).maxCoeff() > 350);
  CHECK(north.curve.cost > 1.005 * result.curve.cost);
}

TEST_CASE("sampled bracket: ground with a hole", "[.slow]") {
  const auto ground = terrain(41, 41, [](double x, double y) {
    const bool hole = std::abs(x - 200) < 45 && std::abs(y - 190) < 45;
    return hole ? std::numeric_limits<double>::quiet_NaN() : 20 * std::sin(x / 90) + 15 * std::cos(y / 70);
  });
  const Problem problem = walk_over(ground, Vector2d(60, 280), Vector2d(340, 280));
  const Result result = find_path(problem, StraightInitializer(), Newton(), with_bracket(0.02));
  const GlobalBound& bound = result.certificate.global.value();
  CHECK(bound.category == BoundCategory::sampled);
  CHECK(bound.lower_bound <= result.curve.cost);
  CHECK(bound.gap < 0.02);
}

TEST_CASE("sampled bracket: a black box, and what nothing is known of at an end") {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{
      .dimension = 2, .box = {.lower = Eigen::VectorXd(Vector2d(-2, -2)), .upper = Eigen::VectorXd(Vector2d(2, 2))}});
  problem.cost = make_segment_cost(Unknown{});
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = Vector2d(-1, -0.4);
  problem.target.u = Vector2d(1.2, 0.5);
  const Result result = find_path(problem, StraightInitializer(), Newton(), with_bracket(1e-3));
  const GlobalBound& bound = result.certificate.global.value();
  CHECK(bound.outcome == ProofOutcome::sampled);
  CHECK(bound.lower_bound <= result.certificate.estimate.value * (1 + 1e-6));
  CHECK(bound.gap < 1e-3);
  problem.cost = make_segment_cost(OneWay{});
  const Result one_way = find_path(problem, StraightInitializer(), Newton(), with_bracket(1e-3));
  CHECK(one_way.certificate.global.value().outcome == ProofOutcome::blocked);
  CHECK_THAT(one_way.certificate.global.value().reason, Catch::Contains("near the source"));
}

}  // namespace leastcost::test
