// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/registry/registry.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include <leastcost/catalogue/plugins/abilities.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include "app/reference/describe.hpp"
#include "app/reference/field_list.hpp"
#include "catalogue/plugins/kinds.hpp"
#include "catalogue/run/compose_run.hpp"
#include "catalogue/run/run_origin.hpp"
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

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
    const std::vector<app::FieldInfo> fields = app::fields_of(*plugin->defaults());
    if (std::any_of(fields.begin(), fields.end(), [](const app::FieldInfo& f) { return f.required; })) continue;
    const auto step = make<std::shared_ptr<const PostProcessor>>(choose(*plugin, "post_process.0"), {});
    CHECK(step->name() == plugin->type);
  }
}

namespace {

/// The words for the abilities that an object has.
template <class T>
std::set<std::string> words_of(const T& object) {
  std::set<std::string> words;
  for_each_ability([&]<class Ability>() {
    if (find_ability<Ability>(object) != nullptr) words.emplace(Ability::kAbility);
  });
  return words;
}

using Words = std::map<std::string, std::set<std::string>>;  // by type

/// Makes the manifold and the cost of a configuration, unless their words are all known, and adds what they answer.
void add_answers(const LoadedConfig& loaded, Words& manifolds, Words& costs) {
  const RunConfig& config = loaded.config;
  const auto complete = [](const PluginChoice& choice, const Words& words) {
    const auto& promised = choice.plugin->provides;
    const auto found = words.find(choice.plugin->type);
    return found != words.end() && found->second == std::set<std::string>(promised.begin(), promised.end());
  };
  if (complete(config.manifold, manifolds) && complete(config.cost, costs)) return;
  BuildContext context{loaded.folder};
  if (config.robot) context.robot = make<std::shared_ptr<const Robot>>(config.robot, context);
  context.manifold = make<std::shared_ptr<const ConstraintManifold>>(config.manifold, context);
  context.dimension = context.manifold->dimensions().ambient;
  context.source = Eigen::VectorXd::Zero(context.dimension);
  const auto cost = config.obstacles.empty()
                        ? make<std::shared_ptr<const SegmentCost>>(config.cost, context)
                        : compose_run(config, loaded.folder).parts.problem.cost;  // may ask for them
  manifolds[config.manifold.plugin->type].merge(words_of(*context.manifold));
  costs[config.cost.plugin->type].merge(words_of(*cost));
}

void check_promises(const char* kind_name, const Words& answers) {
  for (const PluginEntry* plugin : kind(kind_name).entries) {
    CAPTURE(kind_name, plugin->type);
    REQUIRE(answers.count(plugin->type) == 1);
    CHECK(answers.at(plugin->type) == std::set<std::string>(plugin->provides.begin(), plugin->provides.end()));
  }
}

}  // namespace

TEST_CASE("registry: the promised abilities are those of the objects") {
  Words manifolds, costs;
  add_answers(parse("manifold: {type: constraint, set: {type: sphere, radius: 1}, dimension: 3}\ncost: euclidean\n"
                    "ends: {source: {point: [1, 0, 0]}, target: {point: [0, 1, 0]}}\n"),
              manifolds, costs);
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(project_dir() / "configs"))
    if (entry.path().extension() == ".yaml") files.insert(entry.path());
  for (const std::filesystem::path& file : files) {
    CAPTURE(file);
    const LoadedConfig loaded = load_config(file, {});
    REQUIRE(loaded.errors.empty());
    if (resolved_yaml(loaded.config).find("/usr/share/") == std::string::npos) add_answers(loaded, manifolds, costs);
  }
  check_promises("manifold", manifolds);
  check_promises("cost", costs);
}

TEST_CASE("registry: words come from what a factory returns") {
  const auto words = [](const char* kind_name, const char* type) {
    return find_plugin(kind(kind_name), type)->provides;
  };
  using Texts = std::vector<std::string>;
  CHECK(words("manifold", "mesh") == Texts{"mesh", "surface", "graph", "vertices", "faces"});
  CHECK(words("manifold", "euclidean").empty());
  CHECK(words("manifold", "signed_distance") == Texts{"surface", "smooth embedding", "distance grid"});
  CHECK(words("cost", "metric_tensor") == Texts{"constant metric"});
  CHECK(words("initializer", "waypoints") == Texts{"ring"});
  CHECK(find_plugin(kind("post_processor"), "straighten")->needs == Texts{"mesh", "constant metric"});
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
                                 "map.unknown",
                                 "mesh.inside",
                                 "dh_arm.attached.type",
                                 "dh_arm.model",
                                 "dh_arm.model.table.convention",
                                 "kinetic_energy.model",
                                 "kinetic_energy.model.table.convention",
                                 "end_effector_length.model",
                                 "end_effector_length.model.table.convention",
                                 "refractive_index.index",
                                 "refractive_index.index.smooth_layers.values_are",
                                 "walking.law",
                                 "walking.law.tobler.unit",
                                 "walking.length",
                                 "zermelo.flow",
                                 "cost_map.interpolation",
                                 "lbfgs.precondition"};
  for (const char* back_end : {"nlopt", "ceres"})
    if (find_plugin(kind("solver"), back_end)->missing.empty())
      for (const char* option : {".algorithm", ".precondition"}) known.insert(std::string(back_end) + option);
  if (find_plugin(kind("robot"), "urdf")->missing.empty()) known.insert("urdf.attached.type");
  if (find_plugin(kind("initializer"), "ompl")->missing.empty()) known.insert("ompl.planner");
  CHECK(found == known);
}

}  // namespace leastcost::test
