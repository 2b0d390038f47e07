// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/app/report/report.hpp>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include <leastcost/framework/base/errors.hpp>
#include "app/plot/text.hpp"
#include "app/report/page/page.hpp"
#include "app/report/page/viewer_script.hpp"
#include "app/run/run.hpp"
#include "app/study/rows/run_table.hpp"
#include "catalogue/output/manifest.hpp"
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;

namespace {

const char* const kTorus = R"(manifold: {type: parametric, surface: torus}
cost: euclidean
ends: {source: {point: [0, 0]}, target: {point: [1, 2]}}
path: {points: 15}
family: {windings: 1}
)";

void write_bytes(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

fs::path run_of(const ScratchDir& dir, const std::string& config, const std::string& name = "run") {
  write_bytes(dir / (name + ".yaml"), config);
  const app::WrittenRun outcome = app::run({dir / (name + ".yaml"), {}, dir / name, false, {"leastcost", "run"}}, {});
  REQUIRE(outcome.output_error == "");
  return dir / name;
}

/// The names of what lies in a folder.
std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// A study of two solvers on one problem with 9 and 99 points: 10 and 100 segments.
fs::path study_in(const fs::path& folder) {
  app::RunTable runs;
  std::vector<app::TraceRow> traces;
  for (long cell = 0; cell < 4; ++cell) {
    app::RunRow row;
    row.cell = cell;
    row.problem = "torus <b>";
    row.solver = cell % 2 == 0 ? "newton" : "plain";
    row.kernel = "square";
    row.points = cell < 2 ? 9 : 99;
    row.outcome = cell == 3 ? app::outcome::kTimeout : app::outcome::kOk;
    if (cell < 3) {
      row.status = "certified";
      row.termination = "converged";
      row.evaluations = cell == 1 ? 400 : 9;
      row.s_solve = 0.001 * static_cast<double>(cell + 1);
      row.final_energy = 50;
      row.energy_slope = 100;
      row.optimum = 3;
      row.optimum_error = row.points == 9 ? 1e-4 : 1e-8;
      row.chain_cost = row.points == 9 ? 2.97 : 2.9997;
      row.cost_error_bar = 1e-3;
      traces.push_back({cell, 0, 0, 1, 0.0005, 90, 0.1, 0});
      traces.push_back({cell, 0, 1, *row.evaluations, *row.s_solve, 50, 1e-12, 0.1});
    }
    runs.rows.push_back(row);
  }
  fs::create_directories(folder);
  write_bytes(folder / "runs.csv", app::runs_csv(runs));
  write_bytes(folder / "traces.csv", app::traces_csv(traces));
  write_bytes(folder / "summary.json", R"({"name": "a study"})");
  write_bytes(folder / "study.resolved.yaml", "name: a study\n");
  ManifestFacts facts;
  facts.kind = "study";
  write_bytes(folder / "manifest.json", manifest_json(facts));
  return folder;
}

/// Without printing the page, which is long.
void check_holds(const std::string& page, std::initializer_list<const char*> parts) {
  for (const char* part : parts) {
    CAPTURE(part);
    CHECK(page.find(part) != std::string::npos);
  }
}
void check_lacks(const std::string& page, const char* part) {
  CAPTURE(part);
  CHECK(page.find(part) == std::string::npos);
}

/// What a page may not hold: anything that a browser would fetch.
void check_stands_alone(const std::string& page) {
  for (const char* fetched :
       {"src=\"", "href=\"http", "@import", "url(http", "fetch(\"", "<iframe", "<link rel=\"stylesheet"}) {
    CAPTURE(fetched);
    CHECK(page.find(fetched) == std::string::npos);
  }
}

}  // namespace

TEST_CASE("report: made again from its folder it is the one that the run wrote") {
  const ScratchDir dir;
  const fs::path folder = run_of(dir, kTorus);
  const std::string first = content(folder / "report.html");
  check_holds(first, {"certified, local", "Family", "winding (1, 1)", "Provenance"});
  check_stands_alone(first);
  fs::remove(folder / "report.html");
  const std::vector<std::string> before = names_in(folder);
  CHECK(write_report(folder) == folder / "report.html");
  CHECK(content(folder / "report.html") == first);
  fs::remove(folder / "report.html");
  CHECK(names_in(folder) == before);  // nothing else was left behind
}

TEST_CASE("report: the 3D view goes with its script, a still picture is always there") {
  const ScratchDir dir;
  const std::string page = content(run_of(dir, kTorus) / "report.html");
  check_holds(page, {"id=\"stage\"", "class=\"path"});
  if (app::viewer_script().empty()) {
    check_holds(page, {"built without npm"});
    check_lacks(page, "<script");
    return;
  }
  check_holds(page, {"<script type=\"application/json\" id=\"scene\">", "Three.js Authors"});
  // Within the scripts, nothing may end them but their own end.
  CHECK(app::viewer_script().find("</script") == std::string_view::npos);
}

TEST_CASE("report: a robot in space has a picture among its obstacles and a slider for its poses") {
  const ScratchDir dir;
  const std::string page = content(run_of(dir, R"(manifold: robot
robot: {type: dh_arm, model: panda}
obstacles: [{type: ball, center: [0.6, 0, 0.9], radius: 0.1}]
cost: euclidean
ends:
  source: {point: [0.9, -0.785, 0, -2.356, 0, 1.571, 0.785]}
  target: {point: [-0.5, -0.785, 0, -2, 0, 1.571, 0.785]}
path: {points: 8}
certificate: {enabled: false}
)") / "report.html");
  check_holds(page,
              {"id=\"stage\"", "class=\"hand", "data:image/png;base64,", "x (m)", "obstacles", "Coordinates along"});
  if (app::viewer_script().empty()) return;
  check_holds(page, {"id=\"pose\" min=\"0\"", "\"workspace\":{"});
  CHECK(page.find("id=\"scene\"") == page.rfind("id=\"scene\""));
}

TEST_CASE("report: every kind of picture") {
  const ScratchDir dir;
  const std::string plane = content(run_of(dir, kPlane, "plane") / "report.html");
  check_holds(plane, {"The path in the plane"});
  check_lacks(plane, "<script");
  const std::string chute =
      content(run_of(dir, R"(manifold: {type: euclidean, dimension: 2, lower: [0, -1.1], upper: [3, 0]}
cost: {type: travel_time, gravity: 1}
ends: {source: {point: [0, 0]}, target: {point: [3, -1]}}
)",
                     "chute") /
              "report.html");
  check_holds(chute, {"class=\"band\"", "class=\"wall\""});
  const std::string four = content(run_of(dir, R"(manifold: {type: euclidean, dimension: 4}
cost: euclidean
ends: {source: {point: [0, 0, 0, 0]}, target: {point: [1, 1, 2, 3]}}
)",
                                          "four") /
                                   "report.html");
  check_holds(four, {"Coordinates along the path", "x3"});
  const std::string ring = content(run_of(dir, R"(manifold: {type: euclidean, dimension: 2}
cost: euclidean
path: {points: 16, ring: true}
initializer: {type: waypoints, points: [[1, 0], [0, 1], [-1, 0], [0, -1]]}
)",
                                          "ring") /
                                   "report.html");
  check_holds(ring, {"collapsed"});
}

TEST_CASE("report: labels of coordinates far from 0 stand within the picture, obstacles of a terrain on its map") {
  const ScratchDir dir;
  const std::string far = content(run_of(dir, R"(manifold: {type: euclidean, dimension: 2}
cost: euclidean
ends: {source: {point: [512020.25, 4412030.25]}, target: {point: [512020.5, 4412030.75]}}
path: {points: 9}
)",
                                         "far") /
                                  "report.html");
  const std::regex label(R"re(<text x="([0-9.]+)" y="[0-9.]+" text-anchor="end">([^<]*)</text>)re");
  int seen = 0;
  for (auto at = std::sregex_iterator(far.begin(), far.end(), label); at != std::sregex_iterator(); ++at) {
    if (!(*at)[2].str().starts_with("4412030")) continue;
    constexpr double kFont = 11;
    ++seen;
    CHECK(std::stod((*at)[1]) >= kFont * app::text_width((*at)[2].str()));
  }
  CHECK(seen > 1);

  const std::string ground = content(
      run_of(dir, "manifold: {type: terrain, file: '" + (project_dir() / "configs/data/hills.asc").string() + R"('}
cost: euclidean
obstacles: [{type: polygon, corners: [[600, 300], [700, 300], [700, 800], [600, 800]]}]
clearance: 10
ends: {source: {point: [200, 700]}, target: {point: [1350, 800]}}
certificate: {enabled: false}
)",
             "ground") /
      "report.html");
  check_holds(ground, {"On the map", "class=\"obstacle\""});
}

TEST_CASE("report: texts of the user are texts") {
  const ScratchDir dir;
  const std::string page = content(
      run_of(dir, "name: \"<img src=x onerror=alert(1)>\"\n" + kPlane + "output: {folder: x}\n") / "report.html");
  CHECK(page.find("<img") == std::string::npos);
  check_holds(page, {"&lt;img src=x"});
}

TEST_CASE("report: what is missing, damaged or not ours is named, and the old report stays") {
  const ScratchDir dir;
  const fs::path folder = run_of(dir, kPlane);
  const std::string before = content(folder / "report.html");
  struct Damage {
    const char *file, *text, *says;
  };
  const auto damage =
      GENERATE(Damage{"result.json", nullptr, "cannot be read"}, Damage{"result.json", "{\"name\": ", "is not JSON"},
               Damage{"result.json", "[]", "is not a JSON object"},
               Damage{"result.json", "{}", "has no 'problem.dimensions.ambient'"},
               Damage{"path.csv", "index,x\n0,1\n", "has no column 'y'"},
               Damage{"path.csv", "index,x,y,segment_cost,cumulative_cost\n0,1,2\n", "cut off"},
               Damage{"path.csv", "index,x,y,segment_cost,cumulative_cost\n0,1,abc,1,1\n", "'abc'"},
               Damage{"history.csv", "", "is empty"}, Damage{"scene.json", "{\"dimension\": 7}", "not a scene"},
               Damage{"manifest.json", nullptr, "has no manifest.json"},
               Damage{"manifest.json", "{\"program\": \"other\"}", "was not written by leastcost"},
               Damage{"config.resolved.yaml", nullptr, "cannot be read"});
  CAPTURE(damage.file, damage.says);
  if (damage.text == nullptr)
    fs::remove(folder / damage.file);
  else
    write_bytes(folder / damage.file, damage.text);
  CHECK_THROWS_AS(write_report(folder), InputError);
  CHECK_THROWS_WITH(write_report(folder), Contains(damage.says) && Contains(damage.file));
  CHECK(content(folder / "report.html") == before);
}

TEST_CASE("report: no folder, an empty folder, a file") {
  const ScratchDir dir;
  CHECK_THROWS_WITH(make_report(dir / "nowhere"), Contains("nowhere: is not a folder"));
  CHECK_THROWS_WITH(make_report(dir.path()), Contains("has no manifest.json"));
}

TEST_CASE("report: of a study, with its figures as files") {
  const ScratchDir dir;
  const fs::path folder = study_in(dir / "study");
  write_report(folder);
  const std::string page = content(folder / "report.html");
  check_holds(page, {"a study", "torus &lt;b&gt;, n\u00a0=\u00a09", "3 of 4 solves certified", "Performance profiles",
                     "timeout"});
  check_lacks(page, "<script");
  // 9 evaluations at 9 points and at 99; the other solver never came back from 99.
  check_holds(page, {">9 → 9<", ">400 → not reached<", "As multiples of newton"});
  check_stands_alone(page);
  for (const char* figure : {"evaluations.svg", "performance.svg", "data.svg", "accuracy.svg", "order.svg"}) {
    CAPTURE(figure);
    const std::string svg = content(folder / figure);
    check_holds(svg, {"<svg", "<title>", "</svg>", "<style>"});
  }
  // 1 % off at 10 segments, a hundredth of that at 100.
  check_holds(page, {">−2.0<", ">−4.0<", "the reported value", "at some time in its run"});
  check_lacks(page, "incomplete");
  const std::string again = content(folder / "report.html");
  write_report(folder);
  CHECK(content(folder / "report.html") == again);
}

TEST_CASE("report: of a study with runs that are missing, and with solvers that stop by rules of their own") {
  const ScratchDir dir;
  const fs::path folder = study_in(dir / "study");
  check_lacks(make_report(folder)[0].content, "of their own");
  write_bytes(folder / "summary.json", R"({"name": "a part", "missing": [[4, 0], [5, 0]]})");
  std::string runs = content(folder / "runs.csv");
  for (std::size_t at = runs.find("plain"); at != std::string::npos; at = runs.find("plain"))
    runs.replace(at, 5, "georce");
  write_bytes(folder / "runs.csv", runs);
  check_holds(make_report(folder)[0].content, {"incomplete, 2 runs missing: 3 of 4 solves certified", "of their own"});
}

TEST_CASE("report: of a study, a warning where ranks by time may be chance") {
  const ScratchDir dir;
  const fs::path folder = study_in(dir / "study");
  check_holds(make_report(folder)[0].content, {"that of one repetition", "repetitions: 5"});
  // Five repetitions, all alike; then some that took twice as long.
  app::RunTable runs = app::read_runs_csv(content(folder / "runs.csv"), "runs.csv");
  const std::vector<app::RunRow> once = runs.rows;
  for (const double slower : {1.0, 2.0}) {
    runs.rows.clear();
    for (app::RunRow row : once)
      for (row.repetition = 0; row.repetition < 5; ++row.repetition) {
        runs.rows.push_back(row);
        if (row.repetition == 4 && row.s_solve) *runs.rows.back().s_solve *= slower;
      }
    write_bytes(folder / "runs.csv", app::runs_csv(runs));
    const std::string page = make_report(folder)[0].content;
    check_lacks(page, "that of one repetition");
    slower == 1 ? check_lacks(page, "The machine was busy") : check_holds(page, {"The machine was busy: in 3 of"});
  }
}

TEST_CASE("report: a damaged study is named") {
  const ScratchDir dir;
  const fs::path folder = study_in(dir / "study");
  const auto [file, text] = GENERATE(table<const char*, const char*>(
      {{"runs.csv", "cell\n"}, {"traces.csv", "cell,repetition\n0"}, {"summary.json", "{}"}, {"runs.csv", ""}}));
  CAPTURE(file, text);
  write_bytes(folder / file, text);
  CHECK_THROWS_AS(make_report(folder), InputError);
  CHECK_THROWS_WITH(make_report(folder), Contains(file));
  CHECK_FALSE(fs::exists(folder / "report.html"));
}

TEST_CASE("report: tables align numbers on their points") {
  const app::Table table{
      {{"name"}, {"value", true}}, {{{"a"}, {"12.5"}}, {{"b"}, {"3"}}, {{"c"}, {"0.125"}}, {{"d"}, {"none"}}}, ""};
  const std::string text = app::html(table);
  CHECK_THAT(text, Contains("12.5\u2007\u2007<") && Contains("3\u2008\u2007\u2007\u2007<") && Contains(">0.125<") &&
                       Contains("<td class=\"w\">none<"));
  const app::Table powers{{{"value", true}}, {{{"12.5"}}, {{"1.0 × 10⁻⁶"}}}, ""};
  CHECK_THAT(app::html(powers), Contains(">12.5<"));
}

}  // namespace leastcost::test
