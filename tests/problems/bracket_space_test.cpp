// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/bracket/search/bracket.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/post_processors/bracket.hpp>
#include <leastcost/solvers/newton.hpp>
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

/// How deep a place lies in balls and cubes that come as near to the flow of a planted medium as they can, their
/// centres a little beside it: of cubes, at least.
class BesideFlow {
 public:
  BesideFlow(const PlantedSpace& medium, Random& random) {
    constexpr double kApart = 1e-9;
    const double size = medium.box.sizes().minCoeff();
    for (int k = 0; k < 4; ++k) {
      const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(medium.flow.size()) - 1));
      const Vector3d center =
          medium.flow[at] +
          size * random.uniform(0.1, 0.3) * Vector3d(random.normal(), random.normal(), random.normal()).normalized();
      const bool round = k % 2 == 0;
      double reach = kEndless;
      for (const Vector3d& x : medium.flow) reach = std::min(reach, distance(x - center, round));
      obstacles_.push_back({center, reach * (1 - kApart) - medium.flow_step(), round});
    }
  }
  double operator()(const Vector3d& x) const {
    double deepest = -kEndless;
    for (const Taken& o : obstacles_) deepest = std::max(deepest, o.reach - distance(x - o.center, o.round));
    return deepest;
  }

 private:
  struct Taken {
    Vector3d center;
    double reach;
    bool round;
  };
  static double distance(const Vector3d& d, bool round) { return round ? d.norm() : d.cwiseAbs().maxCoeff(); }
  std::vector<Taken> obstacles_;
};

}  // namespace

/// A bound above a true least cost is the worst defect. LEASTCOST_BRACKET_PROBLEMS sets another number of them. Every
/// third is among obstacles that touch the flow, nearly.
TEST_CASE("bracket in space: never above a planted least cost") {
  Random random;
  const int count = space_problems(6);
  std::vector<double> gaps, gaps_among;
  for (int k = 0; k < count; ++k) {
    CAPTURE(k);
    const PlantedSpace medium = PlantedSpace::random(random);
    const std::shared_ptr<const SpaceDensity> density = space_density_of(medium.cost());
    const double truth = medium.least_cost();
    SpaceBracketOptions options{
        .tolerance = 1e-12, .cells = random.integer(12, 18), .max_cells = k % 4 == 0 ? 72 : 36, .max_searched = 2e5};
    const bool among = k % 3 == 2;
    if (among) options.depth = BesideFlow(medium, random);
    const SpaceBracket bracket =
        bracket_least_cost(*density, medium.box, medium.source, medium.target,
                           among || k % 2 == 0 ? truth * (1 + random.uniform(1e-6, 1e-3)) : kEndless, options);
    REQUIRE(bracket.lower <= truth * (1 + kOfPlantedSpace));
    REQUIRE(bracket.upper >= truth * (1 - kOfPlantedSpace));
    if (!bracket.potential) continue;
    CHECK(worst_slope(*bracket.potential, *density, medium.box, 2000, random) <= 1 + 1e-11);
    (among ? gaps_among : gaps).push_back(1 - bracket.lower / truth);
  }
  std::sort(gaps.begin(), gaps.end());
  std::sort(gaps_among.begin(), gaps_among.end());
  REQUIRE(static_cast<int>(gaps.size()) >= count / 3);
  CHECK(gaps[gaps.size() / 2] < 0.03);
  if (count < 100) return;
  for (const std::vector<double>* all : {&gaps, &gaps_among})
    WARN(all->size() << " of " << count << (all == &gaps ? " bounded in the open" : " bounded among obstacles")
                     << "; gap: median " << (*all)[all->size() / 2] << ", 90 % " << (*all)[all->size() * 9 / 10]
                     << ", largest " << all->back());
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
TEST_CASE("bracket in space: media with known least costs", "[slow]") {
  struct Case {
    const char* density;
    Vector3d source, target;
    AlignedBox3d box;
    double cost, gap;
  };
  std::vector<Case> cases = {
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
  if (space_problems(2) < 100) cases.resize(2);  // the others take some seconds each
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

TEST_CASE("bracket in space: find_path says that no path in the box is cheaper", "[slow]") {
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

/// Two corners of a bar across the box, on either side of it.
TEST_CASE("bracket in space: from the dearer side of a bar the shorter way is delivered", "[slow]") {
  constexpr double kClearance = 0.1;
  const AlignedBox3d box(Vector3d(-1.4, -1.4, -0.6), Vector3d(1.4, 1.4, 0.6));
  Problem problem = in_space(box, make_euclidean_cost(3), {-1, 0, 0}, {1, 0, 0});
  problem.manifold = std::make_shared<FreeSpace>(
      problem.manifold,
      FreeSpace::Obstacles{make_box_obstacle({.lower = Vector3d(-0.6, -0.3, -9), .upper = Vector3d(0.6, 0.5, 9)})},
      kClearance);
  Points above(3, 1);
  above.col(0) << 0, 1, 0;
  FindOptions coarse;
  coarse.post_processors = {
      std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = 0.08, .max_windows = 150000})};
  const Result result = find_path(problem, WaypointsInitializer(above), Newton(), coarse);
  const double far = 0.5, turn = std::atan(0.3 / 0.4) + std::asin(kClearance / far);
  const double least = 2 * (std::sqrt(far * far - kClearance * kClearance) + kClearance * turn + 0.6);
  CHECK(result.curve.x.row(1).minCoeff() < -0.35);
  CHECK(result.curve.cost >= least);
  CHECK(result.curve.cost < 1.01 * least);
  CHECK(result.certificate.global.value().lower_bound <= least);
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
