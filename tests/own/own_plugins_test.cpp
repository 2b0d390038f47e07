// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Plug-ins that a program registers: in the lists, `describe`, the schema, completion, runs and studies. A program of
// its own, as what is registered stays until the process ends.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include <leastcost/app/app.hpp>
#include <leastcost/catalogue/catalogue.hpp>
#include "catalogue/registry/registry.hpp"
#include "tests/app/called.hpp"
#include "tests/own/own_plugins.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

using Catch::Contains;

TEST_CASE("own plug-ins: each kind has its own, last in the list") {
  const std::vector<PluginKind>& before = plugin_kinds();
  const std::size_t costs = kind("cost").entries.size();
  register_own_plugins();
  const std::vector<std::pair<const char*, const char*>> own = {
      {"cost", "own_ray_time"},     {"solver", "own_gauss_newton"}, {"manifold", "own_plane"}, {"kernel", "own_cosh"},
      {"initializer", "own_start"}, {"post_processor", "own_step"}, {"obstacle", "own_pegs"}};
  for (const auto& [kind_name, type] : own) {
    CAPTURE(kind_name, type);
    const PluginEntry* entry = find_plugin(kind(kind_name), type);
    REQUIRE(entry != nullptr);
    CHECK(entry->library == "registered by the program");
    CHECK(types_of(kind(kind_name)).front().rfind("own_", 0) != 0);
  }
  if (&before != &plugin_kinds()) CHECK(find_kind("cost")->entries.size() > costs);
  CHECK(before[3].entries.size() == costs);  // who looks at a list keeps it
  CHECK(find_plugin(kind("manifold"), "own_plane")->provides == find_plugin(kind("manifold"), "euclidean")->provides);
}

TEST_CASE("own plug-ins: a name that is taken, no word, or without a sentence") {
  register_own_plugins();
  CHECK_THROWS_WITH(register_solver<own::GaussNewton>("own_gauss_newton", "Twice."),
                    "cannot register the solver 'own_gauss_newton': there is a solver of this name already; give it "
                    "another one");
  CHECK_THROWS_AS(register_solver<own::GaussNewton>("newton", "Of the library."), InputError);
  CHECK_THROWS_AS(register_solver<own::GaussNewton>("nlopt", "Also where this build has it not."), InputError);
  for (const char* name : {"", "Own", "own solver", "own-solver", "2nd", "_own", "own.solver"})
    CHECK_THROWS_WITH(register_solver<own::GaussNewton>(name, "A solver."),
                      Contains("a name has lower-case letters, digits and _, and begins with a letter"));
  CHECK_THROWS_WITH(register_kernel<OwnCosh>("own_silent", ""), Contains("give a sentence that says what it is"));
  CHECK(find_plugin(kind("kernel"), "own_silent") == nullptr);
  const std::string name = "own_ray_time";  // of a cost
  if (find_plugin(kind("kernel"), name) == nullptr) CHECK_NOTHROW(register_kernel<OwnCosh>(name, "Of another kind."));
}

TEST_CASE("own plug-ins: one that replaces another of the program, never one of the library") {
  using Made = std::shared_ptr<const Kernel>;
  const auto kernel = [](const char* type, const char* summary) {
    OwnPlugin<Made> own;
    own.type = type;
    own.summary = summary;
    own.defaults = [] { return std::make_unique<OwnOptionsOf<NoOptions>>(); };
    own.make = [](const OwnOptions&, const BuildContext&) -> Made { return make_kernel<OwnCosh>(); };
    own.replaces = true;
    return own;
  };
  add_plugin(kernel("own_replaced", "The first."));  // there need not be one
  const PluginEntry* first = find_plugin(kind("kernel"), "own_replaced");
  const std::size_t count = kind("kernel").entries.size();
  add_plugin(kernel("own_replaced", "The second."));
  CHECK(find_plugin(kind("kernel"), "own_replaced")->summary == "The second.");
  CHECK(kind("kernel").entries.size() == count);
  CHECK(first->summary == "The first.");  // who has chosen it keeps it
  CHECK_THROWS_WITH(add_plugin(kernel("linear", "Not linear.")), Contains("there is a kernel of this name already"));
}

TEST_CASE("own plug-ins: describe, list, schema and completion have them") {
  register_own_plugins();
  CHECK_THAT(call({"describe", "cost", "own_ray_time"}).out,
             Contains("Time of a ray") && Contains("gain  number, at least 0 [1/s]") && Contains("default 0.5"));
  CHECK_THAT(call({"describe", "solver", "own_gauss_newton"}).out, Contains("max_iterations"));
  CHECK_THAT(call({"list", "manifolds"}).out, Contains("own_plane"));
  const auto schema = nlohmann::json::parse(call({"schema"}).out);
  CHECK_THAT(schema.dump(), Contains("own_gauss_newton") && Contains("Radius of both pegs."));
  CHECK_THAT(call({"completion", "bash"}).out, Contains("own_cosh"));
  const ScratchDir dir;
  CHECK(call({"describe", "--markdown", dir.path().string()}).exit == 0);
}

TEST_CASE("own plug-ins: a run with one of every kind finds the known time") {
  register_own_plugins();
  const RunOutcome outcome = solve(parse_run(kRay, "ray.yaml"));
  const Certificate& certificate = outcome.result.certificate;
  CHECK(certificate.certified());
  CHECK(std::abs(certificate.estimate.value - 2 * std::acosh(3.0)) < 1e-6);
  CHECK(outcome.parts.solver->name() == "gauss_newton");
  const std::string result = result_json(outcome);
  CHECK_THAT(result, Contains("from own_start") && Contains("through own_step"));

  const Run pegs = parse_run(
      "manifold: {type: euclidean, dimension: 2}\ncost: euclidean\nobstacles: [{type: own_pegs, radius: 0.25}]\n"
      "ends: {source: {point: [0, 0]}, target: {point: [4, 0.1]}}\n",
      "pegs.yaml");
  const RunOutcome around = solve(pegs);
  CHECK(around.result.curve.cost > 4.01);
  CHECK(around.result.curve.cost < 4.3);
}

TEST_CASE("own plug-ins: options are checked, and a factory speaks of its option") {
  register_own_plugins();
  static const bool registered = [] {
    register_cost<own::RayTimeOptions>("own_picky", "Refuses.", [](const own::RayTimeOptions& o, const BuildContext&) {
      if (o.gain > 2) throw OptionError("gain", "must not be above 2");
      return make_segment_cost(own::RayTime{o.gain});
    });
    register_cost("own_nothing", "Makes nothing.",
                  [](const NoOptions&, const BuildContext&) { return std::shared_ptr<const SegmentCost>(); });
    return true;
  }();
  static_cast<void>(registered);
  const auto errors = [](const std::string& cost, const std::string& manifold = "{type: euclidean, dimension: 2}") {
    const std::string point = manifold.find('3') == std::string::npos ? "[0, 0]" : "[0, 0, 0]";
    const std::string target = manifold.find('3') == std::string::npos ? "[4, 0]" : "[4, 0, 0]";
    try {
      parse_run("manifold: " + manifold + "\ncost: " + cost + "\nends: {source: {point: " + point +
                    "}, target: {point: " + target + "}}\n",
                "a.yaml");
    } catch (const ConfigError& e) {
      return e.diagnostics().render();
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK(errors("own_ray_time") == "");
  CHECK_THAT(errors("{type: own_ray_time, gian: 1}"), Contains("did you mean 'gain'"));
  CHECK_THAT(errors("{type: own_ray_time, gain: -1}"), Contains("a.yaml:2"));
  CHECK_THAT(errors("own_ray_tiem"), Contains("did you mean 'own_ray_time'"));
  CHECK_THAT(errors("{type: own_picky, gain: 3}"), Contains("a.yaml:2") && Contains("must not be above 2"));
  CHECK_THAT(errors("own_ray_time", "{type: euclidean, dimension: 3}"),
             Contains("the cost is defined for moves in R^2, but the manifold lies in R^3"));
  CHECK_THAT(errors("own_nothing"), Contains("the factory of 'own_nothing' returned a null pointer"));
}

TEST_CASE("own plug-ins: registered by many threads while others read the lists") {
  register_own_plugins();
  static const bool done = [] {
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
      threads.emplace_back([t] {
        for (int i = 0; i < 25; ++i) {
          register_kernel<OwnCosh>("own_" + std::to_string(t) + "_" + std::to_string(i), "Of a thread.");
          std::size_t seen = 0;
          for (const std::string& type : types_of(kind("kernel")))
            seen += type.rfind("own_" + std::to_string(t), 0) == 0;
          if (seen != static_cast<std::size_t>(i + 1)) std::abort();  // its own ones are there
        }
      });
    for (std::thread& thread : threads) thread.join();
    return true;
  }();
  static_cast<void>(done);
  const std::vector<std::string> types = types_of(kind("kernel"));
  CHECK(std::count_if(types.begin(), types.end(), [](const std::string& type) {
          return type.size() >= 7 && type.rfind("own_", 0) == 0 && std::isdigit(static_cast<unsigned char>(type[4]));
        }) == 100);
}

TEST_CASE("own program: its name is in messages and completion, its plug-ins in the files of a run") {
  register_own_plugins();
  const ScratchDir dir;
  std::ostringstream out, err;
  const auto run = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "/opt/rays");
    out.str("");
    err.str("");
    return app::run_program(arguments, {out, err});
  };
  CHECK(run({"run", "--nonsense"}) == 2);
  CHECK_THAT(err.str(), Contains("Try: rays --help"));
  CHECK(run({"completion", "bash"}) == 0);
  CHECK_THAT(out.str(), Contains("complete -F _rays rays") && !Contains("leastcost"));
  const std::string config = written(dir / "ray.yaml", kRay).string();
  CHECK(run({"run", config, "-o", (dir / "out").string(), "-q"}) == 0);
  CHECK_THAT(content(dir / "out/manifest.json"), Contains("\"own_gauss_newton\": \"registered by the program\""));
  CHECK_THAT(content(dir / "out/config.resolved.yaml"), Contains("own_ray_time"));
}

TEST_CASE("own program: run_program takes the arguments of main") {
  register_own_plugins();
  const ScratchDir dir;
  const std::string config = written(dir / "ray.yaml", kRay).string(), folder = (dir / "out").string();
  std::vector<std::string> words = {"rays", "run", config, "-o", folder, "-q"};
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  CHECK(run_program(static_cast<int>(words.size()), argv.data()) == 0);
  CHECK(std::filesystem::exists(dir / "out/report.html"));
}

}  // namespace leastcost::test
