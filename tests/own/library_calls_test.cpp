// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What the command line does, as calls of libraries: many pairs of ends, studies, reports, figures.
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include <leastcost/app/report.hpp>
#include <leastcost/app/study.hpp>
#include <leastcost/catalogue/catalogue.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include "tests/app/called.hpp"
#include "tests/own/own_plugins.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

EndOptions at(double x, double y) {
  EndOptions end;
  end.point = Eigen::Vector2d(x, y);
  return end;
}

std::vector<PairResult> all_of(const Run& run, const std::vector<EndPair>& pairs, const PairsOptions& options = {}) {
  std::vector<PairResult> results;
  CHECK(solve_pairs(
      run, pairs, [&](PairResult result) { results.push_back(std::move(result)); }, options));
  return results;
}

}  // namespace

TEST_CASE("solve_pairs: pairs from memory take the place of the ends") {
  register_own_plugins();
  const Run run = parse_run(kRay, "ray.yaml");
  const double exact = 2 * std::acosh(3.0);
  const std::vector<PairResult> results = all_of(
      run, {{at(0, 0), at(4, 0)}, {at(1, 0), at(5, 0)}, {at(2, 1), at(2, 1)}, {{}, at(1, 1)}, {at(0, 0), at(0, 2)}});
  REQUIRE(results.size() == 5);
  for (const int i : {0, 1}) {
    CHECK(results[i].number == i);
    CHECK(results[i].certified());
    CHECK(std::abs(results[i].cost - exact) < 1e-6);
    CHECK(results[i].points.rows() == 2);
    CHECK(results[i].points(0, 0) == i);
  }
  CHECK(results[2].cost == 0);
  CHECK(results[2].proof == ProofOutcome::proved);
  CHECK(results[3].outcome == "bad_pair");
  CHECK(results[3].message == "source: must have exactly one of: vertex; face and barycentric; point; lonlat; state");
  CHECK(std::abs(results[4].cost - 2 * std::log(2.0)) < 1e-6);  // straight down: int dy / (1 + y / 2)
}

TEST_CASE("solve_pairs: what cannot be an end is a result, and the others are solved") {
  const Run run = parse_run(
      "manifold: {type: euclidean, dimension: 2}\ncost: euclidean\n"
      "ends: {source: {point: [0, 0]}, target: {point: [3, 4]}}\n",
      "a.yaml");
  EndOptions vertex, both = at(0, 0), long_point, corner;
  vertex.vertex = 3;
  both.lonlat = Eigen::Vector2d(0, 0);
  long_point.point = Eigen::Vector3d(1, 2, 3);
  corner.face = 1;
  const std::vector<PairResult> results = all_of(run, {{vertex, at(0, 0)},
                                                       {at(0, 0), both},
                                                       {long_point, at(0, 0)},
                                                       {at(0, 0), corner},
                                                       {at(0, std::nan("")), at(0, 0)},
                                                       {at(0, 0), at(3, 4)}});
  REQUIRE(results.size() == 6);
  for (int i = 0; i < 5; ++i) {
    CAPTURE(i, results[i].message);
    CHECK(results[i].outcome == "bad_pair");
    CHECK_FALSE(results[i].found());
    CHECK(std::isnan(results[i].cost));
    CHECK_THAT(results[i].message, Contains(i == 1 || i == 3 ? "target" : "source"));
  }
  CHECK(std::abs(results[5].cost - 5) < 1e-9);
}

TEST_CASE("solve_pairs: a cost that follows its source is made for each pair, one in memory is kept") {
  const Run run = parse_run(
      "manifold: {type: euclidean, dimension: 2}\ncost: {type: travel_time, gravity: 1}\n"
      "ends: {source: {point: [0, 0]}, target: {point: [3.141592653589793, -2]}}\npath: {points: 40}\n",
      "slide.yaml");
  const double pi = 3.141592653589793;
  const std::vector<EndPair> pairs = {{at(0, 0), at(pi, -2)}, {at(1, 5), at(1 + pi, 3)}};
  for (const PairResult& result : all_of(run, pairs)) CHECK(std::abs(result.cost - pi) < 1e-5);
  Run faster = run;
  faster.parts.problem.cost = make_travel_time_cost({.gravity = 4}, 2, Eigen::Vector2d(0, 0));
  CHECK(std::abs(all_of(faster, {pairs[0]})[0].cost - pi / 2) < 1e-5);
  Run moved = run;
  moved.parts.problem.manifold = std::make_shared<OwnPlane>();
  CHECK_THROWS_WITH(solve_pairs(moved, pairs, [](PairResult) {}), Contains("it was replaced"));
}

TEST_CASE("solve_pairs: the same lines as the command line, whatever the threads") {
  const ScratchDir dir;
  std::string csv = "source_x,source_y,target_x,target_y\n";
  std::vector<EndPair> pairs;
  for (int i = 0; i < 40; ++i) {
    csv += std::to_string(i % 7) + ",0," + std::to_string(i) + ",3\n";
    pairs.push_back({at(i % 7, 0), at(i, 3)});
  }
  written(dir / "pairs.csv", csv + "here,0,1,1\n");
  const std::string text =
      "manifold: {type: euclidean, dimension: 2}\ncost: euclidean\nends: {pairs: pairs.csv}\n"
      "output: {pair_points: true}\n";
  const std::string config = written(dir / "many.yaml", text).string();
  CHECK(call({"run", config, "-o", (dir / "out").string(), "-q"}).exit == 7);
  std::vector<Json> lines;
  std::istringstream in(content(dir / "out/paths.jsonl"));
  for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
  REQUIRE(lines.size() == 41);
  for (Json& line : lines) line.erase("seconds");

  const Run run = load_run(config);
  for (const int threads : {1, 3}) {
    std::vector<Json> again;
    const PairDone keep = [&](PairResult result) {
      CHECK(result.line.find('\n') == std::string::npos);
      again.push_back(Json::parse(result.line));
      again.back().erase("seconds");
    };
    CHECK(solve_pairs(run, keep, {.threads = threads, .lines = true}));
    CHECK(again == lines);
    again.clear();
    CHECK(solve_pairs(run, pairs, keep, {.threads = threads, .lines = true}));
    lines.resize(41);
    CHECK(again == std::vector<Json>(lines.begin(), lines.end() - 1));
  }
}

TEST_CASE("solve_pairs: stopped and thrown out of, and refused where there are no pairs") {
  const Run run = parse_run(
      "manifold: {type: euclidean, dimension: 2}\ncost: euclidean\nends: {source: {point: [0, 0]}, target: {point: [3, "
      "4]}}\n",
      "a.yaml");
  const std::vector<EndPair> pairs(50, {at(0, 0), at(3, 4)});
  long count = 0;
  CHECK_FALSE(solve_pairs(run, pairs, [&](PairResult) { ++count; }, {.stop_requested = [&] { return count >= 10; }}));
  CHECK(count < 50);
  CHECK_THROWS_WITH(solve_pairs(run, pairs, [](PairResult) { throw InputError("full"); }), "full");
  CHECK_THROWS_WITH(solve_pairs(run, [](PairResult) {}), Contains("names no file of pairs"));
  const Run ring = load_run(project_dir() / "configs/ring_collapses.yaml");
  CHECK_THROWS_WITH(solve_pairs(ring, pairs, [](PairResult) {}), Contains("the run is a ring"));
}

namespace {

std::string study_text() {
  return R"(problems:
  - name: ray
    config:
      manifold: own_plane
      cost: own_ray_time
      ends: {source: {point: [0, 0]}, target: {point: [4, 0]}}
    optimum: 3.525494348078172
solvers: [newton, own_gauss_newton]
points: [16, 32]
)";
}

}  // namespace

TEST_CASE("run_study: from a text and from a file, with own plug-ins in its cells, and a report of it") {
  register_own_plugins();
  const ScratchDir dir;
  std::vector<std::size_t> heard;
  StudyOptions options{.output = dir / "a"};
  options.observe = [&](std::size_t finished, std::size_t total) {
    CHECK(total == 4);
    heard.push_back(finished);
  };
  const StudyResult result = run_study_text(study_text(), "rays.yaml", {}, {}, options);
  CHECK(result.complete_and_ok());
  CHECK(result.runs == 4);
  CHECK(result.folder == dir / "a");
  CHECK(heard == std::vector<std::size_t>{0, 1, 2, 3, 4});
  CHECK(Json::parse(result.summary)["solvers"].size() == 2);
  CHECK_THAT(content(dir / "a/runs.csv"), Contains("own_gauss_newton"));
  CHECK_THAT(content(dir / "a/manifest.json"), Contains("<rays.yaml>"));
  CHECK_FALSE(fs::exists(dir / "a/report.html"));
  CHECK(write_report(dir / "a") == dir / "a/report.html");
  CHECK(fs::exists(dir / "a/report.html"));

  CHECK_THROWS_AS(run_study_text(study_text(), "rays.yaml", {}, {}, {.output = dir / "a"}), OutputRefused);
  const StudyResult again = run_study(written(dir / "rays.yaml", study_text()), {{"points=[16]"}},
                                      {.output = dir / "b", .shard = 1, .shards = 2});
  CHECK(again.complete_and_ok());
  CHECK(again.runs == 1);
  CHECK_THROWS_WITH(run_study_text(study_text(), "rays.yaml", {}, {}, {.output = dir / "c", .shard = 2, .shards = 2}),
                    Contains("must be from 0 to 1"));
  try {
    run_study_text(study_text() + "solvres: []\n", "rays.yaml", {}, {}, {.output = dir / "c"});
    FAIL("no exception");
  } catch (const ConfigError& e) {
    CHECK_THAT(e.diagnostics().render(), Contains("rays.yaml:10") && Contains("did you mean 'solvers'"));
  }
}

TEST_CASE("run_study: a stopped one is resumed") {
  register_own_plugins();
  const ScratchDir dir;
  StudyOptions options{.output = dir / "a"};
  std::size_t finished = 0;
  options.observe = [&](std::size_t count, std::size_t) { finished = count; };
  options.stop_requested = [&] { return finished >= 1; };
  const StudyResult stopped = run_study_text(study_text(), "rays.yaml", {}, {}, options);
  CHECK(stopped.interrupted);
  CHECK_FALSE(stopped.complete_and_ok());
  CHECK(stopped.runs + static_cast<long>(stopped.missing) == 4);
  options.stop_requested = {};
  options.resume = true;
  CHECK(run_study_text(study_text(), "rays.yaml", {}, {}, options).complete_and_ok());
}

TEST_CASE("write_report and write_figure: from the files of a run") {
  register_own_plugins();
  const ScratchDir dir;
  const RunOutcome outcome = solve(parse_run(kRay, "ray.yaml"));
  write_run(outcome, dir / "run");
  CHECK(write_report(dir / "run") == dir / "run/report.html");
  const std::vector<ReportFile> report = make_report(dir / "run");
  REQUIRE(report.size() == 1);
  CHECK(report[0].name == "report.html");
  CHECK(report[0].content == content(dir / "run/report.html"));
  const WrittenFigure figure = write_figure(dir / "run", dir / "ray.svg", {.width = "60mm"});
  CHECK(figure.width == Approx(60));
  CHECK(figure.height > 10);
  CHECK_THAT(content(dir / "ray.svg"), Contains("<svg") && Contains("60mm"));
  CHECK_THROWS_WITH(write_figure(dir / "run", dir / "ray.gif"), Contains("gif"));
  CHECK_THROWS_AS(write_figure(dir / "run", dir / "ray.svg", {.width = "wide"}), InputError);
  CHECK_THROWS_AS(write_report(dir / "nowhere"), InputError);
}

}  // namespace leastcost::test
