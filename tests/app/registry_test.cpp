// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/registry/registry.hpp"

#include <set>

#include <leastcost/framework/has_constant_metric.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/manifolds/mesh.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include "app/reference/describe.hpp"
#include "app/reference/field_list.hpp"
#include "catalogue/plugins/kinds.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {

using Catch::Contains;

TEST_CASE("registry: every interface of the framework is a kind, found by name and plural, types unique") {
  for (const char* name : {"manifold", "cost", "kernel", "initializer", "solver", "post_processor"})
    CHECK(find_kind(name) != nullptr);
  for (const PluginKind& kind : plugin_kinds()) {
    CHECK(find_kind(kind.name) == &kind);
    CHECK(find_kind(kind.plural) == &kind);
    const std::vector<std::string> types = types_of(kind);
    CHECK(std::set<std::string>(types.begin(), types.end()).size() == types.size());
    CHECK_FALSE(types.empty());
  }
  CHECK(find_kind("potato") == nullptr);
}

TEST_CASE("registry: every plug-in and every option is documented") {
  for (const PluginKind& kind : plugin_kinds())
    for (const PluginEntry* plugin : kind.entries) {
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
  for (const PluginEntry* plugin : kind("kernel").entries) {
    CAPTURE(plugin->type);
    CHECK(make<std::shared_ptr<const Kernel>>(choose(*plugin, "kernel"), {}) != nullptr);
  }
  for (const PluginEntry* plugin : kind("solver").entries) {
    const auto solver = make<std::shared_ptr<const Solver>>(choose(*plugin, "solver"), {});
    CHECK(solver->name() == plugin->type);
  }
  for (const PluginEntry* plugin : kind("post_processor").entries) {
    const auto step = make<std::shared_ptr<const PostProcessor>>(choose(*plugin, "post_process.0"), {});
    CHECK(step->name() == plugin->type);
  }
}

TEST_CASE("registry: the promised abilities are those of the objects") {
  for (const PluginEntry* plugin : kind("cost").entries) {
    CAPTURE(plugin->type);
    PluginChoice choice = choose(*plugin, "cost");
    if (auto* tensor = dynamic_cast<OptionsOf<MetricTensorOptions>*>(choice.options.get()))
      tensor->value.matrix = Eigen::MatrixXd::Identity(3, 3);
    if (auto* field = dynamic_cast<OptionsOf<MetricFieldOptions>*>(choice.options.get())) {
      field->value.field = metric::Formula{.entries = {"1", "0", "0", "1", "0", "1 + x^2"}};
    }
    const auto cost = make<std::shared_ptr<const SegmentCost>>(choice, {"", 3, Eigen::VectorXd::Zero(3)});
    CHECK(choice.provides(std::string(kConstantMetric)) ==
          (dynamic_cast<const HasConstantMetric*>(cost.get()) != nullptr));
  }
  STATIC_REQUIRE(std::is_base_of_v<HasMesh, MeshManifold>);
  STATIC_REQUIRE_FALSE(std::is_base_of_v<HasMesh, EuclideanManifold>);
  CHECK(choose(*find_plugin(kind("manifold"), "mesh"), "").provides(std::string(kMesh)));
  CHECK_FALSE(choose(*find_plugin(kind("manifold"), "euclidean"), "").provides(std::string(kMesh)));
}

TEST_CASE("registry: an option error names the full path") {
  PluginChoice choice = choose(*find_plugin(kind("cost"), "metric_tensor"), "cost");
  static_cast<OptionsOf<MetricTensorOptions>&>(*choice.options).value.matrix = Eigen::MatrixXd::Zero(2, 2);
  try {
    make<std::shared_ptr<const SegmentCost>>(choice, {"", 2, {}});
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

namespace {

void add_choices(const std::vector<app::FieldInfo>& fields, const std::string& path, std::set<std::string>& out) {
  for (const app::FieldInfo& field : fields) {
    const std::string here = path + "." + field.key;
    if (field.type == app::FieldType::choice || field.type == app::FieldType::variant) out.insert(here);
    add_choices(field.children, here, out);
  }
}

}  // namespace

// A choice that is missing here is missing among the static_asserts of tests/contracts as well.
TEST_CASE("registry: the choices of all plug-ins are those whose misspelling is shown not to compile") {
  std::set<std::string> found;
  for (const PluginKind& kind : plugin_kinds())
    for (const PluginEntry* plugin : kind.entries)
      add_choices(app::fields_of(*plugin->defaults()), plugin->type, found);
  std::set<std::string> known = {"travel_time.rule",
                                 "metric_field.field",
                                 "metric_field.field.file.on",
                                 "metric_field.reading",
                                 "metric_field.rule",
                                 "parametric.surface",
                                 "implicit.surface",
                                 "constraint.set",
                                 "point_cloud.normals",
                                 "signed_distance.source",
                                 "signed_distance.source.mesh.sign",
                                 "signed_distance.source.point_cloud.normals",
                                 "signed_distance.source.point_cloud.sign",
                                 "signed_distance.source.implicit.surface",
                                 "lbfgs.precondition"};
  for (const char* back_end : {"nlopt", "ceres"})
    if (find_plugin(kind("solver"), back_end)->missing.empty())
      for (const char* option : {".algorithm", ".precondition"}) known.insert(std::string(back_end) + option);
  CHECK(found == known);
}

}  // namespace leastcost::test
