// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

using namespace std::chrono_literals;

/// Dearer away from y = 0. Counts its moves, so that work is measured, not time: a busy machine does less of it in the
/// millisecond between two questions.
struct CountedCost {
  static constexpr int dim = 2;
  std::shared_ptr<long> moves;
  CostTraits traits() const { return {}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    ++*moves;
    const S y = 0.5 * (a[1] + b[1]);
    return (b - a).squaredNorm() * (1.0 + y * y);
  }
};

Problem counted(const std::shared_ptr<long>& moves) {
  return between(space(2), make_segment_cost(CountedCost{moves}), Eigen::Vector2d(0, 1), Eigen::Vector2d(3, 1));
}

}  // namespace

TEST_CASE("limit: what hears nothing ends nothing, and a time alone is a time", "[framework]") {
  CHECK_FALSE(Deadline());
  CHECK_NOTHROW(look_at_clock(Deadline()));
  const Deadline past = Deadline::Clock::now() - 1s;
  CHECK(past);
  CHECK(past.has_ended());
  CHECK_THROWS_WITH(look_at_clock(past), "the time budget is used up");
  Monitor monitor;
  CHECK_FALSE(monitor.limit());
  monitor.deadline = past;
  CHECK(*monitor.limit() == *past);
  monitor.deadline = {};
  CHECK_FALSE(monitor.out_of_time());
}

TEST_CASE("limit: a stop is heard within milliseconds, and asked for about once in each", "[framework]") {
  int asked = 0;
  bool stop = false;
  Monitor monitor;
  monitor.stop_requested = [&] { return ++asked, stop; };
  const Deadline limit = monitor.limit();
  CHECK(limit);
  CHECK_FALSE(limit.time());
  for (int i = 0; i < 100'000; ++i) look_at_clock(limit);
  const auto begin = Deadline::Clock::now();
  while (Deadline::Clock::now() < begin + 10ms) look_at_clock(limit);
  CHECK(asked >= 1);
  CHECK(asked < 1000);
  stop = true;
  std::this_thread::sleep_for(2ms);
  CHECK_THROWS_WITH(look_at_clock(limit), "a stop was requested");
  CHECK_FALSE(monitor.out_of_time());

  monitor.deadline = Deadline::Clock::now() - 1s;
  CHECK_THROWS_WITH(look_at_clock(monitor.limit()), "the time budget is used up");
  const Deadline other = Deadline::Clock::now() + 1h;
  CHECK(limit.or_time_of(other).time() == other.time());
  CHECK(monitor.limit().or_time_of(other).time() == monitor.deadline.time());
}

TEST_CASE("stop: a solver hears it within a pass over 400,000 points", "[framework][slow_sanitized]") {
  constexpr int kPoints = 400'000;
  const auto moves = std::make_shared<long>(0);
  const Problem problem = counted(moves);
  CoordinatePath path = sample_evenly(problem, StraightInitializer().first_path(problem, {}).path, kPoints);
  const CoordinatePath start = path;
  PathEnergy energy(problem, 1e-5, Deadline::Clock::now() + 1h);
  const long before = *moves;
  Monitor monitor;
  monitor.stop_requested = [&] { return *moves > before + kPoints; };  // beyond the first value of the energy
  const SolveReport report = Newton().solve(energy, path, monitor);
  CHECK(report.termination == Termination::cancelled);
  CHECK(*moves > before + kPoints);
  CHECK(*moves < before + 2 * kPoints);
  CHECK(path.u == start.u);
  CHECK(energy.deadline().time());  // its own again
  monitor.stop_requested = {};
  energy.set_deadline(Deadline::Clock::now() - 1s);
  CHECK(Newton().solve(energy, path, monitor).termination == Termination::time_limit);
}

TEST_CASE("stop: in the midst of a pass of any stage, the path by then is delivered", "[framework][slow_sanitized]") {
  constexpr int kPoints = 30'000;
  const Stage when = GENERATE(Stage::solve, Stage::certify);
  CAPTURE(word_of(when));
  const auto moves = std::make_shared<long>(0);
  long heard = 0, begun = 0;
  bool reached = false;
  Monitor monitor;
  monitor.observe = [&](const Progress& progress) {
    if (progress.stage != when || reached) return;
    reached = true;
    begun = *moves;
  };
  monitor.stop_requested = [&] {
    if (!reached || *moves < begun + kPoints / 2) return false;
    if (heard == 0) heard = *moves;
    return true;
  };
  FindOptions options;
  options.points = kPoints;
  const Result result = find_path(counted(moves), StraightInitializer(), Newton(), options, monitor);
  CHECK(heard > 0);
  CHECK(heard < begun + 3 * kPoints);
  CHECK(result.status == Status::interrupted);
  CHECK(result.path.u.cols() == kPoints + 2);
  CHECK(result.post_processed);
  CHECK(std::isfinite(result.curve.cost));
  CHECK(result.curve.cost <= result.initial_cost * (1 + 1e-12));
  CHECK_FALSE(result.certificate.certified());
  if (when == Stage::solve)
    CHECK(result.solve.termination == Termination::cancelled);
  else
    CHECK(result.curve.cost < 0.99 * result.initial_cost);
}

}  // namespace leastcost::test
