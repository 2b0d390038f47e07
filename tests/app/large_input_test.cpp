// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Inputs that somebody makes long on purpose, or by mistake: the time is linear in them, and the answer short.
#include <chrono>
#include <fstream>

#include <leastcost/app/report/report.hpp>
#include "app/study/cell/isolation.hpp"
#include "app/study/rows/journal.hpp"
#include "app/study/rows/row_json.hpp"
#include "app/study/study_files.hpp"
#include "catalogue/output/manifest.hpp"
#include "catalogue/output/output_folder.hpp"
#include "catalogue/run/memory.hpp"
#include "tests/app/called.hpp"
#include "tests/app/config_text.hpp"
#include "tests/app/study_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

using Catch::Contains;

namespace {

/// Runs `work` and checks that it took no more than `seconds`: many times what it takes, and far less than what it took
/// when it was quadratic. Sanitizers take their time.
template <class Work>
void within(double seconds, Work work) {
  if (!app::can_limit_memory()) seconds *= 10;
  const auto start = std::chrono::steady_clock::now();
  work();
  CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < seconds);
}

constexpr std::size_t kShort = 100'000;  ///< bytes: what anybody may be told

}  // namespace

TEST_CASE("large inputs: unknown and duplicate keys are told by the first hundred and their number") {
  std::string unknown = kPlane, duplicate = kPlane;
  constexpr int kUnknown = 60'000, kDuplicate = 200'000;
  for (int i = 0; i < kUnknown; ++i) unknown += "k" + std::to_string(i) + ": 1\n";
  for (int i = 0; i < kDuplicate; ++i) duplicate += "a: 1\n";
  within(10, [&] {
    const LoadedConfig loaded = parse(unknown);
    CHECK(loaded.errors.size() == kUnknown);
    CHECK(loaded.errors.count() == "60000 errors in a.yaml, of which the first 100 are shown");
    CHECK(loaded.errors.render().size() < kShort);
    CHECK_THAT(loaded.errors.render(), Contains("a.yaml:6:1: error: unknown key 'k0'"));
  });
  within(10, [&] {
    const LoadedConfig loaded = parse(duplicate);
    CHECK(loaded.errors.size() == kDuplicate);  // the first is unknown, the others are duplicates
    CHECK(loaded.errors.render().size() < kShort);
  });
}

TEST_CASE("large inputs: an override is named by its beginning, and no option is named by a hundred words") {
  std::string dots = "a";
  for (int i = 0; i < 100'000; ++i) dots += ".a";
  within(2, [&] {
    const std::string errors = errors_of(kPlane, {dots + "=1"});
    CHECK(errors.size() < kShort);
    CHECK_THAT(errors, Contains("no option has more than 16 words"));
  });
  CHECK_THAT(errors_of(kPlane, {"name=" + std::string(100'000, '/')}), Contains("'name' is used as a folder name"));
}

TEST_CASE("large inputs: what is nested too deep is said with the limit") {
  for (const int depth : {150, 3000, 100'000}) {
    CAPTURE(depth);
    CHECK_THAT(errors_of("a: " + std::string(static_cast<std::size_t>(depth), '[') + "\n"),
               Contains("a.yaml:1:") && Contains("at most 100 deep"));
  }
  std::string blocks = "a";
  for (int i = 0; i < 300; ++i) blocks += ":\n" + std::string(static_cast<std::size_t>(i) + 1, ' ') + "a";
  CHECK_THAT(errors_of(blocks + ": 1\n"), Contains("at most 100 deep"));
}

TEST_CASE("large inputs: a study of many seeds") {
  constexpr int kSeeds = 20'000;
  std::string seeds = "[0";
  for (int i = 1; i < kSeeds; ++i) seeds += ", " + std::to_string(i);
  const std::string text =
      "problems:\n  - {name: line, config: {manifold: {type: euclidean, dimension: 2}, cost: euclidean, "
      "ends: {source: {point: [0, 0]}, target: {point: [3, 4]}}}}\nseeds: " +
      seeds + "]\nskip: [{seed: " + seeds + "], because: all of them}]\n";
  within(30, [&] {
    std::string errors;
    const app::StudyGrid grid = grid_of(text, errors);
    CHECK(errors == "");
    REQUIRE(grid.cells.size() == kSeeds);
    CHECK(grid.cells.back().skipped == "all of them");
  });
}

TEST_CASE("large inputs: the report of many rows shows the first ones and counts all") {
  const ScratchDir dir;
  constexpr long kRows = 20'000;
  app::JournalContent journal;
  journal.facts.name = "many";
  journal.facts.cells = kRows;
  journal.facts.repetitions = 1;
  for (long i = 0; i < kRows; ++i) {
    app::CellResult result;
    result.row.cell = i;
    result.row.problem = "problem";
    result.row.solver = "newton";
    result.row.kernel = "square";
    result.row.points = 8 + i % 2;
    result.row.seed = i / 2;
    result.row.outcome = app::outcome::kOk;
    result.row.status = "certified";
    result.row.final_energy = 1.0 + 1e-3 * static_cast<double>(i % 7);
    result.row.initial_energy = 2.0;
    result.row.energy_slope = 1.0;
    result.row.evaluations = 5 + i % 5;
    result.row.s_solve = 1e-3;
    result.trace.push_back({i, 0, 0, 1, 1e-4, 2.0, 1.0, 0.0});
    journal.results.push_back(result);
  }
  within(60, [&] {
    app::write_study_files(dir.path(), journal);
    ManifestFacts manifest;
    manifest.kind = "study";
    write_whole_file(dir / "manifest.json", manifest_json(manifest));
    write_whole_file(dir / "study.resolved.yaml", "name: many\n");
    write_report(dir.path());
  });
  const std::string page = content(dir / "report.html");
  CHECK(page.size() < 20'000'000);
  CHECK_THAT(page, Contains("only the first 500 of 20000 problems are shown one by one; runs.csv has all") &&
                       Contains("20000 solves"));
}

TEST_CASE("large inputs: points that the memory cannot hold are an error with both sizes") {
  const double have = memory_of_host(), each = bytes_of_path(1, {3, 3, 2});
  CHECK(have > 1e8);
  CHECK((each > 500 && each < 10'000));
  CHECK(errors_of(kPlane + "path: {points: 1000}\n") == "");
  if (have / bytes_of_path(1, {2, 2, 2}) < 9e6)
    CHECK_THAT(errors_of(kPlane + "path: {points: 10000000}\n"),
               Contains("a.yaml:6:16: error: 'points' in path: 10000000 points take about ") && Contains("there are"));
  const ScratchDir dir;
  std::ofstream(dir / "a.yaml") << kPlane << "path: {points: 1000}\n";
  CHECK_THAT(call({"run", (dir / "a.yaml").string(), "-n"}).out, Contains("memory      the path needs about "));
}

}  // namespace leastcost::test
