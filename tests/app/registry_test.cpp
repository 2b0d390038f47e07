// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/registry.hpp"

#include <set>

#include "app/config/describe.hpp"
#include "app/config/field_list.hpp"
#include "problems/costs/metric_field.hpp"
#include "problems/costs/metric_tensor.hpp"
#include "problems/geometry/has_constant_metric.hpp"
#include "problems/geometry/has_mesh.hpp"
#include "problems/manifolds/euclidean.hpp"
#include "problems/manifolds/mesh.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {

using Catch::Contains;

TEST_CASE("registry: six kinds, found by name and plural, types unique") {
  CHECK(app::plugin_kinds().size() == 6);
  for (const app::PluginKind& kind : app::plugin_kinds()) {
    CHECK(app::find_kind(kind.name) == &kind);
    CHECK(app::find_kind(kind.plural) == &kind);
    const std::vector<std::string> types = app::types_of(kind);
    CHECK(std::set<std::string>(types.begin(), types.end()).size() == types.size());
    CHECK_FALSE(types.empty());
  }
  CHECK(app::find_kind("potato") == nullptr);
}

TEST_CASE("registry: every plug-in and every option is documented") {
  for (const app::PluginKind& kind : app::plugin_kinds())
    for (const app::PluginEntry* plugin : kind.entries) {
      CAPTURE(kind.name, plugin->type);
      CHECK_FALSE(plugin->summary.empty());
      CHECK(plugin->summary.back() == '.');
      for (const app::FieldInfo& field : app::fields_of(*plugin->defaults())) {
        CAPTURE(field.key);
        CHECK_FALSE(field.help.empty());
        CHECK_THAT(app::describe_plugin(kind, *plugin), Contains(field.key) && Contains(field.help));
      }
    }
}

TEST_CASE("registry: kernels, solvers and post-processors are made from their defaults") {
  for (const app::PluginEntry* plugin : app::kind("kernel").entries) {
    CAPTURE(plugin->type);
    CHECK(app::make<std::shared_ptr<const Kernel>>(app::choose(*plugin, "kernel"), {}) != nullptr);
  }
  for (const app::PluginEntry* plugin : app::kind("solver").entries) {
    const auto solver = app::make<std::shared_ptr<const Solver>>(app::choose(*plugin, "solver"), {});
    CHECK(solver->name() == plugin->type);
  }
  for (const app::PluginEntry* plugin : app::kind("post_processor").entries) {
    const auto step = app::make<std::shared_ptr<const PostProcessor>>(app::choose(*plugin, "post_process.0"), {});
    CHECK(step->name() == plugin->type);
  }
}

TEST_CASE("registry: the promised abilities are those of the objects") {
  for (const app::PluginEntry* plugin : app::kind("cost").entries) {
    CAPTURE(plugin->type);
    app::PluginChoice choice = app::choose(*plugin, "cost");
    if (auto* tensor = dynamic_cast<app::OptionsOf<MetricTensorOptions>*>(choice.options.get()))
      tensor->value.matrix = Eigen::MatrixXd::Identity(3, 3);
    if (auto* field = dynamic_cast<app::OptionsOf<MetricFieldOptions>*>(choice.options.get())) {
      field->value.type = "formula";
      field->value.entries = {"1", "0", "0", "1", "0", "1 + x^2"};
    }
    const auto cost = app::make<std::shared_ptr<const SegmentCost>>(choice, {"", 3, Eigen::VectorXd::Zero(3)});
    CHECK(choice.provides(std::string(app::kConstantMetric)) ==
          (dynamic_cast<const HasConstantMetric*>(cost.get()) != nullptr));
  }
  STATIC_REQUIRE(std::is_base_of_v<HasMesh, MeshManifold>);
  STATIC_REQUIRE_FALSE(std::is_base_of_v<HasMesh, EuclideanManifold>);
  CHECK(app::choose(*app::find_plugin(app::kind("manifold"), "mesh"), "").provides(std::string(app::kMesh)));
  CHECK_FALSE(app::choose(*app::find_plugin(app::kind("manifold"), "euclidean"), "").provides(std::string(app::kMesh)));
}

TEST_CASE("registry: an option error names the full path") {
  app::PluginChoice choice = app::choose(*app::find_plugin(app::kind("cost"), "metric_tensor"), "cost");
  static_cast<app::OptionsOf<MetricTensorOptions>&>(*choice.options).value.matrix = Eigen::MatrixXd::Zero(2, 2);
  try {
    app::make<std::shared_ptr<const SegmentCost>>(choice, {"", 2, {}});
    FAIL("no exception");
  } catch (const OptionError& e) {
    CHECK(e.key() == "cost.matrix");
  }
}

TEST_CASE("describe: the keys of a configuration") {
  const std::string text = app::describe_run();
  for (const char* key : {"name", "seed", "manifold", "cost", "kernel", "ends", "source", "target", "path", "points",
                          "ring", "initializer", "solver", "max_seconds", "certificate", "post_process", "output"}) {
    CAPTURE(key);
    CHECK_THAT(text, Contains(key));
  }
}

}  // namespace leastcost::test
