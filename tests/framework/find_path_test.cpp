// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/search/find_path.hpp>

#include <chrono>
#include <limits>
#include <numbers>
#include <set>
#include <thread>
#include <type_traits>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost::test {
namespace {

Problem watched_cycloid() { return bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(std::numbers::pi, -2)); }

/// Its duals lost the place: a constant, so that every path seems stationary.
struct TwoMinds {
  static constexpr int dim = 2;
  CostTraits traits() const { return {}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    const double x = innermost(a[0]) + innermost(b[0]);
    const S q = (b - a).squaredNorm() * (1 + x * x);
    return std::is_same_v<S, double> ? q : S(3.0);
  }
};

Result find_watched(const Problem& problem, const Monitor& monitor, int points = 32) {
  const Newton newton;
  FindOptions options;
  options.points = points > 0 ? std::optional(points) : std::nullopt;
  return find_path(problem, StraightInitializer(), newton, options, monitor);
}

}  // namespace

TEST_CASE("find_path: everything in the result, and consistent", "[framework]") {
  const Problem problem = watched_cycloid();
  const Result r = find_watched(problem, {});
  CHECK(r.status == Status::certified);
  CHECK((r.path.u.cols() == 34 && r.initial.u.cols() == 34 && r.costs.size() == 33));
  CHECK((r.path.u.col(0) == problem.source.u && r.path.u.col(33) == problem.target.u));
  CHECK(r.initial_cost == Approx(PathEnergy(problem, 1).cost(r.initial)).epsilon(1e-14));
  CHECK(r.reference_cost == Approx(r.initial_cost / 33).epsilon(1e-14));
  CHECK(r.curve.cost == Approx(r.costs.sum()).epsilon(1e-14));
  CHECK(r.costs.sum() < r.initial_cost);
  CHECK(r.solve.termination == Termination::converged);
  CHECK((r.seconds.initialize > 0 && r.seconds.solve > 0 && r.seconds.post_process > 0 && r.seconds.certify > 0));
  CHECK((r.certificate.certified() && r.certificate.levels.size() == 3));
}

TEST_CASE("find_path: the observer sees all stages in order, and the iterations", "[framework]") {
  std::vector<Stage> stages;
  int iterations = 0;
  Monitor monitor;
  monitor.observe = [&](const Progress& progress) {
    if (progress.iteration)
      ++iterations;
    else
      stages.push_back(progress.stage);
  };
  const Result r = find_watched(watched_cycloid(), monitor);
  CHECK(stages == std::vector<Stage>{Stage::initialize, Stage::solve, Stage::post_process, Stage::certify});
  CHECK(iterations > r.solve.iterations);
}

TEST_CASE("find_path: a stop request in any stage keeps the best path", "[framework]") {
  const Stage when = GENERATE(Stage::initialize, Stage::solve, Stage::post_process, Stage::certify);
  CAPTURE(word_of(when));
  bool stop = false;
  Monitor monitor;
  monitor.observe = [&](const Progress& progress) { stop = stop || progress.stage == when; };
  monitor.stop_requested = [&] { return stop; };
  const Result r = find_watched(watched_cycloid(), monitor);
  CHECK(r.status == Status::interrupted);
  CHECK_FALSE(r.certificate.certified());
  CHECK(r.path.u.allFinite());
  CHECK(r.costs.sum() <= r.initial_cost * (1 + 1e-14));  // summed in another order where it was not measured anew
  if (when == Stage::certify) CHECK(r.solve.termination == Termination::converged);
}

TEST_CASE("find_path: a stop request in the middle of a solve", "[framework]") {
  int iterations = 0;
  Monitor monitor;
  monitor.observe = [&](const Progress& progress) { iterations += progress.iteration != nullptr ? 1 : 0; };
  monitor.stop_requested = [&] { return iterations > 2; };
  const Result r = find_watched(watched_cycloid(), monitor);
  CHECK(r.status == Status::interrupted);
  CHECK(r.solve.termination == Termination::cancelled);
  CHECK(r.costs.sum() < r.initial_cost);
}

TEST_CASE("find_path: a deadline that has passed costs no further iteration", "[framework]") {
  Monitor monitor;
  monitor.deadline = Monitor::Clock::now();
  const Result r = find_watched(watched_cycloid(), monitor, 2000);
  CHECK(r.status == Status::interrupted);
  CHECK(r.solve.iterations == 0);
  CHECK(r.path.u.size() == 0);  // not even sampled
  CHECK_FALSE(r.notes.empty());
  CHECK(std::isnan(r.certificate.estimate.error));
}

TEST_CASE("find_path: several threads give bitwise the same result", "[framework]") {
  const Problem problem = watched_cycloid();  // one problem, shared
  const Result alone = find_watched(problem, {});
  std::vector<Result> results(4);
  std::vector<std::thread> threads;
  for (Result& result : results) threads.emplace_back([&] { result = find_watched(problem, {}); });
  for (std::thread& thread : threads) thread.join();
  for (const Result& r : results) {
    CHECK(r.path.u == alone.path.u);
    CHECK(r.certificate.estimate.value == alone.certificate.estimate.value);
    CHECK(r.certificate.estimate.error == alone.certificate.estimate.error);
    CHECK(r.solve.iterations == alone.solve.iterations);
  }
}

TEST_CASE("find_path: questions that cannot be asked are errors", "[framework]") {
  const auto ask = [](const Eigen::VectorXd& source, const Eigen::VectorXd& target, int cost_dimension) {
    Problem problem{space(2), make_euclidean_cost(cost_dimension), make_kernel<Square>(), {source}, {target}, false};
    find_watched(problem, {});
  };
  const Eigen::Vector2d a(0, 0), b(1, 2);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  CHECK_NOTHROW(ask(a, b, 2));
  CHECK_THROWS_WITH(ask(a, a, 2), Catch::Contains("coincide"));
  CHECK_THROWS_AS(ask(a, Eigen::Vector3d(1, 2, 3), 2), InputError);
  CHECK_THROWS_AS(ask(Eigen::VectorXd(), b, 2), InputError);
  CHECK_THROWS_AS(ask(Eigen::Vector2d(nan, 0), b, 2), InputError);
  CHECK_THROWS_AS(ask(a, Eigen::Vector2d(inf, 0), 2), InputError);
  CHECK_THROWS_AS(ask(a, b, 3), InputError);
  CHECK_THROWS_AS(find_watched(Problem{}, {}), InputError);
  CHECK_THROWS_AS(project_end(*space(2), Eigen::Vector3d(1, 2, 3)), InputError);
  CHECK_THROWS_AS(project_end(*space(2), Eigen::Vector2d(nan, 1)), InputError);
}

TEST_CASE("find_path: points: auto needs a graph, and a straight line cannot close a ring", "[framework]") {
  CHECK_THROWS_WITH(find_watched(watched_cycloid(), {}, 0), Catch::Contains("graph"));
  CHECK_THROWS_AS(find_watched(closed(space(2), make_euclidean_cost(2)), {}), InitializationError);
}

TEST_CASE("find_path: a bead cannot reach what lies above its level", "[framework]") {
  CHECK_THROWS_AS(find_watched(bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(2, 1)), {}), InitializationError);
  // Level ends: only a bow below the straight line has a finite time.
  const Result level = find_watched(bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(2, 0)), {});
  CHECK(level.costs.allFinite());
  CHECK(level.costs.sum() == Approx(2 * std::sqrt(std::numbers::pi)).epsilon(0.01));  // a whole cycloid, k = 1 / pi
}

TEST_CASE("find_path: a first path through points without a nearest one is an error, not a NaN", "[framework]") {
  const int points = GENERATE(1, 15);  // the middle of the chord between antipodes is the centre of the sphere
  const Problem problem =
      between(std::make_shared<Sphere>(), make_euclidean_cost(3), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 0, 0));
  CHECK_THROWS_AS(find_watched(problem, {}, points), InitializationError);
  CHECK_THROWS_WITH(find_watched(problem, {}, points), Catch::Contains("nearest point"));
}

TEST_CASE("find_path: one free point", "[framework]") {
  const Result r = find_watched(watched_cycloid(), {}, 1);
  CHECK(r.path.u.cols() == 3);
  CHECK(spread(r.costs) < 1e-6);
  CHECK(r.costs.sum() > std::numbers::pi);
}

TEST_CASE("find_path: without a certificate nothing is certified", "[framework]") {
  const Newton newton;
  FindOptions options;
  options.certificate.enabled = false;
  const Result r = find_path(watched_cycloid(), StraightInitializer(), newton, options);
  CHECK(r.status == Status::uncertified);
  CHECK_FALSE(r.certificate.measured);
}

TEST_CASE("find_path: a cost whose values and gradients are of two functions does not converge", "[framework]") {
  const Problem problem =
      between(space(2), make_segment_cost(TwoMinds{}), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 2));
  const Newton newton;
  const Lbfgs lbfgs;
  for (const Solver* solver : {static_cast<const Solver*>(&newton), static_cast<const Solver*>(&lbfgs)}) {
    const Result r = find_path(problem, StraightInitializer(), *solver, {.points = 8});
    CAPTURE(solver->name(), r.solve.message);
    CHECK(r.solve.termination == Termination::inconsistent);
    CHECK_THAT(r.solve.message, Catch::Contains("the cost is inconsistent"));
    CHECK(r.status == Status::uncertified);
    CHECK(failed(r.certificate, "inconsistent"));
  }
}

TEST_CASE("names of statuses, stages and terminations are distinct words", "[framework]") {
  std::set<std::string_view> names;
  for (int i = 0; i < 4; ++i) names.insert(word_of(static_cast<Status>(i)));
  for (int i = 0; i < 4; ++i) names.insert(word_of(static_cast<Stage>(i)));
  CHECK(names.size() == 8);
  names.clear();
  for (int i = 0; i < 13; ++i) names.insert(word_of(static_cast<Termination>(i)));
  CHECK((names.size() == 13 && names.count("") == 0));
}

}  // namespace leastcost::test
