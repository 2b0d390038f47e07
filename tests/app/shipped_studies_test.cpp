// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Every study of configs/studies is valid, says how it is run, and does, in a small form, what it promises.
#include <cmath>

#include "app/reference/describe.hpp"
#include "app/study/study_facts.hpp"
#include "app/study/study_summary.hpp"
#include "tests/app/study_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;

namespace {

std::vector<fs::path> shipped() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(project_dir() / "configs/studies"))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

app::RunTable run_reduced(const ScratchDir& dir, const char* study, const std::vector<std::string>& set) {
  app::StudyRequest request;
  request.config_file = project_dir() / "configs/studies" / study;
  for (const std::string& assignment : set) request.overrides.push_back(set_option(assignment));
  request.output = dir / "out";
  request.parallel = 2;
  const app::StudyOutcome outcome = app::run_study(request);
  INFO(app::summary_text(app::summarize(outcome.journal)));
  CHECK(app::summarize(outcome.journal).complete_and_ok());
  return app::read_runs_csv(content(dir / "out/runs.csv"), "runs.csv");
}

}  // namespace

TEST_CASE("shipped studies: valid, with the command that runs them, and the same when resolved") {
  const std::vector<fs::path> files = shipped();
  REQUIRE(files.size() >= 6);
  const ScratchDir dir;
  for (const fs::path& file : files) {
    CAPTURE(file);
    const app::StudyGrid grid = app::load_grid(file, {});
    CHECK_THAT(content(file), Contains("leastcost study configs/studies/" + file.filename().string()));
    std::ofstream(dir / "study.resolved.yaml") << app::resolved_study(grid, dir.path());
    const app::StudyGrid again = app::load_grid(dir / "study.resolved.yaml", {});
    CHECK(app::difference(app::facts_of(grid), app::facts_of(again)) == "");
  }
}

TEST_CASE("shipped studies: in the suite newton certifies every problem, and every bar holds the known optimum") {
  const ScratchDir dir;
  const app::RunTable table = run_reduced(dir, "suite.yaml", {"solvers=[newton]", "max_seconds=0"});
  CHECK(table.rows.size() >= 45);
  for (const app::RunRow& row : table.rows) {
    CAPTURE(row.problem, row.failures, row.message);
    CHECK(row.status == "certified");
    REQUIRE(row.optimum.has_value());
    CHECK(std::abs(*row.cost - *row.optimum) <= *row.cost_error_bar + 1e-13 * *row.optimum);
    CHECK(*row.cost_error_bar <= 1e-4 * *row.optimum);
  }
}

TEST_CASE("shipped studies: with the chain, evaluations do not grow with the points") {
  const ScratchDir dir;
  const app::RunTable table =
      run_reduced(dir, "solvers_points.yaml", {"points=[20, 160]", "solvers=[newton, lbfgs]", "max_seconds=0"});
  REQUIRE(table.rows.size() == 12);
  for (std::size_t i = 0; i < table.rows.size(); i += 2) {
    CAPTURE(table.rows[i].problem, table.rows[i].solver);
    CHECK(table.rows[i].termination == "converged");
    CHECK(*table.rows[i + 1].evaluations <= 2 * *table.rows[i].evaluations);
  }
}

TEST_CASE("shipped studies: accuracy grows with the points, at the order of the curve") {
  const ScratchDir dir;
  const app::RunTable table =
      run_reduced(dir, "accuracy.yaml",
                  {"points=[16, 64]", "solvers=[newton]", "repetitions=1", "max_seconds=0",
                   "set={certificate.proof: never}"});  // bounds would replace the bar of few points, and better it
  REQUIRE(table.rows.size() == 12);
  for (std::size_t i = 0; i < table.rows.size(); i += 2) {
    CAPTURE(table.rows[i].problem);
    CHECK(*table.rows[i + 1].optimum_error < *table.rows[i].optimum_error / 50);  // 4^4 = 256 in the limit
  }
}

TEST_CASE("shipped studies: on the plane every strictly convex kernel finds the line and its equal spacing") {
  const ScratchDir dir;
  const app::RunTable table =
      run_reduced(dir, "kernels_plane.yaml", {"points=[50]", "solvers=[lbfgs]", "max_seconds=0"});
  REQUIRE(table.rows.size() == 6);
  for (const app::RunRow& row : table.rows) {
    CAPTURE(row.kernel, row.failures);
    CHECK((row.status == "certified") == (row.kernel != "linear"));
    CHECK(*row.chain_cost == Approx(1).epsilon(row.kernel == "linear" ? 1e-2 : 1e-12));
  }
}

}  // namespace leastcost::test
