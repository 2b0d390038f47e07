// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/newton/cascade.hpp"

#include <numbers>

#include "tests/support/catch.hpp"
#include "tests/support/chute_chain.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost::test {
namespace {

struct Run {
  CoordinatePath path;
  double s0;
};

Run start(Problem problem, int points) {
  CoordinatePath path = sample_equally(problem, StraightInitializer().first_path(problem, {}).path, points);
  const double s0 = PathEnergy(problem, 1).cost(path) / static_cast<double>(path.segment_count());
  return {path, s0};
}

}  // namespace

TEST_CASE("cascade: the path of a direct solve, for any number of points", "[framework]") {
  const int points = GENERATE(1, 16, 31, 62, 100, 255);
  Problem problem = bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(std::numbers::pi, -2));
  Run run = start(problem, points);
  const SolveReport report = solve_by_cascade(problem, Newton(), run.s0, run.path, {}).report;
  CAPTURE(points, word_of(report.termination));
  CHECK(report.termination == Termination::converged);
  CHECK(run.path.u.cols() == points + 2);
  CHECK((run.path.u.col(0) == problem.source.u && run.path.u.rightCols(1) == problem.target.u));
  CHECK(PathEnergy(problem, 1).cost(run.path) ==
        Approx(chute_chain_time(std::numbers::pi, 2, 1, points + 1)).epsilon(1e-9));
  CHECK(spread(PathEnergy(problem, 1).costs(run.path)) < 1e-6);
  CHECK(report.history.size() >= static_cast<std::size_t>(report.iterations));
}

TEST_CASE("cascade: a few Newton steps per doubling", "[framework]") {
  Problem problem = bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(std::numbers::pi, -2), 1, 0, TravelTimeRule::chute,
                         make_kernel<Square>());
  Run coarse = start(problem, 15), fine = start(problem, 1023);
  const int first = solve_by_cascade(problem, Newton(), coarse.s0, coarse.path, {}).report.iterations;
  const int all = solve_by_cascade(problem, Newton(), fine.s0, fine.path, {}).report.iterations;
  CAPTURE(first, all);
  CHECK(all - first <= 6 * 5);  // six doublings; a prototype took 3 each
}

TEST_CASE("cascade: a stop request leaves a path of the size that was asked for, no worse", "[framework]") {
  const int allowed = GENERATE(0, 3, 12, 20);
  Problem problem = between(std::make_shared<Sphere>(), make_euclidean_cost(3), Eigen::Vector3d(1, 0, 0),
                            Eigen::Vector3d(-0.6, 0.8, 0));
  Run run = start(problem, 200);
  const double before = PathEnergy(problem, run.s0).value(run.path);
  int asked = 0;
  Monitor monitor;
  monitor.stop_requested = [&] { return ++asked > allowed; };
  solve_by_cascade(problem, Newton(), run.s0, run.path, monitor);
  CHECK(run.path.u.cols() == 202);
  CHECK(PathEnergy(problem, run.s0).value(run.path) <= before);
  CHECK(problem.manifold->residual(run.path) < 1e-14);
}

}  // namespace leastcost::test
