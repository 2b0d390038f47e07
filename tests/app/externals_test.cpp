// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Objects of a caller in a configuration, and configurations that are values in memory.
#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <typeinfo>
#include <vector>

#include <leastcost/catalogue/catalogue.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/obstacles/has_walls.hpp>
#include <leastcost/solvers/newton.hpp>
#include "catalogue/config/load_config.hpp"
#include "catalogue/run/compose.hpp"
#include "catalogue/run/run_origin.hpp"
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;

std::vector<std::string> methods_of(const Run& run) {
  std::vector<std::string> names = {std::string(run.parts.initializer->name()), std::string(run.parts.solver->name())};
  for (const auto& step : run.parts.options.post_processors) names.emplace_back(step->name());
  return names;
}

double cost_of(const RunOutcome& outcome) { return outcome.result.certificate.estimate.value; }

bool files_are_there(const LoadedConfig& loaded) {
  const auto names = files_of(loaded.config);
  return std::all_of(names.begin(), names.end(), [&](const std::string& n) { return fs::exists(loaded.folder / n); });
}

/// Without the places without data, which a run puts around it by itself.
std::shared_ptr<const ConstraintManifold> open_domain(const Run& run) {
  const std::shared_ptr<const ConstraintManifold>& domain = run.parts.problem.manifold;
  if (find_ability<HasWalls>(*domain) == nullptr) return domain;
  return {domain, domain->decorated(typeid(void))};
}

std::shared_ptr<const ConstraintManifold> plane() {
  return std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
}

std::shared_ptr<const ConstraintManifold> among_ball() {
  BallOptions ball;
  ball.center = Eigen::Vector2d(1.5, 2.1);
  ball.radius = 0.5;
  return std::make_shared<const FreeSpace>(plane(), FreeSpace::Obstacles{make_ball(ball)}, 0.0);
}

Run run_of(const std::string& text, const Externals& externals) {
  return parse_run(text, "a.yaml", ".", {}, {}, externals);
}

std::string errors_of(const std::string& text, const Externals& externals) {
  LoadedConfig loaded = parse_config(text, "a.yaml", ".", {}, externals);
  if (loaded.errors.empty()) check_parts(loaded);
  return loaded.errors.render();
}

std::string errors_of(const ConfigValue::Block& tree) {
  LoadedConfig loaded = parse_config(tree, "config", ".");
  if (loaded.errors.empty()) check_parts(loaded);
  return loaded.errors.render();
}

ConfigValue point(double x, double y) { return ConfigValue::Block{{"point", ConfigValue::List{x, y}}}; }

/// kPlane in memory.
ConfigValue::Block plane_values() {
  return {{"manifold", ConfigValue::Block{{"type", "euclidean"}, {"dimension", 2}}},
          {"cost", "euclidean"},
          {"ends", ConfigValue::Block{{"source", point(0, 0)}, {"target", point(3, 4)}}}};
}

ConfigValue::Block plane_with(const std::string& key, ConfigValue value) {
  ConfigValue::Block block = plane_values();
  block.push_back({key, std::move(value)});
  return block;
}

const std::string kNamed = R"(manifold: {type: external, name: room}
cost: euclidean
ends:
  source: {point: [0, 0]}
  target: {point: [3, 4]}
)";

}  // namespace

TEST_CASE("externals: the objects of a shipped configuration get the methods that it gets") {
  int compared = 0;
  for (const auto& entry : fs::directory_iterator(project_dir() / "configs")) {
    if (entry.path().extension() != ".yaml") continue;
    CAPTURE(entry.path().filename().string());
    const LoadedConfig loaded = load_config(entry.path(), {});
    const RunConfig& config = loaded.config;
    REQUIRE(loaded.errors.empty());
    if (config.has_pairs() || !config.obstacles.empty() || config.robot) continue;  // planned among obstacles: below
    if (!files_are_there(loaded)) {
      record_skip("externals: " + entry.path().stem().string(), "a file that it names is not installed");
      continue;
    }
    const Run described = load_run(entry.path());
    const Externals objects = {{"domain", open_domain(described)}, {"price", described.origin->parts.problem.cost}};
    const Run named =
        load_run(entry.path(), {{"manifold={type: external, name: domain}"}, {"cost={type: external, name: price}"}},
                 {}, objects);
    CHECK(methods_of(named) == methods_of(described));
    CHECK(open_domain(named) == open_domain(described));
    CHECK(named.parts.problem.cost == described.parts.problem.cost);
    ++compared;
  }
  CHECK(compared > 20);
}

TEST_CASE("externals: a mesh that is handed over is proved like the file") {
  const fs::path hill = project_dir() / "configs/data/hill.obj";
  const std::string rest = "cost: euclidean\nends: {source: {vertex: 0}, target: {vertex: 80}}\n";
  const Run described = parse_run("manifold: {type: mesh, file: " + hill.string() + "}\n" + rest, "a.yaml");
  const RunOutcome by_file = solve(described);
  const RunOutcome by_name =
      solve(run_of("manifold: {type: external, name: hill}\n" + rest, {{"hill", described.parts.problem.manifold}}));
  CHECK(cost_of(by_name) == cost_of(by_file));
  CHECK(by_name.result.status == by_file.result.status);
  CHECK(by_name.origin->why == by_file.origin->why);
  REQUIRE(by_name.result.certificate.global.has_value());
  CHECK(by_name.result.certificate.global->lower_bound == by_file.result.certificate.global->lower_bound);
}

TEST_CASE("externals: a domain among its own obstacles is planned like obstacles of a configuration") {
  const Run described = run_of(kPlane + "obstacles: [{type: ball, center: [1.5, 2.1], radius: 0.5}]\n", {});
  const Run named = run_of(kNamed, {{"room", among_ball()}});
  CHECK(methods_of(named) == methods_of(described));
  CHECK(cost_of(solve(named)) == Approx(cost_of(solve(described))).epsilon(1e-12));
  CHECK_THAT(errors_of(kNamed + "obstacles: [{type: ball, center: [2, 2], radius: 0.1}]\n", {{"room", among_ball()}}),
             Contains("a.yaml:6:1") && Contains("among obstacles of its own"));
}

TEST_CASE("externals: obstacles, first paths and solvers are taken as they are") {
  BallOptions ball;
  ball.center = Eigen::Vector2d(1.5, 2.1);
  ball.radius = 0.5;
  const auto start = std::make_shared<const WaypointsInitializer>(Eigen::Matrix2Xd(Eigen::Vector2d(2, 1)));
  const auto solver = std::make_shared<const Newton>();
  const Run run = run_of(kNamed +
                             "obstacles: [{type: external, name: ball}]\n"
                             "initializer: {type: external, name: start}\nsolver: {type: external, name: own}\n",
                         {{"room", plane()}, {"ball", make_ball(ball)}, {"start", start}, {"own", solver}});
  CHECK(run.parts.initializer == start);
  CHECK(run.parts.solver == solver);
  const RunOutcome below = solve(run);
  CHECK(below.result.path.u(1, below.result.path.u.cols() / 2) < 2);  // on the side of the waypoint
  CHECK(cost_of(below) > 5);
  CHECK_THAT(resolved_yaml(run.origin->config), Contains("name: ball") && Contains("name: own"));
}

TEST_CASE("externals: a part of a sum is an object too") {
  const std::string text =
      "manifold: {type: euclidean, dimension: 2}\n"
      "cost: {type: sum, terms: [{weight: 3, cost: {type: external, name: length}}]}\n"
      "ends: {source: {point: [0, 0]}, target: {point: [3, 4]}}\n";
  CHECK(cost_of(solve(run_of(text, {{"length", make_euclidean_cost(2)}}))) == Approx(15));
}

TEST_CASE("externals: names without an object are errors with their place") {
  const std::shared_ptr<const ConstraintManifold> nothing;
  CHECK_THAT(errors_of(kNamed, Externals{}), Contains("a.yaml:1:34") && Contains("there is no object 'room'") &&
                                                 Contains("handed over by the program"));
  CHECK_THAT(errors_of(kNamed, {{"rooms", plane()}}),
             Contains("there is no object 'room' (did you mean 'rooms'?); objects: rooms"));
  CHECK_THAT(errors_of(kNamed, {{"room", make_euclidean_cost(2)}}),
             Contains("the object 'room' is a cost; this key takes a manifold"));
  CHECK_THAT(errors_of(kNamed, {{"room", nothing}}), Contains("the object 'room' is null"));
  CHECK_THAT(errors_of("manifold: external\ncost: euclidean\n", {{"room", plane()}}),
             Contains("missing key 'name' in manifold"));
  const std::string cost =
      "manifold: {type: euclidean, dimension: 2}\ncost: {type: external, name: c}\n"
      "ends: {source: {point: [0, 0]}, target: {point: [3, 4]}}\n";
  CHECK_THAT(errors_of(cost, {{"c", make_euclidean_cost(3)}}),
             Contains("a.yaml:2:30") && Contains("defined for moves in R^3, but the manifold lies in R^2"));
}

TEST_CASE("configurations in memory: the same run as its text") {
  const RunOutcome by_values = solve(parse_run(plane_values(), "config"));
  const RunOutcome by_text = solve(parse_run(kPlane, "config"));
  CHECK(cost_of(by_values) == cost_of(by_text));
  CHECK(by_values.result.path.u == by_text.result.path.u);
  CHECK(resolved_yaml(by_values.origin->config) == resolved_yaml(by_text.origin->config));
  CHECK(solve(parse_run(plane_values(), "config", {}, {{"path.points=7"}})).result.path.u.cols() == 9);
}

TEST_CASE("configurations in memory: errors are at their subscripts") {
  using Block = ConfigValue::Block;
  CHECK_THAT(errors_of(plane_with("solver", Block{{"type", "newton"}, {"tolerence", 1e-9}})),
             Contains("config['solver']['tolerence']: error: unknown key 'tolerence' in solver (did you mean"));
  CHECK_THAT(errors_of(plane_with("path", Block{{"points", "64"}, {"cascade", 1}})),
             Contains("config['path']['points']: error: must be a whole number") &&
                 Contains("config['path']['cascade']: error: must be true or false"));
  CHECK_THAT(errors_of(plane_with("obstacles", ConfigValue::List{Block{{"type", "bal"}}})),
             Contains("config['obstacles'][0]['type']: error: unknown obstacle 'bal' (did you mean 'ball'?)"));
  CHECK_THAT(errors_of(plane_with("obstacles", ConfigValue::List{Block{{"type", "Disc"}}})),
             Contains("unknown obstacle 'Disc' (did you mean 'ball'?)"));
  CHECK_THAT(errors_of(plane_with("kernel", ConfigValue())),
             Contains("config['kernel']: error: has no value: remove the key"));
  CHECK_THAT(errors_of(plane_with("cost", "euclidean")), Contains("config['cost']: error: duplicate key 'cost'"));
  CHECK_THAT(errors_of(plane_with("clearance", std::numeric_limits<double>::quiet_NaN())),
             Contains("config['clearance']: error: must be a"));
  CHECK_THAT(errors_of(Block{}), Contains("config: error: missing key 'manifold'"));
  ConfigValue deep = 1;
  for (int i = 0; i < 1000; ++i) deep = ConfigValue::List{deep};
  CHECK_THAT(errors_of(plane_with("kernel", deep)), Contains("lies below more than"));
}

}  // namespace leastcost::test
