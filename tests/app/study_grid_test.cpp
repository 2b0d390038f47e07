// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <set>

#include "app/study/study_facts.hpp"
#include "tests/app/study_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

using Catch::Contains;

namespace {

app::StudyGrid good_grid(const std::string& text) {
  std::string errors;
  app::StudyGrid grid = grid_of(text, errors);
  REQUIRE(errors == "");
  return grid;
}

std::string joined_values(const app::StudyCell& cell) {
  std::string out;
  for (const std::string& value : cell.values) out += value + " ";
  return out;
}

}  // namespace

TEST_CASE("study grid: the last axis runs fastest, every cell has its options") {
  const app::StudyGrid grid = good_grid(kStudy + "seeds: [7]\nsweep: {path.cascade: [true, false]}\n");
  REQUIRE(grid.cells.size() == 16);
  CHECK(grid.swept_keys == std::vector<std::string>{"path.cascade"});
  CHECK(joined_values(grid.cells[0]) == "line newton expm1_square 8 7 true ");
  CHECK(joined_values(grid.cells[1]) == "line newton expm1_square 8 7 false ");
  CHECK(joined_values(grid.cells[2]) == "line newton expm1_square 12 7 true ");
  CHECK(joined_values(grid.cells[4]) == "line lbfgs expm1_square 8 7 true ");
  CHECK(joined_values(grid.cells[8]) == "chute newton expm1_square 8 7 true ");
  for (std::size_t i = 0; i < grid.cells.size(); ++i) CHECK(grid.cells[i].number == static_cast<long>(i));
  CHECK(grid.cells[15].config.points == 12);
  CHECK_FALSE(grid.cells[15].config.cascade);
  CHECK(grid.cells[15].config.seed == 7);
  CHECK(grid.cells[0].optimum == 5);
}

TEST_CASE("study grid: an axis that is not given takes what the configuration says") {
  const app::StudyGrid grid = good_grid(kStudy.substr(0, kStudy.find("solvers")) + "set: {path.points: 33}\n");
  REQUIRE(grid.cells.size() == 2);
  CHECK(grid.cells[0].values[1] == "newton");
  CHECK(grid.cells[0].values[3] == "33");
}

TEST_CASE("study grid: seeds depend on the master seed and the problem, on nothing else") {
  const app::StudyGrid a = good_grid(kStudy), b = good_grid("seed: 1\n" + kStudy);
  std::set<int> of_line, of_chute;
  for (const app::StudyCell& cell : a.cells) (cell.values[0] == "line" ? of_line : of_chute).insert(cell.config.seed);
  CHECK(of_line.size() == 1);
  CHECK(of_chute.size() == 1);
  CHECK(*of_line.begin() != *of_chute.begin());
  CHECK(a.cells[0].config.seed != b.cells[0].config.seed);
  const std::string own =
      "problems:\n  - name: x\n    config: {seed: 5, manifold: euclidean, cost: euclidean, ends: "
      "{source: {point: [0, 0]}, target: {point: [1, 0]}}}\n";
  CHECK(good_grid(own).cells[0].config.seed == 5);
}

TEST_CASE("study grid: what a problem sets is its own, limits reach every cell") {
  const app::StudyGrid grid = good_grid(
      "set: {path.points: 10, certificate.spacing: 0.5}\nmax_seconds: 9\nmax_evaluations: 77\nproblems:\n"
      "  - {name: a, set: {path.points: 20}, config: {manifold: euclidean, cost: euclidean, ends: {source: {point: [0, "
      "0]}, target: {point: [1, 0]}}}}\n"
      "  - {name: b, config: {manifold: euclidean, cost: euclidean, ends: {source: {point: [0, 0]}, target: {point: "
      "[1, "
      "0]}}}}\nsolvers: [newton, {name: own limit, type: lbfgs, max_evaluations: 5}]\n");
  REQUIRE(grid.cells.size() == 4);
  CHECK(grid.cells[0].config.points == 20);
  CHECK(grid.cells[2].config.points == 10);
  CHECK(grid.cells[2].config.certificate.spacing == 0.5);
  CHECK(grid.cells[1].config.max_seconds == 9);
  CHECK_THAT(resolved_yaml(grid.cells[0].config), Contains("max_evaluations: 77"));
  CHECK_THAT(resolved_yaml(grid.cells[1].config), Contains("max_evaluations: 5"));
}

TEST_CASE("study grid: options of solvers that are set hold for each that does not say otherwise") {
  std::string text = kStudy;
  text.replace(text.find("lbfgs"), 5, "{type: lbfgs, max_iterations: 5}");
  const app::StudyGrid grid = good_grid(text + "set: {solver.max_iterations: 7}\n");
  CHECK_THAT(resolved_yaml(grid.cells[0].config), Contains("max_iterations: 7"));
  CHECK_THAT(resolved_yaml(grid.cells[2].config), Contains("max_iterations: 5"));
}

TEST_CASE("study grid: cells are left out with a reason, and keep their numbers") {
  const app::StudyGrid grid = good_grid(kStudy + "skip: [{solver: lbfgs, points: [12], because: too slow}]\n");
  REQUIRE(grid.cells.size() == 8);
  for (const app::StudyCell& cell : grid.cells)
    CHECK(cell.skipped == (cell.values[1] == "lbfgs" && cell.values[3] == "12" ? "too slow" : ""));
}

TEST_CASE("study grid: a problem that is optional is skipped where its file is missing") {
  const std::string mesh =
      "problems:\n  - {name: m, optional: OPT, config: {manifold: {type: mesh, file: nowhere.obj}, "
      "cost: euclidean, ends: {source: {vertex: 0}, target: {vertex: 1}}}}\n";
  const std::size_t at = mesh.find("OPT");
  CHECK(good_grid(std::string(mesh).replace(at, 3, "true")).cells[0].skipped == "there is no file nowhere.obj");
  CHECK(good_grid(std::string(mesh).replace(at, 3, "false")).cells[0].skipped == "");
}

TEST_CASE("study errors: each at its place, said once for all cells") {
  const auto check = [](const std::string& text, const std::string& message) {
    CAPTURE(text);
    CHECK_THAT(study_errors(text), Contains(message));
  };
  check("nam: x\n" + kStudy, "a.yaml:1:1: error: unknown key 'nam' (did you mean 'name'?)");
  check("solvers: [newton]\n", "missing key 'problems'");
  check("problems: []\n", "'problems' must be a list of blocks (found an empty list)");
  check(kStudy + "kernels: [square, cubic]\n", "a.yaml:15:19: error: unknown kernel 'cubic'");
  check(kStudy + "kernels: [square, square]\n", "two values of the axis kernel are called 'square'");
  check(kStudy + "sweep: {path.cascad: [true]}\n", "unknown key 'cascad' in path (did you mean 'cascade'?)");
  check(kStudy + "sweep: {path.cascade: true}\n", "'sweep' must be a block of options with lists of values");
  check(kStudy + "sweep: {path.points: [1]}\n", "'path.points' has an axis of its own: points");
  check(kStudy + "seeds: [1.5]\n", "'seeds' has an entry that must be a whole number in digits");
  check(kStudy + "repetitions: 0\n", "'repetitions' must be at least 1");
  check(kStudy + "set: {solver.tolerance: x}\n", "must be a finite number (found 'x')");
  check(kStudy + "set: {path.points: 5}\n", "'path.points' is an axis of this study: its values are under points");
  check(kStudy + "set: {solver: newton}\n", "'solver' is an axis of this study");
  check(kStudy + "skip: [{solver: newto, because: x}]\n",
        "no value of the axis solver is called 'newto' (did you mean 'newton'?)");
  check(kStudy + "skip: [{solver: newton}]\n", "missing key 'because' in skip[0]");
  check(kStudy + "skip: [{because: x}]\n", "would leave out every cell");
  check(kStudy + "skip: [{sover: newton, because: x}]\n", "unknown key 'sover' in skip[0] (did you mean 'solver'?)");
  check("problems:\n  - {config: {manifold: euclidean}}\n", "an inline problem needs a name");
  check("problems:\n  - {name: a, config: {cost: euclidean}}\n", "a.yaml:2:23: error: missing key 'manifold'");
  check("problems:\n  - {config: nowhere.yaml}\n", "a.yaml:2:14: error: nowhere.yaml: cannot be opened");
  CHECK(study_errors("manifold: euclidean\ncost: euclidean\nsolver: newton\n") ==
        "a.yaml:1:1: error: this file has 'manifold', so it is a run: run it with leastcost run\n    1 | manifold: "
        "euclidean\n      | "
        "^~~~~~~~\n");
  CHECK_THAT(study_errors("points: ['auto']\n"), !Contains("whole number"));

  const std::string twice = study_errors(kStudy + "set: {path.points: 0}\nsweep: {kernel: [expp]}\n");
  CHECK(twice.find("unknown kernel 'expp'") == twice.rfind("unknown kernel 'expp'"));
}

TEST_CASE("study errors: what only composing shows is found where it is asked for, at its place") {
  const std::string bent = "[[1, 0], [0, -1]]";
  std::string composed = kStudy;
  composed.replace(composed.find("cost: euclidean"), 15, "cost: {type: metric_tensor, matrix: " + bent + "}");
  CHECK(study_errors(composed) == "");
  app::LoadedStudy study = app::parse_study(composed, "a.yaml", ".");
  app::make_grid(study, app::CellChecks::parts);
  CHECK_THAT(study.errors.render(), Contains("a.yaml:5:") && Contains("'matrix' in cost") && Contains(bent));
  // A key or a type that is wrong in a later cell is told all the same.
  composed.replace(composed.find("gravity: 1"), 10, "gravty: 1");
  CHECK_THAT(study_errors(composed), Contains("unknown key 'gravty' in cost (did you mean 'gravity'?)"));
}

TEST_CASE("study errors: those of a problem's file are named at its place in the study, with their place in the file") {
  const ScratchDir dir;
  std::ofstream(dir / "run.yaml") << "manifold: euclidean\ncost: euclidian\nends: {source: {point: [0, 0]}, target: "
                                     "{point: [1, 0]}}\n";
  std::ofstream(dir / "study.yaml") << "problems: [{config: run.yaml}]\nsolvers: [newton, lbfgs]\n";
  CHECK_THROWS_WITH(app::load_grid(dir / "study.yaml", {}),
                    Contains("study.yaml:1:21: error: ") && Contains("| problems: [{config: run.yaml}]\n") &&
                        Contains("run.yaml:2:7: unknown cost 'euclidian' (did you mean 'euclidean'?)") &&
                        Contains("1 error in"));
  std::ofstream(dir / "run.yaml") << "manifold: [\n";
  CHECK_THROWS_WITH(app::load_grid(dir / "study.yaml", {}),
                    Contains("study.yaml:1:21: error: ") && Contains("run.yaml:2:1: YAML"));
  std::ofstream(dir / "run.yaml") << "problems: []\n";
  CHECK_THROWS_WITH(app::load_grid(dir / "study.yaml", {}), Contains("so it is a study"));
}

TEST_CASE("study facts: options and data count, names and places do not") {
  const ScratchDir dir;
  const auto write = [&](const std::string& folder, const std::string& tolerance, const std::string& corner) {
    std::filesystem::create_directories(dir / folder);
    std::ofstream(dir / (folder + "/m.obj")) << "v 0 0 0\nv 1 0 0\nv " << corner << " 1 0\nf 1 2 3\n";
    std::ofstream(dir / (folder + "/s.yaml")) << "# a note\nproblems: [{name: m, config: {manifold: {type: mesh, file: "
                                                 "m.obj}, cost: euclidean, ends: {source: "
                                                 "{vertex: 0}, target: {vertex: 1}}, solver: {type: newton, tolerance: "
                                              << tolerance << "}}}]\n";
    return app::facts_of(app::load_grid(dir / (folder + "/s.yaml"), {}));
  };
  const app::StudyFacts a = write("a", "1e-9", "0"), moved = write("b", "1.0e-9", "0");
  CHECK(app::difference(a, moved) == "");
  CHECK_THAT(app::difference(a, write("c", "1e-8", "0")), Contains("options of its cells"));
  CHECK_THAT(app::difference(a, write("d", "1e-9", "0.5")), Contains("the data file m.obj has changed"));
}

TEST_CASE("study: resolved, it is the same study") {
  const ScratchDir dir;
  std::ofstream(dir / "s.yaml") << kStudy << "set: {certificate.spacing: 0.1}\nsweep: {path.cascade: [true, false]}\n"
                                << "skip: [{solver: lbfgs, path.cascade: true, because: why not}]\n";
  const app::StudyGrid grid = app::load_grid(dir / "s.yaml", {});
  std::filesystem::create_directories(dir / "out");
  std::ofstream(dir / "out/study.resolved.yaml") << app::resolved_study(grid, dir / "out");
  const app::StudyGrid again = app::load_grid(dir / "out/study.resolved.yaml", {});
  CHECK(app::difference(app::facts_of(grid), app::facts_of(again)) == "");
  CHECK(app::facts_of(grid).skipped.size() == 4);
}

TEST_CASE("study: --set may narrow an axis that a skip speaks of") {
  app::LoadedStudy study = app::parse_study(kStudy + "skip: [{solver: lbfgs, points: [12], because: x}]\n", "a.yaml",
                                            ".", {set_option("solvers=[newton]")});
  CHECK(app::make_grid(study).cells.size() == 4);
  CHECK(study.errors.render() == "");
}

TEST_CASE("study: --set reaches the study's own keys and the paths of its set and sweep") {
  const std::vector<Override> overrides = {set_option("set.path.points=5"), set_option("repetitions=3"),
                                           set_option("sweep.path.cascade=[true]"), seed_option("4")};
  app::LoadedStudy study = app::parse_study(kStudy.substr(0, kStudy.find("points: [")), "a.yaml", ".", overrides);
  const app::StudyGrid grid = app::make_grid(study);
  REQUIRE(study.errors.render() == "");
  CHECK(grid.config.repetitions == 3);
  CHECK(grid.config.seed == 4);
  CHECK(grid.cells[0].config.points == 5);
  CHECK(grid.cells[0].config.cascade);
}

}  // namespace leastcost::test
