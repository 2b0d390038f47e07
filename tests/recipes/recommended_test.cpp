// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// What is recommended for a problem, by what its objects are (recipes), and that it is what a configuration runs.
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <regex>
#include <string>

#include <leastcost/leastcost.hpp>

#include "catalogue/run/load_run.hpp"
#include "catalogue/run/run_origin.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

std::shared_ptr<const ConstraintManifold> plane(const BoxOptions& box = {}) {
  return std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2, .box = box});
}

Problem across(std::shared_ptr<const ConstraintManifold> domain, std::shared_ptr<const SegmentCost> cost) {
  Problem problem;
  problem.manifold = std::move(domain);
  problem.cost = std::move(cost);
  problem.source.u = Vector2d(-2, 0.1);
  problem.target.u = Vector2d(2, -0.1);
  return problem;
}

Problem around_discs() {
  FreeSpace::Obstacles discs = {make_ball({.center = Vector2d(0, 0), .radius = 0.5})};
  return across(std::make_shared<FreeSpace>(plane(), std::move(discs), 0), make_euclidean_cost(2));
}

const BoxOptions kBox{.lower = Vector2d(-3, -3), .upper = Vector2d(3, 3)};

std::shared_ptr<const SegmentCost> lens() {
  return make_refractive_index_cost({.index = refraction::Formula{.n = "1 + 2 * exp(-x^2 - y^2)"}}, 2);
}

Problem on_hill() {
  const auto mesh = std::make_shared<MeshManifold>(TriangleMesh(read_mesh(project_dir() / "configs/data/hill.obj")));
  Problem problem;
  problem.manifold = mesh;
  problem.cost = make_euclidean_cost(3);
  problem.source = mesh->vertex(0);
  problem.target = mesh->vertex(80);
  return problem;
}

std::string names(const Recipe& recipe) {
  std::string text = recipe.initializer ? std::string(recipe.initializer->name()) : "-";
  text += " " + std::string(recipe.solver->name());
  for (const auto& step : recipe.post_processors) text += " " + std::string(step->name());
  return text;
}

/// Whether a configuration leaves first path, solver and post-processors to the defaults, for one open path.
bool leaves_methods_open(const std::string& text) {
  static const std::regex stated(
      R"((^|\n)(initializer|solver|post_process|family|extends):|pairs:|ring: true|max_seconds)");
  return !std::regex_search(text, stated);
}

}  // namespace

TEST_CASE("recipes: the objects of a problem decide") {
  CHECK(names(recommended(across(plane(), make_euclidean_cost(2)))) == "straight newton");
  CHECK(names(recommended(across(plane(), lens()))) == "eikonal newton");
  CHECK(names(recommended(across(plane(), make_travel_time_cost({.start_speed = 1}, 2, Vector2d(-2, 0.1))))) ==
        "straight newton");
  CHECK(names(recommended(around_discs())) == "grid none taut shortest_plan");
  CHECK(names(recommended(on_hill())) == "dijkstra none trace straighten shortest");
  FindOptions local;
  local.certificate.global = GlobalOff{};
  CHECK(names(recommended(on_hill(), local)) == "dijkstra lbfgs trace straighten");
  FindOptions bounded;
  bounded.certificate.global = GlobalBudget{.tolerance = 1e-3};
  CHECK(names(recommended(across(plane(kBox), lens()), bounded)) == "eikonal newton bracket");
  Problem ring = around_discs();
  ring.ring = true;
  CHECK(names(recommended(ring)) == "- newton");
  CHECK_THROWS_WITH(find_path(ring), Catch::Contains("a ring has no default first path"));
  CHECK_THROWS_WITH(recommended({}), Catch::Contains("needs a problem with a manifold and a cost"));
}

TEST_CASE("recipes: a mesh geodesic is proved by default") {
  const Result result = find_path(on_hill());
  CHECK(result.certificate.certified());
  CHECK(result.certificate.scope == Scope::global_on_polyhedron);
}

TEST_CASE("recipes: a bound that is asked for is made, whoever chooses the methods") {
  FindOptions options;
  options.certificate.global = GlobalBudget{.tolerance = 1e-3};
  Problem problem = across(plane(kBox), lens());
  const Result recommended = find_path(problem, options);
  problem.kernel = make_kernel<Expm1Square>();
  const Result chosen = find_path(problem, EikonalInitializer(), Newton(), options);
  for (const Result* result : {&recommended, &chosen}) {
    REQUIRE(result->certificate.global);
    CHECK(result->certificate.global->proved);
    CHECK(result->certificate.scope == Scope::global);
    CHECK(result->certificate.global->lower_bound <= result->certificate.estimate.value);
  }
  Problem mesh = on_hill();
  mesh.kernel = problem.kernel;
  options.certificate.global = GlobalBudget{};
  const Result walked = find_path(mesh, DijkstraInitializer(), Lbfgs(), options);
  CHECK(walked.certificate.scope == Scope::global_on_polyhedron);
}

TEST_CASE("recipes: a bound that nobody can make is a note") {
  FindOptions options;
  options.certificate.global = GlobalBudget{};
  Problem problem = across(plane(), lens());  // no box
  problem.kernel = make_kernel<Expm1Square>();
  const Result result = find_path(problem, StraightInitializer(), Newton(), options);
  CHECK_FALSE(result.certificate.global);
  CHECK_THAT(result.notes.back(), Catch::Contains("certificate.global: there is no bound over all paths"));
  CHECK_THAT(result.notes.back(), Catch::Contains("give the manifold finite bounds"));
}

TEST_CASE("recipes: a configuration without options runs the same methods") {
  struct Same {
    const char* config;
    Problem problem;
  };
  const Same same = GENERATE(
      Same{"{manifold: {type: mesh, file: hill.obj}, cost: euclidean, ends: {source: {vertex: 0}, target: {vertex: "
           "80}}}",
           on_hill()},
      Same{"{manifold: euclidean, obstacles: [{type: ball, center: [0, 0], radius: 0.5}], cost: euclidean, "
           "ends: {source: {point: [-2, 0.1]}, target: {point: [2, -0.1]}}}",
           around_discs()},
      Same{"{manifold: euclidean, cost: {type: refractive_index, index: {type: formula, n: 1 + 2 * exp(-x^2 - y^2)}}, "
           "ends: {source: {point: [-2, 0.1]}, target: {point: [2, -0.1]}}}",
           across(plane(), lens())});
  CAPTURE(same.config);
  const Run run = parse_run(same.config, "same", project_dir() / "configs/data");
  Recipe recipe = recommended(same.problem);
  Recipe of_run{run.parts.initializer, run.parts.solver, run.parts.options.post_processors, {}};
  CHECK(names(of_run) == names(recipe));
  CHECK(run.origin->why == recipe.why);
  REQUIRE(recipe.why.size() == 4);
  const std::array<const char*, 4> parts = {"first path: ", "solver: ", "post-processors: ", "proof over all paths: "};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    CHECK(recipe.why[i].find(parts[i]) == 0);
    CHECK_THAT(recipe.why[i], Catch::Contains(", because "));
  }
}

TEST_CASE("recipes: no reason is given for what a configuration states") {
  const std::string text =
      "{manifold: {type: mesh, file: hill.obj}, cost: euclidean, solver: lbfgs, initializer: "
      "dijkstra, ends: {source: {vertex: 0}, target: {vertex: 80}}, certificate: {global: off}}";
  const Run run = parse_run(text, "stated", project_dir() / "configs/data");
  REQUIRE(run.origin->why.size() == 1);
  CHECK(run.origin->why[0].find("post-processors: trace, because") == 0);
}

TEST_CASE("recipes: where there is no proof over all paths the reason names what there is, and it is taken as told") {
  const auto run = [](const std::string& more) {
    return parse_run(
        "{manifold: {type: euclidean, lower: [-3, -3], upper: [3, 3]}, cost: {type: refractive_index, index: {type: "
        "formula, n: 1 + x^2}}, ends: {source: {point: [-2, 0.1]}, target: {point: [2, -0.1]}}" +
            more + "}",
        "boxed", project_dir() / "configs/data");
  };
  const std::string why = run("").origin->why.back();
  REQUIRE_THAT(why, Catch::Contains("none, because no search over all paths exists for this domain and cost"));
  const std::string remedy = why.substr(why.find('(') + 1, why.rfind(')') - why.find('(') - 1);
  const Run bracketed = run(", " + remedy);
  CHECK(bracketed.parts.options.post_processors.back()->name() == "bracket");
  CHECK(bracketed.origin->why.size() == 3);  // the proof is stated now
}

TEST_CASE("recipes: a cheaper way beside a straight first path is named, and taken as told") {
  // A dear ellipse with a narrow hole, through which the straight line goes.
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 3});
  problem.cost = make_refractive_index_cost(
      {.index = refraction::Formula{.n = "1 + 30 * exp(-(z/0.3)^2) * (1 - 0.5 * exp(-(x^2 + y^2)/0.04)) * "
                                         "exp(-((x^2 + 2 * y^2)/1.5)^2)"}},
      3);
  problem.source.u = Vector3d(0, 0, -2);
  problem.target.u = Vector3d(0, 0, 2);
  FindOptions options;
  options.points = 32;
  options.certificate.enabled = false;
  const Result through = find_path(problem, options);
  REQUIRE_FALSE(through.notes.empty());
  const std::string note = through.notes.back();
  const std::regex told(
      R"(another path costs about ([0-9.]+), .*BowInitializer\(\{\.height = ([0-9.]+), \.angle = ([0-9.]+)\}\))");
  std::smatch numbers;
  REQUIRE(std::regex_search(note, numbers, told));
  const BowOptions bow{std::stod(numbers[2]), std::stod(numbers[3])};
  const Result around = find_path(with_kernel(problem), BowInitializer(bow), Newton(), options);
  CHECK(around.curve.cost < 0.9 * through.curve.cost);
  CHECK(around.curve.cost == Approx(std::stod(numbers[1])).epsilon(0.01));

  Monitor limited;
  limited.deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  for (const std::string& word : find_path(problem, options, limited).notes)
    CHECK_THAT(word, !Catch::Contains("another way"));
  // Nothing is looked for where there is nothing to see.
  CHECK(recommended(problem).one_way);
  problem.cost = make_euclidean_cost(3);
  CHECK_FALSE(recommended(problem).one_way);
  CHECK_FALSE(recommended(across(plane(), lens())).one_way);
}

TEST_CASE("recipes: of what the configurations compose, the objects say the same as the types") {
  int compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(project_dir() / "configs")) {
    if (entry.path().extension() != ".yaml") continue;
    std::ifstream in(entry.path());
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!leaves_methods_open(text)) continue;
    CAPTURE(entry.path().filename().string());
    const Run run = load_run(entry.path());
    // Places without data become obstacles when the files are read, after the types have chosen.
    const bool walls = find_ability<HasWalls>(*run.parts.problem.manifold) != nullptr;
    if (walls && text.find("obstacles:") == std::string::npos) continue;
    FindOptions options = run.parts.options;
    options.certificate.global = GlobalAuto{};
    for (const auto& step : run.parts.options.post_processors)
      if (step->name() == "bracket") options.certificate.global = GlobalBudget{};
    const Recipe of_run{run.parts.initializer, run.parts.solver, run.parts.options.post_processors, {}};
    CHECK(names(of_run) == names(recommended(run.parts.problem, options)));
    ++compared;
  }
  CHECK(compared > 30);
}

}  // namespace leastcost::test
