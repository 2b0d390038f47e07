// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Studies as a whole: outcomes, journal, resume, shards. What a cell does is replaced where that makes a test sharp.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "app/study/merge.hpp"
#include "app/study/rows/row_json.hpp"
#include "app/study/study_summary.hpp"
#include "catalogue/output/output_folder.hpp"
#include "tests/app/study_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;

namespace {

/// kStudy with repetitions, in a file of its own.
app::StudyRequest request_in(const ScratchDir& dir, const std::string& output, int repetitions = 2) {
  std::ofstream(dir / "study.yaml") << kStudy << "repetitions: " << repetitions << "\n";
  app::StudyRequest request;
  request.config_file = dir / "study.yaml";
  request.output = dir / output;
  return request;
}

std::size_t lines_in(const fs::path& file) {
  const std::string text = content(file);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Leaves a byte in a file for every cell that is run, whatever process runs it.
app::CellResult counted(const fs::path& file, const app::StudyCell& cell, long repetition) {
  const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  (void)!::write(fd, "x", 1);
  ::close(fd);
  return app::run_cell(cell, repetition);
}

}  // namespace

TEST_CASE("study: one row per cell and repetition, the same for any number of processes") {
  const ScratchDir dir;
  const app::StudyOutcome outcome = app::run_study(request_in(dir, "a"));
  CHECK_FALSE(outcome.interrupted);
  const app::RunTable table = app::read_runs_csv(content(dir / "a/runs.csv"), "runs.csv");
  REQUIRE(table.rows.size() == 16);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    CHECK(table.rows[i].cell == static_cast<long>(i / 2));
    CHECK(table.rows[i].repetition == static_cast<long>(i % 2));
    CHECK(table.rows[i].outcome == app::outcome::kOk);
    CHECK(table.rows[i].status == "certified");
    CHECK(table.rows[i].termination == "converged");
  }
  CHECK(table.rows[0].cost.value() == Approx(5).epsilon(1e-14));
  CHECK(table.rows[0].optimum_error.value() < 1e-14);
  CHECK_FALSE(table.rows[15].optimum.has_value());
  CHECK(table.rows[15].points == 12);
  const auto traces = app::read_traces_csv(content(dir / "a/traces.csv"), "traces.csv");
  REQUIRE_FALSE(traces.empty());
  for (const char* file : {"manifest.json", "study.resolved.yaml", "summary.json", "journal.jsonl"})
    CHECK(fs::exists(dir / "a" / file));
  CHECK(nlohmann::json::parse(content(dir / "a/manifest.json"))["kind"] == "study");
  CHECK(nlohmann::json::parse(content(dir / "a/summary.json"))["runs"] == 16);

  app::StudyRequest parallel = request_in(dir, "b");
  parallel.parallel = 3;
  app::run_study(parallel);
  CHECK(results_without_times(dir / "a") == results_without_times(dir / "b"));
}

TEST_CASE("study: the energy slope is the unit of the energy") {
  // Where all costs grow by a part e the energy grows by e times the slope; for H = s^2 on the line at the mean cost: 2
  // per segment.
  const ScratchDir dir;
  app::StudyRequest request = request_in(dir, "a", 1);
  request.overrides = {set_option("kernels=[square]")};
  app::run_study(request);
  const app::RunTable table = app::read_runs_csv(content(dir / "a/runs.csv"), "runs.csv");
  CHECK(table.rows[0].energy_slope.value() == Approx(2 * 9).epsilon(1e-12));
  CHECK(table.rows[0].final_energy.value() == Approx(9).epsilon(1e-12));
}

TEST_CASE("study: crash, hang, exception, memory and configuration are outcomes with their reasons") {
  const ScratchDir dir;
  app::StudyRequest request = request_in(dir, "a", 1);
  request.overrides = {set_option("max_seconds=0.1"), set_option("grace_seconds=0.1"),
                       set_option("problems.1.config.ends.target.tolerance=0.5")};
  request.parallel = 4;
  request.run = [](const app::StudyCell& cell, long repetition) -> app::CellResult {
    switch (cell.number) {
      case 0: std::raise(SIGKILL); break;
      case 1: ::pause(); break;
      case 2: throw std::runtime_error("something, with a comma");
      case 3: throw std::bad_alloc();
      default: break;
    }
    return app::run_cell(cell, repetition);
  };
  const app::StudyOutcome outcome = app::run_study(request);
  const app::RunTable table = app::read_runs_csv(content(dir / "a/runs.csv"), "runs.csv");
  REQUIRE(table.rows.size() == 8);
  CHECK(table.rows[0].outcome == "crash");
  CHECK(table.rows[0].message == "signal 9 (Killed)");
  CHECK(table.rows[0].problem == "line");
  CHECK(table.rows[0].points == 8);
  CHECK(table.rows[1].outcome == "timeout");
  CHECK(table.rows[2].outcome == "error");
  CHECK(table.rows[2].message == "something, with a comma");
  CHECK(table.rows[3].outcome == "memory");
  CHECK(table.rows[4].outcome == "ok");
  CHECK_FALSE(app::summarize(outcome.journal).complete_and_ok());
  CHECK(app::summarize(outcome.journal).failed == 4);
}

TEST_CASE("study: what only the data shows is an outcome of its cells") {
  const ScratchDir dir;
  std::ofstream(dir / "study.yaml")
      << "problems:\n"
         "  - {name: no file, config: {manifold: {type: mesh, file: nowhere.obj}, cost: euclidean, ends: {source: "
         "{vertex: 0}, target: {vertex: 1}}}}\n"
         "  - {name: no path, config: {manifold: {type: mesh, file: two.obj}, cost: euclidean, ends: {source: {vertex: "
         "0}, target: {vertex: 3}}}}\n"
         "  - {name: no vertex, config: {manifold: {type: mesh, file: two.obj}, cost: euclidean, ends: {source: "
         "{vertex: 0}, target: {vertex: 9}}}}\n"
         "solvers: [lbfgs]\n";
  std::ofstream(dir / "two.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\nf 4 5 6\n";
  app::StudyRequest request;
  request.config_file = dir / "study.yaml";
  request.output = dir / "out";
  app::run_study(request);
  const app::RunTable table = app::read_runs_csv(content(dir / "out/runs.csv"), "runs.csv");
  REQUIRE(table.rows.size() == 3);
  CHECK(table.rows[0].outcome == "input_error");
  CHECK_THAT(table.rows[0].message, Contains("nowhere.obj"));
  CHECK(table.rows[1].outcome == "no_path");
  CHECK(table.rows[2].outcome == "configuration_error");
  CHECK_THAT(table.rows[2].message, Contains("ends.target"));
}

TEST_CASE("study: a cell that cannot be composed is a failed cell, and the others run") {
  const ScratchDir dir;
  app::StudyRequest request = request_in(dir, "a", 1);
  request.overrides = {set_option("problems.1.config.cost={type: formula, lagrangian: vx^2 + vy^2}"),
                       set_option("points=[8]")};
  const app::StudyOutcome outcome = app::run_study(request);
  const app::RunTable table = app::read_runs_csv(content(dir / "a/runs.csv"), "runs.csv");
  REQUIRE(table.rows.size() == 4);
  CHECK(table.rows[1].outcome == "ok");
  CHECK(table.rows[2].outcome == "configuration_error");
  CHECK_THAT(table.rows[2].message, Contains("cost.lagrangian: ") && Contains("this is an energy"));
  CHECK(table.rows[3].message == table.rows[2].message);
  CHECK(app::summarize(outcome.journal).failed == 2);
  request.output = dir / "never";
  request.overrides.push_back(set_option("set.solver.tolerence=1"));
  CHECK_THROWS_AS(app::run_study(request), ConfigError);
  CHECK_FALSE(fs::exists(dir / "never"));
}

TEST_CASE("study: what cells share is composed once, when the first of them begins, and not for a full folder") {
  const ScratchDir dir;
  std::vector<std::size_t> composed_after;
  std::size_t finished = 0;
  const auto observed = [&](app::StudyRequest request) {
    request.prepare = [&](const app::StudyCell& cell) {
      composed_after.push_back(finished);
      app::prepare_cell(cell);
    };
    request.observe = [&](const app::StudyProgress& p) { finished = p.finished; };
    return request;
  };
  app::StudyRequest request = observed(request_in(dir, "a", 1));
  app::run_study(request);
  CHECK(composed_after == std::vector<std::size_t>{0, 4});  // two problems, by two solvers with two numbers of points
  CHECK_THROWS_AS(app::run_study(request), OutputRefused);
  request.resume = true;
  app::run_study(request);
  CHECK(composed_after.size() == 2);

  app::StudyRequest alone = observed(request_in(dir, "b", 1));
  alone.overrides = {set_option("points=[8]"), set_option("solvers=[newton]")};
  app::run_study(alone);  // nothing is shared: each is left to its own process
  CHECK(composed_after.size() == 2);
}

TEST_CASE("study: interrupted and resumed, nothing is lost and nothing run twice") {
  const ScratchDir dir;
  app::run_study(request_in(dir, "whole"));
  app::StudyRequest request = request_in(dir, "parts");
  request.resume = true;  // also the way to begin
  request.run = [&](const app::StudyCell& cell, long r) { return counted(dir / "count", cell, r); };
  std::size_t stop_at = 0, finished = 0;
  request.observe = [&](const app::StudyProgress& p) { finished = p.finished; };
  request.stop_requested = [&] { return finished >= stop_at; };
  for (stop_at = 3; stop_at < 16; stop_at += 4) {
    CHECK(app::run_study(request).interrupted);
    CHECK(lines_in(dir / "parts/journal.jsonl") == 1 + stop_at);
    CHECK(fs::exists(dir / "parts/runs.csv"));  // what there is so far
  }
  stop_at = 17;
  CHECK_FALSE(app::run_study(request).interrupted);
  CHECK(fs::file_size(dir / "count") == 16);
  CHECK(results_without_times(dir / "whole") == results_without_times(dir / "parts"));
  app::run_study(request);  // complete: only the files are made again
  CHECK(fs::file_size(dir / "count") == 16);
}

TEST_CASE("study: killed at random moments 20 times and resumed, it has the results of one that was not") {
  const ScratchDir dir;
  constexpr int kRepetitions = 12, kKills = 20;
  app::run_study(request_in(dir, "whole", kRepetitions));
  app::StudyRequest request = request_in(dir, "killed", kRepetitions);
  request.resume = true;
  request.parallel = 2;
  request.run = [](const app::StudyCell& cell, long repetition) {
    std::this_thread::sleep_for(std::chrono::milliseconds(8));
    return app::run_cell(cell, repetition);
  };
  const unsigned seed = std::random_device()();
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int kill = 0; kill < kKills; ++kill) {
    const pid_t pid = ::fork();
    if (pid == 0) {
      try {
        app::run_study(request);
      } catch (...) {
        ::_exit(1);
      }
      ::_exit(0);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(std::uniform_int_distribution(0, 40)(random)));
    ::kill(pid, SIGKILL);
    int status = 0;
    ::waitpid(pid, &status, 0);
    CHECK((WIFSIGNALED(status) || WEXITSTATUS(status) == 0));
  }
  CHECK_FALSE(app::run_study(request).interrupted);
  CHECK(results_without_times(dir / "whole") == results_without_times(dir / "killed"));
  CHECK(lines_in(dir / "killed/journal.jsonl") == 1 + 8 * kRepetitions);
}

TEST_CASE("study: a torn last line of the journal is run again") {
  const ScratchDir dir;
  app::StudyRequest request = request_in(dir, "a");
  app::run_study(request);
  const std::string before = results_without_times(dir / "a"), journal = content(dir / "a/journal.jsonl");
  request.resume = true;
  for (const std::size_t cut : {std::size_t{1}, std::size_t{40}, journal.size() - journal.find('\n') - 5,
                                journal.size() - 10, journal.size()}) {
    fs::resize_file(dir / "a/journal.jsonl", journal.size() - cut);
    app::run_study(request);
    CHECK(results_without_times(dir / "a") == before);
    CHECK(lines_in(dir / "a/journal.jsonl") == 17);
  }
  std::string damaged = journal;
  damaged[journal.find('\n') + 3] = '#';
  std::ofstream(dir / "a/journal.jsonl") << damaged;
  CHECK_THROWS_WITH(app::run_study(request), Contains("journal.jsonl:2: not a line of a study's journal"));
}

TEST_CASE("study: a folder is not resumed by another study, shard or process, nor overwritten unasked") {
  const ScratchDir dir;
  app::StudyRequest request = request_in(dir, "a");
  app::run_study(request);
  CHECK_THROWS_WITH(app::run_study(request), Contains("is not empty") && Contains("use --resume to continue"));
  request.resume = true;
  app::StudyRequest changed = request;
  changed.overrides = {set_option("set.certificate.spacing=0.3")};
  CHECK_THROWS_WITH(app::run_study(changed), Contains("the options of its cells"));
  changed.overrides = {set_option("repetitions=3")};
  CHECK_THROWS_WITH(app::run_study(changed), Contains("it had 2 repetitions and now has 3"));
  app::StudyRequest shard = request;
  shard.shard = {1, 2};
  CHECK_THROWS_WITH(app::run_study(shard), Contains("holds shard 0/1 of this study, not 1/2"));

  const app::StudyOutcome outcome = app::run_study(request);
  {
    app::JournalContent journal;
    const app::Journal held = app::Journal::resume(dir / "a/journal.jsonl", outcome.journal.facts, {}, journal);
    CHECK_THROWS_WITH(app::run_study(request), Contains("another process is writing to this study"));
  }
  fs::create_directories(dir / "other");
  std::ofstream(dir / "other/mine.txt") << "x";
  request.output = dir / "other";
  CHECK_THROWS_AS(app::run_study(request), OutputRefused);
  request.resume = false;
  request.force = true;
  CHECK_THROWS_AS(app::run_study(request), OutputRefused);
  CHECK(fs::exists(dir / "other/mine.txt"));
  request.output = dir / "a";
  CHECK_FALSE(app::run_study(request).interrupted);
}

TEST_CASE("journal: one that another study has written since the folder was looked at is not begun anew unasked") {
  const ScratchDir dir;
  const fs::path file = dir / "journal.jsonl";
  app::StudyFacts facts;
  facts.name = "first";
  facts.cells = facts.repetitions = 1;
  app::Journal::create(file, facts, {}, false);
  const std::string before = content(file);
  CHECK_THROWS_AS(app::Journal::create(file, facts, {}, false), OutputRefused);
  CHECK(content(file) == before);
  facts.name = "second";
  app::Journal::create(file, facts, {}, true);
  CHECK_THAT(content(file), Contains("second"));
}

TEST_CASE("study: shards merged are one run") {
  const ScratchDir dir;
  app::run_study(request_in(dir, "whole"));
  for (int i = 0; i < 3; ++i) {
    app::StudyRequest request = request_in(dir, "shard" + std::to_string(i));
    request.shard = {i, 3};
    const app::StudyOutcome outcome = app::run_study(request);
    CHECK(app::summarize(outcome.journal).complete_and_ok());
  }
  app::MergeRequest merge{{dir / "shard2", dir / "shard0", dir / "shard1"}, dir / "merged", false, {}};
  CHECK(app::summarize(app::merge_studies(merge).journal).complete_and_ok());
  CHECK(results_without_times(dir / "whole") == results_without_times(dir / "merged"));
  CHECK(content(dir / "whole/study.resolved.yaml") == content(dir / "merged/study.resolved.yaml"));

  SECTION("a shard is missing") {
    merge = {{dir / "shard0", dir / "shard2"}, dir / "two", false, {}};
    const app::StudySummary summary = app::summarize(app::merge_studies(merge).journal);
    CHECK_FALSE(summary.complete_and_ok());
    CHECK(summary.missing.size() == 6);
    CHECK_THAT(app::summary_text(summary), Contains("missing: cell 1, repetition 0"));
    app::StudyRequest rest = request_in(dir, "two");  // merged, it can be completed
    rest.resume = true;
    app::run_study(rest);
    CHECK(results_without_times(dir / "whole") == results_without_times(dir / "two"));
  }
  SECTION("results twice agree, or are refused") {
    merge = {{dir / "whole", dir / "shard1"}, dir / "again", false, {}};
    CHECK(app::merge_studies(merge).journal.results.size() == 16);
    std::string journal = content(dir / "shard1/journal.jsonl");
    const std::size_t at = journal.find("\"iterations\":");
    journal.insert(at + 13, "9");
    std::ofstream(dir / "shard1/journal.jsonl") << journal;
    merge.output = dir / "wrong";
    CHECK_THROWS_WITH(app::merge_studies(merge), Contains("disagree about cell 1, repetition 0"));
    CHECK_FALSE(fs::exists(dir / "wrong"));
  }
  SECTION("another study is refused") {
    app::StudyRequest other = request_in(dir, "other", 1);
    app::run_study(other);
    merge = {{dir / "shard0", dir / "other"}, dir / "mixed", false, {}};
    CHECK_THROWS_WITH(app::merge_studies(merge), Contains("are not of the same study"));
    merge.folders = {dir / "nowhere"};
    CHECK_THROWS_WITH(app::merge_studies(merge), Contains("cannot be opened"));
  }
}

TEST_CASE("journal: rows keep every bit, also what JSON has no number for") {
  app::CellResult result;
  result.row.cell = 3;
  result.row.problem = "a \"b\"\xff";
  result.row.swept = {"x"};
  result.row.cost = 0.1 + 0.2;
  result.row.spacing = std::nan("");
  result.row.final_energy = -std::numeric_limits<double>::infinity();
  result.row.iterations = 5;
  result.trace = {{3, 0, 1, 2, 0.5, 1e-310, std::nan(""), 3}};
  const app::CellResult back = app::from_json_line(app::to_json_line(result));
  CHECK(app::to_json_line(back) == app::to_json_line(result));
  CHECK(back.row.cost == 0.1 + 0.2);
  CHECK(std::isnan(back.row.spacing.value()));
  CHECK(back.row.final_energy == -std::numeric_limits<double>::infinity());
  CHECK(back.trace[0].energy == 1e-310);
  CHECK_FALSE(back.row.points.has_value());
}

}  // namespace leastcost::test
