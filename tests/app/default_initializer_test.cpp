// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The first path that a run takes when none is asked for: one that can work, for every domain, cost and obstacle, as
// the table in docs/domains.md says.
#include <fstream>
#include <string>
#include <vector>

#include <leastcost/catalogue/catalogue.hpp>
#include "tests/app/called.hpp"
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

struct Cell {
  std::string domain, cost, obstacles, initializer;
};

const std::string kBox = "{type: euclidean, lower: [-3, -3], upper: [3, 3]}", kPlaneDomain = "{type: euclidean}",
                  kSpace = "{type: euclidean, dimension: 3}", kTorus = "{type: parametric, surface: {type: torus}}",
                  kSphere = "{type: implicit, surface: sphere}", kTerrain = "{type: terrain, file: data/hills.asc}";
const std::string kIndex = "{type: refractive_index, index: {type: formula, n: \"1 + 2 * exp(-x^2 - y^2)\"}}",
                  kMetric = "{type: metric_field, field: {type: formula, entries: [\"1 + x^2\", \"0\", \"1\"]}}",
                  kWind = "{type: zermelo, speed: 1, flow: {type: formula, velocity: [\"-y / 9\", \"0\"]}}",
                  kFormula = "{type: formula, lagrangian: \"(1 + x^2 / 9) * sqrt(vx^2 + vy^2)\"}",
                  kWalking = "{type: walking, law: {type: tobler, unit: min}}";
const std::string kDisc = "[{type: ball, center: [0, 0.3], radius: 0.5}]",
                  kBall = "[{type: ball, center: [0, 0, 1], radius: 0.3}]",
                  kBallOnTorus = "[{type: ball, center: [3, 0, 0], radius: 0.2}]",
                  kField = "[{type: polygon, corners: [[600, 300], [700, 300], [700, 800], [600, 800]]}]";

std::vector<Cell> cells() {
  std::vector<Cell> all = {{kPlaneDomain, "euclidean", "", "straight"},
                           {kSpace, "euclidean", "", "straight"},
                           {kBox, "euclidean", "", "straight"},
                           {kBox, "euclidean", kDisc, "grid"},
                           {kSpace, "euclidean", kBall, "rrt"},
                           {kTorus, "euclidean", "", "straight"},
                           {kTorus, "euclidean", kBallOnTorus, "eikonal"},
                           {kSphere, "euclidean", "", "straight"},
                           {kSphere, "euclidean", kBall, "rrt"},
                           {kTerrain, "euclidean", "", "dijkstra"},
                           {kTerrain, "euclidean", kField, "eikonal"},
                           {kTerrain, kWalking, "", "eikonal"},
                           {kTerrain, kWalking, kField, "eikonal"}};
  for (const std::string& cost : {kIndex, kMetric, kWind, kFormula})
    for (const std::string& obstacles : {std::string(), kDisc}) all.push_back({kBox, cost, obstacles, "eikonal"});
  return all;
}

std::string ends_of(const Cell& cell) {
  const auto between = [](const char* a, const char* b) {
    return std::string("ends: {source: {point: ") + a + "}, target: {point: " + b + "}}\n";
  };
  if (cell.domain == kTerrain) return between("[300, 500]", "[1000, 600]");
  if (cell.domain == kTorus) return between("[-0.6, 0.1]", "[0.6, -0.1]");
  if (cell.domain == kSphere) return between("[1, 0, 0]", "[0, 1, 0]");
  return cell.domain == kSpace ? between("[-1, 0, 0]", "[1, 0.5, 0]") : between("[-2, 0.1]", "[2, -0.1]");
}

}  // namespace

TEST_CASE("default initializer: every cell of the table makes a first path") {
  for (const Cell& cell : cells()) {
    std::string text = "manifold: " + cell.domain + "\ncost: " + cell.cost + "\n" + ends_of(cell);
    if (!cell.obstacles.empty()) text += "obstacles: " + cell.obstacles + "\n";
    if (cell.obstacles == kField) text += "clearance: 10\n";
    CAPTURE(text);
    const Run run = parse_run(text, "a.yaml", project_dir() / "configs");
    CHECK(run.parts.initializer->name() == cell.initializer);
    CHECK(run.parts.initializer->first_path(run.parts.problem, {}).path.u.cols() >= 2);
  }
}

TEST_CASE("default initializer: over cells the graph of their sides, however few the points and wherever data lack") {
  const ScratchDir dir;
  std::ofstream(dir / "wall.csv") << "1,1,1,1,1\n1,-9,-9,-9,1\n1,-9,1,-9,1\n1,1,1,-9,1\n";
  const std::string text =
      "manifold: euclidean\ncost: {type: cost_map, file: wall.csv, interpolation: cells, nodata: -9}\n"
      "ends: {source: {point: [2.5, 1.5]}, target: {point: [4.5, 0.5]}}\npath: {points: 2}\n";
  const RunOutcome outcome = solve(parse_run(text, "a.yaml", dir.path()));
  CHECK(outcome.parts.initializer->name() == "cell_graph");
  CHECK(outcome.result.status == Status::certified);
  // By the corners of the wall, which may be met.
  const double exact = std::hypot(0.5, 0.5) + 1 + 2 + 3 + std::hypot(0.5, 2.5);
  CHECK(outcome.result.curve.cost == Approx(exact).epsilon(1e-12));
  CHECK(outcome.result.path.u.cols() == 4);
  REQUIRE(outcome.result.certificate.global);
  CHECK(outcome.result.certificate.global->lower_bound > 0.97 * exact);
  CHECK(outcome.result.certificate.global->lower_bound <= exact);
  std::ofstream(dir / "a.yaml") << text;
  CHECK_THAT(call({"run", (dir / "a.yaml").string(), "-o", (dir / "out").string()}).out,
             Catch::Contains("no path over the cells is cheaper by more than "));
  // Where places are too many nothing is known of other ways, and a note names what helps.
  const RunOutcome few = solve(parse_run(text + "certificate: {global: {max_windows: 5}}\n", "a.yaml", dir.path()));
  REQUIRE_FALSE(few.result.certificate.global);
  const std::string note = few.result.notes.back();
  const auto begin = note.find('\'') + 1;
  const std::string remedy = note.substr(begin, note.find('\'', begin) - begin) + "\n";
  const RunOutcome enough = solve(parse_run(text + remedy, "a.yaml", dir.path()));
  REQUIRE(enough.result.certificate.global);
  CHECK(enough.result.certificate.global->lower_bound > 0.97 * exact);
}

TEST_CASE("default initializer: of equal ways around a dear square, not through it, and validate says where from") {
  const ScratchDir dir;
  std::ofstream(dir / "hill.csv") << "1,1,1,1,1,1,1\n1,1,1,1,1,1,1\n1,1,9,9,9,1,1\n1,1,9,9,9,1,1\n1,1,9,9,9,1,1\n"
                                     "1,1,1,1,1,1,1\n1,1,1,1,1,1,1\n";
  const std::string text =
      "manifold: {type: euclidean, lower: [0.5, 0.5], upper: [6.5, 6.5]}\ncost: {type: cost_map, file: hill.csv, "
      "interpolation: smooth}\n"
      "ends: {source: {point: [3.5, 6]}, target: {point: [3.5, 1]}}\n";
  const RunOutcome outcome = solve(parse_run(text, "a.yaml", dir.path()));
  CHECK(outcome.result.certificate.estimate.value == Approx(9.70019125).epsilon(1e-6));
  const std::string file = (dir / "a.yaml").string();
  std::ofstream(file) << text;
  CHECK_THAT(call({"validate", file}).out, Catch::Contains("initializer: eikonal"));
  std::ofstream(file, std::ios::app) << "initializer: straight\n";
  CHECK(call({"validate", file}).out ==
        file + ": valid\n  not checked: the contents of hill.csv; leastcost run reads it\n");
}

TEST_CASE(
    "default initializer: a raster is read as it is, and said so, unless that cannot be solved or a solver is asked "
    "for") {
  const ScratchDir dir;
  std::ofstream(dir / "wall.csv") << "1,1,1,1,1\n1,9,9,9,9\n1,1,1,1,1\n";
  const auto text = [](const std::string& more) {
    return "manifold: euclidean\ncost: {type: cost_map, file: wall.csv" + more +
           "}\nends: {source: {point: [3.5, 0.5]}, target: {point: [3.5, 2.5]}}\npath: {points: 9}\n";
  };
  const auto solved = [&](const std::string& config) { return solve(parse_run(config, "a.yaml", dir.path())); };
  // Round the end of the wall, by its corners.
  const double around = 2 * std::hypot(2.5, 0.5) + 1;
  const RunOutcome outcome = solved(text(""));
  CHECK(outcome.result.status == Status::certified);
  CHECK(outcome.result.curve.cost == Approx(around).epsilon(1e-12));
  REQUIRE_FALSE(outcome.parts.notes.empty());
  CHECK_THAT(outcome.parts.notes.front(), Catch::Contains("interpolation: cells"));
  CHECK(solved(text(", interpolation: auto")).result.curve.cost == outcome.result.curve.cost);
  CHECK(solved(text(", interpolation: cells")).parts.notes.empty());

  const double between = solved(text(", interpolation: smooth")).result.curve.cost;
  CHECK(between > 1.1 * around);
  const std::string ball = "obstacles: [{type: ball, center: [4.5, 0.5], radius: 0.1}]\n";
  for (const std::string& more : {std::string("solver: newton\n"), ball}) {
    const RunOutcome other = solved(text("") + more);
    CHECK(other.result.curve.cost == Approx(between).epsilon(1e-6));
    REQUIRE_FALSE(other.parts.notes.empty());
    CHECK_THAT(other.parts.notes.front(), Catch::Contains("interpolation: smooth"));
    CHECK((other.parts.notes.front().find("a solver is given") != std::string::npos) == (more != ball));
  }
  // A clearance is one from places without data, which are obstacles of the smooth surface.
  std::ofstream hole(dir / "hole.csv");
  for (int row = 0; row < 9; ++row)
    for (int column = 0; column < 12; ++column)
      hole << (row == 4 && column == 6 ? "nan" : "1") << (column < 11 ? "," : "\n");
  hole.close();
  const RunOutcome kept = solved(
      "manifold: euclidean\ncost: {type: cost_map, file: hole.csv}\nclearance: 0.3\n"
      "ends: {source: {point: [1, 3]}, target: {point: [11, 6]}}\npath: {points: 40}\n");
  CHECK(kept.result.status == Status::certified);
  CHECK(kept.result.certificate.clearance->lower >= -1e-6);
  CHECK_THAT(kept.parts.notes.front(), Catch::Contains("a clearance is given"));

  const std::string file = (dir / "a.yaml").string();
  std::ofstream(file) << text("");
  CHECK_THAT(call({"validate", file}).out, Catch::Contains("interpolation: cells"));
  CHECK(call({"run", file, "--set", "initializer.side_points=1", "-o", (dir / "out").string()}).exit == 0);
}

TEST_CASE("default initializer: over cells, what lies beyond the box of the domain is no better way") {
  const ScratchDir dir;
  std::ofstream(dir / "band.csv") << "2,2,9,2,2\n2,3,9,3,2\n1,1,1,1,1\n";
  const RunOutcome outcome = solve(
      parse_run("manifold: {type: euclidean, lower: [0, 1.2], upper: [5, 3]}\ncost: {type: cost_map, file: band.csv}\n"
                "ends: {source: {point: [0.5, 1.5]}, target: {point: [4.5, 1.5]}}\n",
                "a.yaml", dir.path()));
  CHECK(outcome.result.curve.x.row(1).minCoeff() >= 1.2);
  CHECK(outcome.result.status == Status::certified);
}

TEST_CASE("default initializer: where it is the straight line, a cheaper way beside it is named, and taken as told") {
  const ScratchDir dir;
  // A dear ellipse with a narrow hole, through which the straight line goes.
  const std::string text =
      "manifold: {type: euclidean, dimension: 3}\n"
      "cost: {type: refractive_index, index: {type: formula, n: \"1 + 30 * exp(-(z/0.3)^2) * "
      "(1 - 0.5 * exp(-(x^2 + y^2)/0.04)) * exp(-((x^2 + 2 * y^2)/1.5)^2)\"}}\n"
      "ends: {source: {point: [0, 0, -2]}, target: {point: [0, 0, 2]}}\npath: {points: 32}\n";
  const RunOutcome through = solve(parse_run(text, "a.yaml", dir.path()));
  REQUIRE_FALSE(through.parts.notes.empty());
  const std::string note = through.parts.notes.back();
  REQUIRE_THAT(note, Catch::Contains("another path costs about"));
  const auto begin = note.find('\'') + 1;
  const std::string remedy = note.substr(begin, note.find('\'', begin) - begin) + "\n";
  const RunOutcome around = solve(parse_run(text + remedy, "a.yaml", dir.path()));
  CHECK(around.result.curve.cost < 0.9 * through.result.curve.cost);
  CHECK(around.result.status == Status::certified);
  // Where there is nothing to gain nothing is said.
  const RunOutcome even = solve(parse_run(
      "manifold: {type: euclidean, dimension: 3}\ncost: {type: refractive_index, index: {type: linear_velocity, "
      "speed: 1, gradient: [0, 0, 0.2]}}\nends: {source: {point: [0, 0, 0]}, target: {point: [1, 0, 2]}}\n",
      "a.yaml", dir.path()));
  for (const std::string& word : even.parts.notes) CHECK_THAT(word, !Catch::Contains("another path costs"));
}

}  // namespace leastcost::test
