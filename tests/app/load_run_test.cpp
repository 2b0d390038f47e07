// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A configuration in a program: load_run(), a change in memory, solve(), write_run().
#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include <leastcost/catalogue/catalogue.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/solvers/gradient_descent.hpp>
#include "catalogue/config/load_config.hpp"
#include "tests/app/called.hpp"
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Json = nlohmann::json;

Json json(const fs::path& file) { return Json::parse(content(file)); }

Json without_seconds(const fs::path& file) {
  Json result = json(file);
  result.erase("seconds");
  if (result.contains("global") && result["global"].is_object()) result["global"].erase("seconds");
  return result;
}

/// A table without its last column, which is wall time.
std::string without_last_column(const fs::path& file) {
  std::istringstream in(content(file));
  std::string out;
  for (std::string line; std::getline(in, line);) out += line.substr(0, line.rfind(',')) + "\n";
  return out;
}

/// The shipped configurations, in the order of their names.
std::vector<fs::path> shipped() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(project_dir() / "configs"))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// A file that the configuration names and that is not here; empty when all are.
std::string missing_file(const fs::path& config) {
  const LoadedConfig loaded = load_config(config, {});
  for (const std::string& name : files_of(loaded.config))
    if (!fs::exists(loaded.folder / name)) return name;
  return "";
}

void compare_files(const fs::path& here, const fs::path& program) {
  CHECK(without_seconds(here / "result.json") == without_seconds(program / "result.json"));
  CHECK(without_last_column(here / "history.csv") == without_last_column(program / "history.csv"));
  for (const char* name : {"path.csv", "curve.csv", "path.vtp", "path.obj", "first_path.csv", "scene.json"}) {
    CAPTURE(name);
    CHECK(content(here / name) == content(program / name));
  }
  CHECK(json(here / "manifest.json")["inputs"] == json(program / "manifest.json")["inputs"]);
  const auto names_in = [](const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  };
  std::vector<std::string> names = names_in(program);
  names.erase(std::remove(names.begin(), names.end(), "report.html"), names.end());
  CHECK(names_in(here) == names);
}

}  // namespace

TEST_CASE("a run without its parts, and results that no run made, are errors of the library") {
  const std::filesystem::path slide = test::project_dir() / "examples/load_run/slide.yaml";
  CHECK_THROWS_AS(solve(Run{}), InputError);
  Run run = load_run(slide);
  run.parts.solver = nullptr;
  CHECK_THROWS_AS(solve(run), InputError);
  run = load_run(slide);
  run.parts.initializer = nullptr;
  CHECK_THROWS_AS(solve(run), InputError);
  CHECK_THROWS_AS(write_run(RunOutcome{}, "nowhere"), InputError);
  CHECK_THROWS_AS(write_run(solve(load_run(slide)), ""), OutputError);
  CHECK_FALSE(std::filesystem::exists("nowhere"));
}

TEST_CASE("load_run: every shipped configuration gives the files of the command line", "[slow]") {
  const ScratchDir dir;
  int compared = 0;
  for (const fs::path& config : share(shipped(), 8)) {
    const std::string name = config.stem().string();
    CAPTURE(name);
    if (load_config(config, {}).config.has_pairs()) continue;  // solve() is for one path; see pairs_test.cpp
    const std::string missing = missing_file(config);
    if (!missing.empty()) {
      record_skip("load_run: " + name, missing + " is not installed");
      continue;
    }
    const Called called = call({"run", config.string(), "-q", "-o", (dir / "program" / name).string()});
    try {
      const RunOutcome outcome = solve(load_run(config));
      write_run(outcome, dir / "here" / name);
      compare_files(dir / "here" / name, dir / "program" / name);
    } catch (const InitializationError&) {
      CHECK(called.exit == 6);
    }
    ++compared;
  }
  CHECK(compared > (nightly() ? 30 : 5));
}

TEST_CASE("load_run: ways around a hill that cost the same are tied in the file of results") {
  const ScratchDir dir;
  const Run run = load_run(project_dir() / "configs/two_ways_around.yaml");
  const Json family = json(write_run(solve(run), dir / "out") / "result.json")["family"];
  REQUIRE(family.size() == 2);
  for (const Json& member : family) {
    CHECK(member["tied"] == true);
    CHECK(member["rank_cost"].get<double>() == Approx(member["cost"].get<double>()));
  }
}

TEST_CASE("load_run: what is replaced in memory is solved, and said in the files") {
  const ScratchDir dir;
  std::ofstream(dir / "a.yaml") << kPlane << "family: {bows: 2}\n";
  Run run = load_run(dir / "a.yaml", {{"path.points=9"}});
  CHECK(run.parts.options.points == 9);
  Eigen::MatrixXd four = 4 * Eigen::MatrixXd::Identity(2, 2);
  run.parts.problem.cost = make_metric_tensor_cost({.matrix = four}, 2);
  run.parts.problem.target = project_end(*run.parts.problem.manifold, Eigen::Vector2d(6, 8));
  run.parts.solver = std::make_shared<const GradientDescent>();
  run.name = "doubled";
  const RunOutcome outcome = solve(run);
  CHECK(outcome.result.curve.cost == Approx(20));
  CHECK(outcome.replaced == std::vector<std::string>{"cost", "ends", "solver"});
  const fs::path folder = write_run(outcome, dir / "out");
  const Json result = json(folder / "result.json");
  CHECK(result["name"] == "doubled");
  CHECK(result["seconds"].contains("other_members"));
  CHECK(result["problem"]["cost"].is_null());
  CHECK(result["problem"]["manifold"] == "euclidean");
  CHECK(result["solver"]["name"] == "gradient_descent");
  CHECK(result["ends"]["target"]["placed"] == Json{6, 8});
  CHECK(result["notes"].dump().find("cost: replaced after the configuration was read") != std::string::npos);
  CHECK_THAT(content(folder / "config.resolved.yaml"), Contains("which differ from this file: cost, ends, solver"));
  // The run itself is as it was: solved again, it gives the same.
  CHECK(solve(run).result.curve.cost == outcome.result.curve.cost);
}

TEST_CASE("write_run: refuses a folder that is not empty, replaces one of ours when it may") {
  const ScratchDir dir;
  const RunOutcome outcome = solve(parse_run(kPlane, "a.yaml"));
  const fs::path folder = write_run(outcome, dir / "out");
  CHECK(folder == fs::canonical(dir / "out"));
  CHECK_THROWS_AS(write_run(outcome, dir / "out"), OutputRefused);
  write_run(outcome, dir / "out", {.replace = true, .arguments = {"me", "again"}});
  const Json manifest = json(dir / "out/manifest.json");
  CHECK(manifest["arguments"] == Json{"me", "again"});
  CHECK(manifest["inputs"][0]["file"] == "<a.yaml>");
  CHECK(manifest["started"] <= manifest["finished"]);
}

TEST_CASE("parse_run: the errors of several parts at once, before any file is read") {
  const auto errors = [](const std::string& text) -> std::string {
    try {
      parse_run(text, "a.yaml", "/nonexistent");
    } catch (const ConfigError& e) {
      return e.what();
    }
    return "";
  };
  const std::string on_mesh = errors(R"(manifold: {type: mesh, file: none.obj}
cost: {type: metric_tensor, matrix: [[1, 0], [0, 1]]}
ends: {source: {vertex: 0}, target: {vertex: 1}}
initializer: {type: plane_cut, point: [0, 0, 0], normal: [0, 0, 0]}
)");
  CHECK_THAT(on_mesh, Contains("a.yaml:2:37: error: 'matrix' in cost"));
  CHECK_THAT(on_mesh, Contains("'normal' in initializer must not be zero"));
  const std::string in_plane = errors(R"(manifold: {type: constraint, set: sphere, dimension: 3}
cost: {type: metric_tensor, matrix: [[1, 0], [0, 1]]}
ends: {source: {point: [3, 0, 0]}, target: {point: [0, 1]}}
)");
  CHECK_THAT(in_plane, Contains("'point' in ends.source") && Contains("'matrix' in cost"));
  const std::string on_grid =
      errors(R"(manifold: {type: signed_distance, source: {type: mesh, file: none.obj, sign: unsigned}}
cost: {type: travel_time, start_speed: 1, level: 2}
ends: {source: {point: [0, 0, 0]}, target: {point: [0, 1, 0]}}
)");
  CHECK_THAT(on_grid, Contains("'offset' in manifold.source") && Contains("'start_speed' in cost"));
}

TEST_CASE("load_run: a throw out of the progress callback ends it") {
  struct Enough {};
  const auto stop = [](double, std::string_view) { throw Enough(); };
  CHECK_THROWS_AS(load_run(project_dir() / "configs/signed_distance_implicit.yaml", {}, stop), Enough);
}

TEST_CASE("seconds of a run: the stages are its wall time") {
  const ScratchDir dir;
  const auto start = std::chrono::steady_clock::now();
  const Called called = call(
      {"run", (project_dir() / "configs/signed_distance_implicit.yaml").string(), "-q", "-o", (dir / "out").string()});
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  REQUIRE(called.exit == 0);
  double sum = 0;
  const Json result = json(dir / "out/result.json");
  for (const auto& [stage, seconds] : result["seconds"].items()) sum += seconds.get<double>();
  CAPTURE(result["seconds"].dump());
  CHECK(sum <= wall);
  CHECK(sum > 0.85 * wall);
}

}  // namespace leastcost::test
