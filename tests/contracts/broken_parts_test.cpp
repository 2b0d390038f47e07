// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Parts of a user's own that break their contracts: nothing of it is believed, nothing of it ends the host.
#include <cmath>
#include <functional>
#include <limits>
#include <new>
#include <numbers>
#include <stdexcept>

#include <leastcost/leastcost.hpp>
#include "tests/problems/sample_clouds.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

Problem plane() {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{});
  problem.cost = make_euclidean_cost(2);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = Eigen::Vector2d(0, 0);
  problem.target.u = Eigen::Vector2d(1, 1);
  return problem;
}

class Vandal final : public Solver {
 public:
  explicit Vandal(std::function<void(CoordinatePath&)> deed) : deed_(std::move(deed)) {}
  std::string_view name() const override { return "vandal"; }

 protected:
  SolveReport do_solve(PathEnergy&, CoordinatePath& path, const Monitor&) const override {
    deed_(path);
    SolveReport report;
    report.termination = Termination::converged;
    return report;
  }

 private:
  std::function<void(CoordinatePath&)> deed_;
};

class Botch final : public PostProcessor {
 public:
  explicit Botch(std::function<void(PostProcessed&)> deed) : deed_(std::move(deed)) {}
  std::string_view name() const override { return "botch"; }
  PostProcessed apply(const Problem&, const FirstPath&, PostProcessed path, const Monitor&) const override {
    deed_(path);
    return path;
  }

 private:
  std::function<void(PostProcessed&)> deed_;
};

/// Throws from its `calls`-th value on.
struct LateThrow {
  static constexpr int dim = 2;
  std::shared_ptr<long> calls;
  CostTraits traits() const { return {}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    if (--*calls < 0) throw std::runtime_error("late boom");
    return (b - a).squaredNorm();
  }
};

}  // namespace

TEST_CASE("a solver that returns another path than it was given leaves the path as it was, uncertified") {
  const std::vector<std::function<void(CoordinatePath&)>> deeds = {
      [](CoordinatePath& p) { p.u.resize(0, 0); },
      [](CoordinatePath& p) { p.u = Points::Zero(2, 1); },
      [](CoordinatePath& p) { p.u.conservativeResize(2, 5); },
      [](CoordinatePath& p) { p.u = Points::Zero(5, p.u.cols()); },
      [](CoordinatePath& p) { p.u.conservativeResize(2, 2); },
      [](CoordinatePath& p) { p.u(0, 3) = std::numeric_limits<double>::quiet_NaN(); },
      [](CoordinatePath& p) { p.u.rightCols(1).array() += 1; },
      [](CoordinatePath& p) { p.ring = true; },
      [](CoordinatePath& p) {
        p.sites = {1, 2, 3};
      }};
  for (std::size_t i = 0; i < deeds.size(); ++i) {
    INFO("deed " << i);
    const Result result = find_path(plane(), StraightInitializer(), Vandal(deeds[i]), {.points = 10});
    CHECK(result.status == Status::uncertified);
    CHECK(result.solve.termination == Termination::exception);
    CHECK_THAT(result.solve.message, Catch::Contains("the solver"));
    CHECK(result.path.u.cols() == 12);
    CHECK(result.path.u.rightCols(1).isOnes(0));
  }
}

TEST_CASE("a post-processor that returns what is no curve with the points on it, or throws, takes nothing away") {
  const std::vector<std::function<void(PostProcessed&)>> deeds = {
      [](PostProcessed& p) { p = {}; },
      [](PostProcessed& p) { p.chain.u.conservativeResize(2, 3); },
      [](PostProcessed& p) { p.chain.u = Points::Zero(2, 1); },
      [](PostProcessed& p) { p.chain.u.rightCols(1).array() += 1; },
      [](PostProcessed& p) { p.curve_costs.resize(0); },
      [](PostProcessed& p) { p.curve.x.resize(0, 0); },
      [](PostProcessed& p) { p.curve.x = Points::Zero(7, 3); },
      [](PostProcessed& p) { p.chain.u.array() += std::numeric_limits<double>::infinity(); },
      [](PostProcessed&) { throw InputError("dirty data"); },
      [](PostProcessed&) { throw InitializationError("no way"); },
      [](PostProcessed&) { throw std::bad_alloc(); },
      [](PostProcessed&) { throw 7; }};
  for (std::size_t i = 0; i < deeds.size(); ++i) {
    INFO("deed " << i);
    FindOptions options{.points = 10};
    const auto shorten = [](PostProcessed& p) { p.notes.emplace_back("the first step"); };
    options.post_processors = {std::make_shared<const Botch>(shorten), std::make_shared<const Botch>(deeds[i])};
    const Result result = find_path(plane(), StraightInitializer(), Newton(), options);
    CHECK(result.status == Status::uncertified);
    CHECK(result.path.u.cols() == 12);
    CHECK(result.curve.cost == Approx(std::sqrt(2.0)));
    REQUIRE(result.certificate.failures.size() == 1);
    CHECK(result.certificate.failures[0].name() == "post_process");
    const std::string &message = result.certificate.failures[0].message, prefix = "the curve was left unchanged: ";
    CHECK_THAT(message, Catch::StartsWith(prefix));
    CHECK(message.size() >= prefix.size() + 6);  // and why
    CHECK(result.notes == std::vector<std::string>{"the first step"});
  }
}

TEST_CASE("a cost that throws while the path is certified takes nothing away from the path") {
  Problem problem = plane();
  const auto calls = std::make_shared<long>(std::numeric_limits<long>::max());
  problem.cost = make_segment_cost(LateThrow{calls});
  FindOptions options{.points = 20};
  options.certificate.enabled = false;
  find_path(problem, StraightInitializer(), Newton(), options);
  *calls = std::numeric_limits<long>::max() - *calls + 200;  // the work without a certificate, and a little of it
  options.certificate.enabled = true;
  const Result result = find_path(problem, StraightInitializer(), Newton(), options);
  CHECK(result.status == Status::uncertified);
  CHECK(result.path.u.cols() == 22);
  REQUIRE(result.certificate.failures.size() == 1);
  CHECK(result.certificate.failures[0].name() == "exception");
  CHECK_THAT(result.certificate.failures[0].message, Catch::Contains("late boom"));
}

TEST_CASE("an interrupted loop with a fixed point, whose path is open, is completed") {
  Problem problem = plane();
  problem.manifold = make_parametric_manifold({.surface = parametric::Torus{}});
  problem.cost = make_euclidean_cost(3);
  problem.source.u = Eigen::Vector2d(0.3, std::numbers::pi);
  problem.target = {};
  problem.ring = problem.based = true;
  const CoordinateCircleInitializer circle({.through = Eigen::Vector2d(1, 2.9)});
  Result result = find_path(problem, circle, Newton(), {.points = 30});
  REQUIRE_FALSE(result.path.ring);
  const double cost = result.costs.sum();
  result.status = Status::interrupted;
  result.post_processed = false;
  complete_interrupted(problem, {}, result);
  CHECK(result.post_processed);
  CHECK(result.costs.sum() == Approx(cost));
}

TEST_CASE("options that cannot work, and parts that are missing, are errors of the library") {
  CHECK_THROWS_AS(MirroredInitializer(nullptr), InputError);
  CHECK_THROWS_AS(find_family({{"none", plane(), nullptr}}, Newton(), {}), InputError);
  CHECK_THROWS_AS(find_path(plane(), StraightInitializer(), Newton(), {.points = std::numeric_limits<int>::max()}),
                  InputError);
  CHECK_THROWS_AS(make_travel_time_cost({}, 2, Eigen::VectorXd()), InputError);
  CHECK_THROWS_AS(make_travel_time_cost({}, 0, Eigen::VectorXd()), OptionError);
  for (const int turns : {0, -1, 2'000'000'000})
    CHECK_THROWS_AS(CoordinateCircleInitializer({.through = Eigen::Vector2d(0, 0), .turns = turns}), OptionError);
  PointSamples cloud = sphere_cloud(300);
  cloud.positions[3][0] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(PointCloud(cloud, {}), InputError);

  std::mt19937_64 engine(1);
  const PointSampler in_space = sample_box(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones());
  const std::shared_ptr<const SegmentCost> cost = plane().cost;
  CHECK_THROWS_AS(check_cost(*cost, in_space, engine), InputError);
  CHECK_THROWS_AS(check_cost(*cost, {}, engine), InputError);
  CHECK_THROWS_AS(check_manifold(*plane().manifold, in_space, engine), InputError);
  CHECK_THROWS_AS(check_manifold(*plane().manifold, {}, engine), InputError);
  CHECK_THROWS_AS(check_cost_derivatives(*cost, Points::Zero(2, 1), false, engine), InputError);
  CHECK_THROWS_AS(check_cost_derivatives(*cost, Points::Zero(3, 4), false, engine), InputError);
  CHECK_THROWS_AS(move_cost(*cost, Eigen::Vector2d::Zero(), Eigen::Vector3d::Zero()), InputError);

  CHECK_THROWS_AS(Lbfgs({.memory = 0}), OptionError);
  CHECK_THROWS_AS(Vfcs({.memory = -5}), OptionError);
}

}  // namespace leastcost::test
