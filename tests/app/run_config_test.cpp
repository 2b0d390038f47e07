// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/config/load_config.hpp"

#include <leastcost/recipes/methods.hpp>
#include "catalogue/registry/registry.hpp"
#include "tests/app/called.hpp"
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

using Catch::Contains;

namespace {

std::vector<std::string> types(const std::optional<PluginList>& list) {
  std::vector<std::string> out;
  for (const PluginChoice& choice : list.value()) out.push_back(choice.plugin->type);
  return out;
}

}  // namespace

TEST_CASE("run config: the help texts of defaults name every method that recipes choose") {
  const std::string help = call({"describe", "run"}).out;
  const auto of = [&help](const std::string& key, const std::string& next) {
    const std::size_t begin = help.find("\n  " + key + " ");
    REQUIRE(begin != std::string::npos);
    return help.substr(begin, help.find("\n  " + next + " ", begin) - begin);
  };
  const std::string first = of("initializer", "family"), solver = of("solver", "max_seconds"),
                    steps = of("post_process", "output");
  for (const auto& [method, word] : words(FirstPathMethod{})) CHECK_THAT(first, Contains(std::string(word)));
  for (const auto& [method, word] : words(SolveMethod{})) CHECK_THAT(solver, Contains(std::string(word)));
  for (const auto& [method, word] : words(CurveMethod{})) CHECK_THAT(steps, Contains(std::string(word)));
}

TEST_CASE("run config: defaults in free space") {
  const RunConfig c = parse(kPlane).config;
  CHECK(c.name == "a");
  CHECK(c.kernel.plugin->type == "expm1_square");
  CHECK(c.initializer.plugin->type == "straight");
  CHECK(c.solver.plugin->type == "newton");
  CHECK(types(c.post_process).empty());
  CHECK(c.points == 64);
  CHECK(c.certificate.enabled);
}

TEST_CASE("run config: defaults on a mesh") {
  const std::string ends = "ends: {source: {vertex: 0}, target: {vertex: 1}}\n";
  const RunConfig c = parse("manifold: {type: mesh, file: m.obj}\ncost: euclidean\n" + ends).config;
  CHECK(c.initializer.plugin->type == "dijkstra");
  CHECK(c.solver.plugin->type == "none");  // the shortest path is proved
  CHECK(types(c.post_process) == std::vector<std::string>{"trace", "straighten"});
  for (const char* other :
       {"certificate: {global: off}\n", "family: {routes: 2}\n", "certificate: {enabled: false}\n",
        "initializer: {type: waypoints, points: [[0, 0, 0]]}\n", "initializer: {type: dijkstra, rank: 2}\n"})
    CHECK(parse("manifold: {type: mesh, file: m.obj}\ncost: euclidean\n" + ends + other).config.solver.plugin->type ==
          "lbfgs");
  const RunConfig tensor =
      parse("manifold: {type: mesh, file: m.obj}\ncost: {type: metric_tensor, matrix: [[1]]}\n" + ends).config;
  CHECK(types(tensor.post_process) == std::vector<std::string>{"trace", "straighten"});
  const RunConfig time = parse("manifold: {type: mesh, file: m.obj}\ncost: travel_time\n" + ends).config;
  CHECK(types(time.post_process) == std::vector<std::string>{"trace"});
  const RunConfig off = parse("manifold: {type: mesh, file: m.obj}\ncost: euclidean\npost_process: []\n" + ends).config;
  CHECK(types(off.post_process).empty());
}

TEST_CASE("run config: the cost is the length by default, and all that follows from it") {
  for (const std::string rest :
       {"manifold: {type: mesh, file: m.obj}\nends: {source: {vertex: 0}, target: {vertex: 1}}\n",
        "manifold: euclidean\nobstacles: [{type: ball, center: [0, 0], radius: 1}]\nends: "
        "{source: {point: [-2, 0]}, target: {point: [2, 0]}}\n"}) {
    const RunConfig with = parse(rest + "cost: euclidean\n").config, without = parse(rest).config;
    CHECK(without.cost.plugin == with.cost.plugin);
    CHECK(without.initializer.plugin == with.initializer.plugin);
    CHECK(without.solver.plugin == with.solver.plugin);
    CHECK(types(without.post_process) == types(with.post_process));
  }
}

TEST_CASE("run config: a plug-in as a word or as a block") {
  CHECK(parse(kPlane + "kernel: square\n").config.kernel.plugin ==
        parse(kPlane + "kernel: {type: square}\n").config.kernel.plugin);
}

TEST_CASE("run config: every shipped configuration is valid, and so is what it resolves to") {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(project_dir() / "configs")) {
    if (entry.path().extension() != ".yaml") continue;
    ++count;
    LoadedConfig loaded = load_config(entry.path(), {});
    if (loaded.errors.empty()) check_parts(loaded);
    CHECK(loaded.errors.render() == "");
    const std::string resolved = resolved_yaml(loaded.config);
    LoadedConfig again = parse_config(resolved, "resolved.yaml", loaded.folder);
    if (again.errors.empty()) check_parts(again);
    CHECK(again.errors.render() == "");
    CHECK(resolved_yaml(again.config) == resolved);
  }
  CHECK(count >= 15);
}

TEST_CASE("run config: every shipped configuration begins with two lines of comment") {
  for (const auto& entry : std::filesystem::directory_iterator(project_dir() / "configs")) {
    if (entry.path().extension() != ".yaml") continue;
    CAPTURE(entry.path());
    const std::string text = load_config(entry.path(), {}).text;
    CHECK(text.rfind("# ", 0) == 0);
    CHECK(text.substr(text.find('\n') + 1).rfind("# ", 0) == 0);
  }
}

TEST_CASE("run config: --set of an option alone is for the default type") {
  const std::string mesh =
      "manifold: {type: mesh, file: m.obj}\ncost: euclidean\nends: {source: {vertex: 0}, target: {vertex: 1}}\n";
  const LoadedConfig plane = parse(kPlane, {"solver.max_iterations=50", "path.points=9"});
  CHECK(plane.errors.render() == "");
  CHECK_THAT(resolved_yaml(plane.config), Contains("type: newton") && Contains("max_iterations: 50"));
  const LoadedConfig on_mesh = parse(mesh, {"solver.max_iterations=50", "initializer.routes=2"});
  CHECK(on_mesh.errors.render() == "");
  CHECK_THAT(resolved_yaml(on_mesh.config), Contains("type: lbfgs") && Contains("routes: 2"));
  CHECK(errors_of(kPlane + "solver: {max_iterations: 20}\n", {"solver.max_iterations=50"}) == "");
  CHECK_THAT(errors_of(kPlane + "solver: {max_iterations: 20}\n"), Contains("missing key 'type' in solver"));
  CHECK_THAT(errors_of(kPlane, {"solver.max_iteration=50"}),
             Contains("--set solver.max_iteration=50: error: unknown key 'max_iteration' in solver (did you mean "
                      "'max_iterations'?)"));
  CHECK_THAT(errors_of(kPlane + "post_process: [{tolerance: 1}]\n"), Contains("missing key 'type' in post_process[0]"));
  // A ring has no first path of its own.
  CHECK_THAT(errors_of("manifold: {type: euclidean, dimension: 2}\ncost: euclidean\npath: {ring: true}\n",
                       {"initializer.points=[[1, 0], [0, 1], [1, 1]]"}),
             Contains("missing key 'type' in initializer"));
}

TEST_CASE("run config: files it names") {
  const LoadedConfig loaded = parse(
      "manifold: {type: mesh, file: m.obj}\ncost: euclidean\n"
      "initializer: {type: file, file: way.csv}\nends: {source: {vertex: 0}, target: {vertex: 1}}\n");
  CHECK(loaded.errors.empty());
  CHECK(files_of(loaded.config) == std::vector<std::string>{"m.obj", "way.csv"});
}

TEST_CASE("run config: unreadable files are input errors") {
  CHECK_THROWS_AS(load_config("/nonexistent/a.yaml", {}), InputError);
  CHECK_THROWS_AS(load_config(project_dir(), {}), InputError);
}

}  // namespace leastcost::test
