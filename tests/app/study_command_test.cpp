// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The commands study and merge inside the process: streams and exit codes; and what validate, describe and run say of
// studies.
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/command_line.hpp"
#include "app/cli/study_progress.hpp"
#include "tests/app/called.hpp"
#include "tests/app/config_text.hpp"
#include "tests/app/study_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

/// kStudy in a file.
std::string study_in(const ScratchDir& dir, const std::string& more = "") {
  std::ofstream(dir / "study.yaml") << kStudy << more;
  return (dir / "study.yaml").string();
}

}  // namespace

TEST_CASE("study command: a table on stdout, the files in the folder, exit 0") {
  const ScratchDir dir;
  const Called text = call({"study", study_in(dir), "-o", (dir / "a").string(), "-j", "2"});
  CHECK(text.exit == 0);
  CHECK(text.err == "");
  CHECK_THAT(text.out, Contains("newton") && Contains("certified") && Contains("output: "));
  CHECK(fs::exists(dir / "a/runs.csv"));
  const Called json = call({"study", study_in(dir), "-o", (dir / "b").string(), "--format", "json"});
  const Json summary = Json::parse(json.out);
  CHECK(summary["runs"] == 8);
  CHECK(summary["solvers"].size() == 2);
  CHECK(summary["cells"].size() == 8);
  CHECK(summary["output"] == (dir / "b").string());
}

TEST_CASE("study command: exit 7 when a part failed, with the reason on stderr, a refusal is an answer") {
  const ScratchDir dir;
  const std::string study = study_in(dir);
  const Called failed =
      call({"study", study, "-o", (dir / "a").string(), "--set", "points=[8]", "--set",
            "problems.1.config.manifold={type: mesh, file: nowhere.obj}", "--set",
            "problems.1.config.ends={source: {vertex: 0}, target: {vertex: 1}}", "--set", "set.cost=euclidean"});
  CHECK(failed.exit == 7);
  CHECK_THAT(failed.err,
             Contains("input_error: cell 2 (chute, newton, expm1_square, 8 points)") && Contains("nowhere.obj"));
  CHECK_THAT(failed.out, Contains("input_error: 1 of newton"));

  const Called refused =
      call({"study", study, "-o", (dir / "b").string(), "--set", "solvers=[georce]", "--set",
            "problems.1.config.manifold={type: implicit, surface: sphere}", "--set", "problems.1.config.cost=euclidean",
            "--set", "problems.1.config.ends={source: {point: [1, 0, 0]}, target: {point: [0, 1, 0]}}"});
  CHECK(refused.exit == 0);
  CHECK_THAT(refused.out, Contains("cannot_solve: 2 of georce"));
  CHECK_THAT(content(dir / "b/runs.csv"), Contains("georce works in a chart"));
  for (const app::RunRow& row : app::read_runs_csv(content(dir / "b/runs.csv"), "runs.csv").rows)
    CHECK((row.outcome != app::outcome::kCannotSolve || (!row.solver_error && !row.initial_energy)));
}

TEST_CASE("study command: a dry run prints the grid and makes nothing") {
  const ScratchDir dir;
  const std::string study = study_in(dir, "skip: [{solver: lbfgs, because: not today}]\n");
  const Called text = call({"study", study, "-n", "-o", (dir / "a").string()});
  CHECK(text.exit == 0);
  CHECK_THAT(text.out, Contains("cell  problem, solver, kernel, points, seed") && Contains("(skipped: not today)") &&
                           Contains("4 cells of 8 would be run, each 1 time, into"));
  CHECK_FALSE(fs::exists(dir / "a"));
  const Json grid = Json::parse(call({"study", study, "-n", "--shard", "1/2", "--format", "json"}).out);
  CHECK(grid["cells"].size() == 4);
  CHECK(grid["cells"][0]["points"] == "12");
}

TEST_CASE("study command: how long the rest takes is told from what is done") {
  const auto left = [](std::size_t earlier, std::size_t finished, double seconds) {
    return app::time_left({.finished = finished, .total = 100, .earlier = earlier}, seconds);
  };
  CHECK(left(0, 0, 5) == "");
  CHECK(left(0, 10, 10) == "about 90 s left");
  CHECK(left(0, 10, 60) == "about 9 min left");
  CHECK(left(0, 10, 3600) == "about 9 h left");
  CHECK(left(50, 60, 10) == "about 40 s left");  // by what this process has done
  CHECK(left(50, 50, 10) == "");
  CHECK(left(0, 100, 10) == "");
}

TEST_CASE("study command: wrong usage is exit 2, a wrong study 3, none 4") {
  const ScratchDir dir;
  const std::string study = study_in(dir);
  for (const char* shard : {"2/2", "1", "x/2", "0/0", "-1/2"}) {
    const Called wrong = call({"study", study, "--shard", shard});
    CHECK(wrong.exit == 2);
    CHECK_THAT(wrong.err, Contains("must be i/N with i from 0 to N - 1"));
  }
  CHECK(call({"study", study, "-j", "0"}).exit == 2);
  CHECK(call({"study", study, "--resume", "--force"}).exit == 2);
  CHECK(call({"merge", "x"}).exit == 2);
  CHECK(call({"study", study, "--timeout", "soon"}).exit == 3);
  CHECK_THAT(call({"study", study, "--timeout", "soon"}).err, Contains("--timeout soon: error: 'max_seconds' must be"));
  CHECK(call({"study", study, "--repetitions", "0"}).exit == 3);
  CHECK(call({"study", (dir / "none.yaml").string()}).exit == 4);
  CHECK(call({"merge", (dir / "none").string(), "-o", (dir / "m").string()}).exit == 4);
  std::ofstream(dir / "run.yaml") << kPlane;
  CHECK_THAT(call({"study", (dir / "run.yaml").string()}).err, Contains("so it is a run: run it with leastcost run"));
  CHECK_THAT(call({"run", study}).err,
             Contains("this file has 'problems', so it is a study: run it with leastcost study"));
}

TEST_CASE("study command: what validate, describe and help say of studies") {
  const ScratchDir dir;
  const std::string study = study_in(dir);
  CHECK(call({"validate", study}).out == study + ": valid\n");
  std::ofstream(dir / "sheet.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::ofstream(dir / "mesh.yaml") << "problems:\n  - name: sheet\n    config:\n      manifold: {type: mesh, file: "
                                      "sheet.obj}\n      cost: euclidean\n      ends: {source: {vertex: 0}, target: "
                                      "{vertex: 1}}\npoints: [8, 12]\n";
  CHECK_THAT(call({"validate", (dir / "mesh.yaml").string()}).out,
             Contains("not checked: the contents of sheet.obj; leastcost study reads it"));
  const Called wrong = call({"validate", study_in(dir, "kernels: [cubic]\n")});
  CHECK(wrong.exit == 3);
  CHECK_THAT(wrong.err, Contains("study.yaml:15:11: error: unknown kernel 'cubic'"));
  CHECK_THAT(call({"describe", "study"}).out,
             Contains("repetitions") && Contains("block of options of a run with lists of values"));
  CHECK_THAT(call({"study", "--help"}).out, Contains("sbatch --array") && Contains("parallel leastcost study"));
}

TEST_CASE("merge command: shards of a study as one, exit 7 while one is missing") {
  const ScratchDir dir;
  const std::string study = study_in(dir);
  for (const char* shard : {"0", "1"})
    CHECK(call({"study", study, "--shard", std::string(shard) + "/2", "-o", (dir / shard).string()}).exit == 0);
  CHECK(call({"merge", (dir / "0").string(), (dir / "1").string(), "-o", (dir / "m").string()}).exit == 0);
  CHECK(fs::exists(dir / "m/runs.csv"));
  const Called part = call({"merge", (dir / "0").string(), "-o", (dir / "p").string(), "--format", "json"});
  CHECK(part.exit == 7);
  CHECK(Json::parse(part.out)["missing"].size() == 4);
  CHECK(call({"merge", (dir / "0").string(), "-o", (dir / "m").string()}).exit == 2);  // not empty
  CHECK(call({"merge", (dir / "0").string(), "-o", (dir / "m").string(), "--force"}).exit == 7);
}

}  // namespace leastcost::test
