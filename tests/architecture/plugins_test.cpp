// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A plug-in is its source file, one registration line, one config and one contract line. The registry knows them all;
// here it is checked that the last two exist:
//   * some configs/*.yaml, with its defaults filled in, has the type under the key of its kind (`cost: {type:
//   travel_time}`),
//   * some tests/contracts/*.cpp holds TEST_CASE("<kind> contract: <type>...").
#include <yaml-cpp/yaml.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "catalogue/config/load_config.hpp"
#include "catalogue/registry/registry.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;

std::string key_in_config(const PluginKind& kind) {
  return kind.name == "post_processor" ? "post_process" : kind.name == "obstacle" ? "obstacles" : kind.name;
}

/// The types that `value` of a kind's key names: `exp`, `{type: exp}`, or a list of either.
void add_types(const YAML::Node& value, std::set<std::string>& types) {
  if (value.IsScalar()) types.insert(value.Scalar());
  if (value.IsMap() && value["type"]) types.insert(value["type"].Scalar());
  if (value.IsSequence()) {
    for (const YAML::Node& item : value) add_types(item, types);
  }
}

std::set<std::string> types_in_configs(const fs::path& folder, const std::string& key) {
  std::set<std::string> types;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".yaml") continue;
    const LoadedConfig loaded = load_config(entry.path(), {});
    INFO(loaded.errors.render());
    REQUIRE(loaded.errors.empty());
    const YAML::Node config = YAML::Load(resolved_yaml(loaded.config));
    if (config[key]) add_types(config[key], types);
  }
  return types;
}

std::string contract_texts(const fs::path& folder) {
  std::ostringstream all;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".cpp") all << std::ifstream(entry.path()).rdbuf();
  }
  return all.str();
}

bool has_contract(const std::string& texts, const std::string& kind, const std::string& type) {
  return std::regex_search(texts, std::regex("TEST_CASE\\(\"" + kind + " contract: " + type + "[^a-z0-9_]"));
}

}  // namespace

TEST_CASE("plug-ins: every registered type has a config") {
  for (const PluginKind& kind : plugin_kinds()) {
    const std::set<std::string> named = types_in_configs(project_dir() / "configs", key_in_config(kind));
    for (const std::string& type : types_of(kind)) {
      INFO(kind.name << " '" << type << "': no file of configs/ names it");
      CHECK(named.count(type) == 1);
    }
  }
}

TEST_CASE("plug-ins: every registered type has a contract line") {
  const std::string texts = contract_texts(project_dir() / "tests/contracts");
  for (const PluginKind& kind : plugin_kinds()) {
    for (const std::string& type : types_of(kind)) {
      INFO("no TEST_CASE(\"" << kind.name << " contract: " << type << "\") in tests/contracts");
      CHECK(has_contract(texts, kind.name, type));
    }
  }
}

TEST_CASE("plug-ins: a type without a contract line is noticed") {
  const std::string texts = "TEST_CASE(\"kernel contract: expm1\") {}\nTEST_CASE(\"cost contract: a, chute\") {}\n";
  CHECK(has_contract(texts, "kernel", "expm1"));
  CHECK(has_contract(texts, "cost", "a"));
  CHECK_FALSE(has_contract(texts, "kernel", "exp"));
  CHECK_FALSE(has_contract(texts, "solver", "expm1"));
}

TEST_CASE("plug-ins: a type without a config is noticed") {
  const ScratchDir folder;
  std::ofstream(folder / "one.yaml") << "manifold: {type: mesh, file: a.obj}\ncost: euclidean\nkernel: exp\n"
                                        "ends: {source: {vertex: 0}, target: {vertex: 1}}\npost_process: [trace]\n";
  CHECK(types_in_configs(folder.path(), "manifold") == std::set<std::string>{"mesh"});
  CHECK(types_in_configs(folder.path(), "kernel") == std::set<std::string>{"exp"});
  CHECK(types_in_configs(folder.path(), "initializer") == std::set<std::string>{"dijkstra"});  // the default on a mesh
  CHECK(types_in_configs(folder.path(), "post_process") == std::set<std::string>{"trace"});
}

}  // namespace leastcost::test
