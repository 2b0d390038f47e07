// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/study/profiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/report/study/study_analysis.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {

using namespace app;

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// The value of a step function.
double value_at(const Profile& profile, double x) {
  double value = 0;
  for (std::size_t i = 0; i < profile.at.size() && profile.at[i] <= x; ++i) value = profile.share[i];
  return value;
}

RunRow row(long cell, long repetition, const std::string& solver, double final_energy,
           const std::string& status = "certified") {
  RunRow r;
  r.cell = cell;
  r.repetition = repetition;
  r.problem = "p";
  r.solver = solver;
  r.kernel = "square";
  r.points = 10;
  r.seed = 1;
  r.outcome = outcome::kOk;
  r.status = status;
  r.termination = "converged";
  r.iterations = 2;
  r.evaluations = 5;
  r.s_solve = 0.01 * static_cast<double>(repetition + 1);
  r.final_energy = final_energy;
  r.energy_slope = 100;
  r.cost = 2;
  r.cost_error_bar = 1e-6;
  r.chain_cost = 1.999;
  r.optimum = 2;
  r.optimum_error = 1e-7;
  return r;
}

TraceRow trace(long cell, long repetition, long iteration, long evaluations, double seconds, double energy) {
  TraceRow t;
  t.cell = cell;
  t.repetition = repetition;
  t.iteration = iteration;
  t.evaluations = evaluations;
  t.seconds = seconds;
  t.energy = energy;
  return t;
}

}  // namespace

// Three solvers on four problems. Ratios by hand: A 1, 2, 1, -; B 2, 1, -, -; C 4, 1, 3, -.
TEST_CASE("profiles: Dolan and More on a table done by hand") {
  const WorkTable work = {{1, 2, 4}, {10, 5, 5}, {3, kNever, 9}, {kNever, kNever, kNever}};
  const std::vector<Profile> p = performance_profiles(work);
  REQUIRE(p.size() == 3);
  CHECK(value_at(p[0], 1) == 0.5);  // best on two of four; the problem that nobody solves counts
  CHECK(value_at(p[1], 1) == 0.25);
  CHECK(value_at(p[2], 1) == 0.25);  // a tie: both are best
  CHECK(value_at(p[0], 1.999) == 0.5);
  CHECK(value_at(p[0], 2) == 0.75);
  CHECK(value_at(p[1], 1e9) == 0.5);
  CHECK(value_at(p[2], 3) == 0.5);
  CHECK(value_at(p[2], 4) == 0.75);
  for (const Profile& profile : p) CHECK(std::is_sorted(profile.at.begin(), profile.at.end()));
}

TEST_CASE("profiles: units of work do not matter to performance profiles") {
  const WorkTable seconds = {{1, 3}, {2, 1}}, hours = {{1 / 3600.0, 3 / 3600.0}, {2 / 3600.0, 1 / 3600.0}};
  const auto a = performance_profiles(seconds), b = performance_profiles(hours);
  for (std::size_t s = 0; s < 2; ++s)
    for (const double x : {1.0, 1.5, 2.1, 3.1}) CHECK(value_at(a[s], x) == value_at(b[s], x));
}

// More and Wild: d(alpha) = share of problems with t / (n + 1) <= alpha. Here n = 1, 4, 9.
TEST_CASE("profiles: More and Wild on a table done by hand") {
  const WorkTable work = {{4, 20}, {10, 5}, {kNever, 100}};
  const std::vector<Profile> p = data_profiles(work, {2, 5, 10});
  CHECK(value_at(p[0], 1.9) == 0);
  CHECK(value_at(p[0], 2) == Approx(2.0 / 3));  // 4 / 2 and 10 / 5
  CHECK(value_at(p[0], 1e9) == Approx(2.0 / 3));
  CHECK(value_at(p[1], 1) == Approx(1.0 / 3));
  CHECK(value_at(p[1], 9.9) == Approx(1.0 / 3));
  CHECK(value_at(p[1], 10) == 1);
}

TEST_CASE("profiles: nothing to compare is no error") {
  CHECK(performance_profiles({}).empty());
  CHECK(data_profiles({}, {}).empty());
  CHECK(performance_profiles({{kNever}})[0].at.empty());
}

TEST_CASE("profiles: slopes of power laws, with a floor of rounding") {
  std::vector<double> n, error;
  for (const double x : {20.0, 40.0, 80.0, 160.0, 320.0}) {
    n.push_back(x);
    error.push_back(7 * std::pow(x, -4));
  }
  CHECK(*log_log_slope(n, error) == Approx(-4));
  n.push_back(1e6);
  error.push_back(1e-16);  // rounding
  CHECK(*log_log_slope(n, error, 1e-14) == Approx(-4));
  n.push_back(1e7);
  error.push_back(0);
  CHECK(*log_log_slope(n, error, 1e-14) == Approx(-4));
  CHECK_FALSE(log_log_slope({10, 20}, {0, 1}));
  CHECK_FALSE(log_log_slope({10, 10}, {1, 2}));
}

TEST_CASE("profiles: work to a tolerance is that of the first time") {
  CHECK(work_to_reach({1, 3, 5}, {1e-2, 1e-11, 1e-3}, 1e-10) == 3);
  CHECK(work_to_reach({1, 3, 5}, {1e-2, 1e-5, 1e-9}, 1e-10) == kNever);
  CHECK(work_to_reach({1}, {std::nan("")}, 1e-10) == kNever);
  CHECK(work_to_reach({}, {}, 1) == kNever);
}

TEST_CASE("study analysis: the best chain of a group, other minima, failures, and what was not tried") {
  RunTable runs;
  runs.rows = {row(0, 0, "a", 50), row(1, 0, "b", 50 + 1e-9), row(2, 0, "c", 51), row(3, 0, "d", 50.5, "uncertified"),
               row(4, 0, "e", 0)};
  runs.rows[2].cost = 2.02;
  runs.rows[4].outcome = outcome::kTimeout;
  runs.rows[4].message = "after 10 s";
  runs.rows[4].final_energy.reset();
  runs.rows.push_back(row(5, 0, "a", 70));
  runs.rows.back().points = 20;
  const StudyAnalysis study = analyse(runs, {});
  REQUIRE(study.groups.size() == 2);
  CHECK(study.solvers == std::vector<std::string>{"a", "b", "c", "d", "e"});
  const Group& group = study.groups[0];
  CHECK(group.label == "p, n\u00a0=\u00a010");
  CHECK(group.tasks[0].verdict == Verdict::certified);
  CHECK(group.tasks[1].verdict == Verdict::certified);
  CHECK(group.tasks[1].excess == Approx(1e-11).epsilon(1e-3));
  CHECK(group.tasks[2].verdict == Verdict::other_minimum);  // a hundredth above, though certified
  CHECK(group.tasks[3].verdict == Verdict::uncertified);
  CHECK(group.tasks[4].verdict == Verdict::failed);
  CHECK(group.tasks[4].reason == "timeout: after 10 s");
  CHECK(group.tasks[0].bar == Approx(5e-7));
  CHECK(group.tasks[0].chain_error == Approx(5e-4));
  CHECK(study.groups[1].tasks[0].verdict == Verdict::certified);
  CHECK(study.groups[1].tasks[1].verdict == Verdict::absent);
}

TEST_CASE("study analysis: work to a tolerance from the trace, medians over repetitions") {
  RunTable runs;
  std::vector<TraceRow> traces;
  for (long repetition = 0; repetition < 3; ++repetition) {
    runs.rows.push_back(row(0, repetition, "a", 50));
    const double slowness = std::vector<double>{3, 1, 2}[static_cast<std::size_t>(repetition)];
    traces.push_back(trace(0, repetition, 0, 1, 0.1 * slowness, 90));
    traces.push_back(trace(0, repetition, 1, 4, 0.2 * slowness, 50 + 1e-9));  // an excess of 1e-11
    traces.push_back(trace(0, repetition, 2, 5, 0.3 * slowness, 50));
  }
  const StudyAnalysis study = analyse(runs, traces);
  CHECK(study.groups[0].tasks[0].seconds.median == Approx(0.02));
  CHECK(study.groups[0].tasks[0].seconds.greatest == Approx(0.03));
  CHECK(work_table(study, Work::evaluations, 1e-10)[0][0] == 4);
  CHECK(work_table(study, Work::seconds, 1e-10)[0][0] == Approx(0.4));
  CHECK(work_table(study, Work::evaluations, 1e-12)[0][0] == 5);
}

TEST_CASE("study analysis: a method that traces a functional of its own counts by its end") {
  RunTable runs;
  runs.rows = {row(0, 0, "energy", 50), row(1, 0, "own", 50), row(2, 0, "own, elsewhere", 80)};
  runs.rows[1].iterations = 7;
  runs.rows[2].cost = 3;
  // Far below any energy there is: by the letter solved before it began.
  const std::vector<TraceRow> traces = {trace(0, 0, 0, 1, 0.1, 90), trace(0, 0, 1, 3, 0.2, 50),
                                        trace(1, 0, 0, 0, 0.001, 0.04), trace(1, 0, 1, 0, 0.002, 0.03),
                                        trace(2, 0, 0, 0, 0.001, 0.04)};
  const WorkTable work = work_table(analyse(runs, traces), Work::evaluations, 1e-10);
  CHECK(work[0][0] == 3);
  CHECK(work[0][1] == 7);  // an iteration is the work of one evaluation at least
  CHECK(work[0][2] == kNever);
}

// Beside the kinks of a mesh chains of one and the same path have different energies.
TEST_CASE("study analysis: certified at the least certified cost is solved, at the latest at the end of the run") {
  RunTable runs;
  runs.rows = {row(0, 0, "low", 50), row(1, 0, "high", 58), row(2, 0, "dearer", 58),
               row(3, 0, "unsure", 58, "uncertified")};
  for (RunRow& r : runs.rows) r.cost_error_bar = 1e-15;
  runs.rows[2].cost = 2 + 1e-6;
  const std::vector<TraceRow> traces = {trace(1, 0, 0, 1, 0.001, 90), trace(1, 0, 1, 4, 0.002, 58)};
  const StudyAnalysis study = analyse(runs, traces);
  const std::vector<Task>& tasks = study.groups[0].tasks;
  CHECK(tasks[1].verdict == Verdict::certified);
  CHECK(tasks[2].verdict == Verdict::other_minimum);
  CHECK(tasks[3].verdict == Verdict::uncertified);
  const WorkTable work = work_table(study, Work::evaluations, 1e-10);
  CHECK(work[0] == std::vector<double>{5, 5, kNever, kNever});
  CHECK(work_table(study, Work::seconds, 1e-10)[0][1] == Approx(0.01));
}

TEST_CASE("study analysis: a refusal is no failure, and no work") {
  RunTable runs;
  runs.rows = {row(0, 0, "a", 50), row(1, 0, "b", 0)};
  RunRow& refusal = runs.rows[1];
  refusal.outcome = outcome::kCannotSolve;
  refusal.status = "";
  refusal.message = "works in a chart";
  refusal.evaluations = refusal.iterations = 0;
  refusal.final_energy = refusal.initial_energy = std::nan("");
  refusal.s_solve.reset();
  const StudyAnalysis study = analyse(runs, {});
  const Task& task = study.groups[0].tasks[1];
  CHECK(task.verdict == Verdict::refused);
  CHECK(task.reason == "refused: works in a chart");
  CHECK(task.evaluations.count == 0);
  CHECK(work_table(study, Work::evaluations, 1e-10)[0][1] == kNever);
}

// E0 - E* is 1 for the first and 40 for the second: what is left of the way is measured by it, whatever the slope of
// the energy.
TEST_CASE("study analysis: the test of More and Wild goes by the way down") {
  RunTable runs;
  runs.rows = {row(0, 0, "near", 50), row(1, 0, "far", 50)};
  runs.rows[0].initial_energy = 51;
  runs.rows[1].initial_energy = 90;
  const std::vector<TraceRow> traces = {trace(0, 0, 0, 1, 0.1, 51), trace(0, 0, 1, 2, 0.2, 50 + 2e-5),
                                        trace(1, 0, 0, 1, 0.1, 90), trace(1, 0, 1, 2, 0.2, 50 + 2e-5)};
  const StudyAnalysis study = analyse(runs, traces);
  CHECK(work_table(study, Work::evaluations, 1e-5, Test::left)[0] == std::vector<double>{5, 2});
  CHECK(work_table(study, Work::evaluations, 1e-5, Test::excess)[0] == std::vector<double>{2, 2});
}

TEST_CASE("study analysis: ties count for each, times tie within a tenth") {
  const WorkTable work = {{10, 10, 10.9}, {kNever, kNever, kNever}, {5, 4, kNever}};
  CHECK(problems_won(work, Work::evaluations, 3) == std::vector<std::size_t>{1, 2, 0});
  CHECK(problems_won(work, Work::seconds, 3) == std::vector<std::size_t>{1, 2, 1});
  CHECK(problems_won({}, Work::seconds, 2) == std::vector<std::size_t>{0, 0});
}

TEST_CASE("study analysis: kernels, seeds and swept keys tell groups apart only where they vary") {
  RunTable runs;
  runs.swept_keys = {"path.cascade"};
  for (const char* cascade : {"true", "false"}) {
    runs.rows.push_back(row(static_cast<long>(runs.rows.size()), 0, "a", 50));
    runs.rows.back().swept = {cascade};
  }
  const StudyAnalysis study = analyse(runs, {});
  REQUIRE(study.groups.size() == 2);
  CHECK(study.groups[0].label == "p, path.cascade true");
  CHECK(study.groups[1].rest == "path.cascade false");
}

}  // namespace leastcost::test
