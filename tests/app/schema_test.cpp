// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The JSON schema against a small validator of the part of draft 7 that it uses: it accepts every shipped
// configuration, and refuses what the program refuses.
#include <nlohmann/json.hpp>
#include <regex>

#include "app/reference/describe.hpp"
#include "app/study/study_facts.hpp"
#include "catalogue/yaml/scalars.hpp"
#include "catalogue/yaml/yaml_reader.hpp"
#include "tests/app/config_text.hpp"
#include "tests/app/study_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Json = nlohmann::json;

Json to_json(const ConfigNode& node) {
  Json out;
  if (node.is_list()) {
    out = Json::array();
    for (const ConfigNode& item : node.items) out.push_back(to_json(item));
  } else if (node.is_block()) {
    out = Json::object();
    for (const ConfigEntry& e : node.entries) out[e.key] = to_json(e.value);
  } else if (node.is_scalar()) {
    if (const auto b = parse_bool(node).value) return *b;
    if (const auto i = parse_int(node).value) return *i;
    if (const auto d = parse_double(node).value) return *d;
    return node.text;
  }
  return out;
}

bool has_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  throw std::runtime_error("type " + type);
}

class Validator {
 public:
  explicit Validator(Json root) : root_(std::move(root)) {}
  bool valid(const Json& value) const { return valid(value, root_); }

 private:
  bool valid(const Json& value, const Json& schema) const {
    if (schema.contains("$ref"))
      return valid(value, root_.at(Json::json_pointer(schema["$ref"].get<std::string>().substr(1))));
    return right_value(value, schema) && right_object(value, schema) && right_list(value, schema) &&
           right_logic(value, schema);
  }

  static bool right_value(const Json& value, const Json& s) {
    if (s.contains("type")) {
      const Json types = s["type"].is_array() ? s["type"] : Json::array({s["type"]});
      if (std::none_of(types.begin(), types.end(), [&](const Json& t) { return has_type(value, t); })) return false;
    }
    if (s.contains("enum") && std::count(s["enum"].begin(), s["enum"].end(), value) == 0) return false;
    if (s.contains("const") && s["const"] != value) return false;
    if (value.is_string() && s.contains("minLength") && value.get<std::string>().size() < s["minLength"]) return false;
    if (!value.is_number()) return true;
    const double x = value;
    return !(s.contains("minimum") && x < s["minimum"]) && !(s.contains("maximum") && x > s["maximum"]) &&
           !(s.contains("exclusiveMinimum") && x <= s["exclusiveMinimum"]);
  }

  bool right_object(const Json& value, const Json& s) const {
    if (!value.is_object()) return true;
    for (const Json& key : s.value("required", Json::array()))
      if (!value.contains(key)) return false;
    const Json patterns = s.value("patternProperties", Json::object());
    for (const auto& [key, child] : value.items()) {
      bool known = false;
      if (s.contains("properties") && s["properties"].contains(key)) {
        known = true;
        if (!valid(child, s["properties"][key])) return false;
      }
      for (const auto& [pattern, inner] : patterns.items())
        if (std::regex_search(key, std::regex(pattern))) {
          known = true;
          if (!valid(child, inner)) return false;
        }
      if (known || !s.contains("additionalProperties")) continue;
      const Json& others = s["additionalProperties"];
      if (others == false || (others.is_object() && !valid(child, others))) return false;
    }
    return true;
  }

  bool right_list(const Json& value, const Json& s) const {
    if (!value.is_array()) return true;
    if (s.contains("minItems") && value.size() < s["minItems"]) return false;
    return !s.contains("items") ||
           std::all_of(value.begin(), value.end(), [&](const Json& v) { return valid(v, s["items"]); });
  }

  bool right_logic(const Json& value, const Json& s) const {
    const auto holds = [&](const Json& inner) { return valid(value, inner); };
    for (const Json& inner : s.value("allOf", Json::array()))
      if (!holds(inner)) return false;
    if (s.contains("anyOf") && std::none_of(s["anyOf"].begin(), s["anyOf"].end(), holds)) return false;
    if (s.contains("oneOf") && std::count_if(s["oneOf"].begin(), s["oneOf"].end(), holds) != 1) return false;
    if (s.contains("not") && holds(s["not"])) return false;
    if (!s.contains("if")) return true;
    const char* const branch = holds(s["if"]) ? "then" : "else";
    return !s.contains(branch) || holds(s[branch]);
  }

  Json root_;
};

Json yaml(const std::string& text) {
  Diagnostics errors("a.yaml", text);
  const ConfigNode node = read_yaml(text, errors);
  REQUIRE(errors.empty());
  return to_json(node);
}

}  // namespace

TEST_CASE("schema: draft 7, and every shipped configuration fits, also resolved") {
  const Json schema = Json::parse(app::json_schema());
  CHECK(schema["$schema"] == "http://json-schema.org/draft-07/schema#");
  const Validator validator(schema);
  for (const auto& entry : std::filesystem::directory_iterator(project_dir() / "configs")) {
    if (entry.path().extension() != ".yaml") continue;
    CAPTURE(entry.path());
    const LoadedConfig loaded = load_config(entry.path(), {});
    CHECK(validator.valid(to_json(loaded.tree)));
    CHECK(validator.valid(yaml(resolved_yaml(loaded.config))));
  }
}

TEST_CASE("schema: every shipped study fits, also resolved, wrong studies do not") {
  const Validator validator(Json::parse(app::json_schema()));
  for (const auto& entry : std::filesystem::directory_iterator(project_dir() / "configs/studies")) {
    if (entry.path().extension() != ".yaml") continue;
    CAPTURE(entry.path());
    CHECK(validator.valid(to_json(app::load_study(entry.path(), {}).tree)));
    CHECK(validator.valid(yaml(app::resolved_study(app::load_grid(entry.path(), {}), project_dir()))));
  }
  CHECK(validator.valid(yaml(kStudy)));
  CHECK(validator.valid(yaml(kStudy + "sweep: {path.cascade: [true]}\nskip: [{path.cascade: true, because: x}]\n")));
  for (const char* wrong : {"nam: x\n", "kernels: [cubic]\n", "kernels: []\n", "seeds: [x]\n", "repetitions: 0\n",
                            "sweep: {path.cascade: true}\n", "skip: [{solver: newton}]\n", "set: 3\n"}) {
    CAPTURE(wrong);
    CHECK_FALSE(validator.valid(yaml(kStudy + wrong)));
    CHECK(study_errors(kStudy + wrong) != "");
  }
}

TEST_CASE("schema: refuses what the program refuses") {
  const Validator validator(Json::parse(app::json_schema()));
  CHECK(validator.valid(yaml(kPlane)));
  const std::string ring = "manifold: euclidean\ncost: euclidean\npath: {ring: true}\n";
  CHECK(validator.valid(yaml(ring + "initializer: {type: waypoints, points: [[0, 1], [1, 0], [1, 1]]}\n")));
  const std::string mesh = "manifold: {type: mesh, file: m}\ncost: euclidean\nends: {target: {vertex: 1}, source: ";
  CHECK(validator.valid(yaml(mesh + "{face: 1, barycentric: [1, 0, 0]}}\n")));
  for (const std::string& text :
       {kPlane + "solver: {type: newton, max_iter: 3}\n", kPlane + "solver: {type: nwton}\n",
        kPlane + "solver: {tolerance: 1}\n", kPlane + "solver: {type: newton, memory: 3}\n", kPlane + "kernel: cubic\n",
        kPlane + "nam: x\n", kPlane + "path: {points: 0}\n", kPlane + "path: {points: many}\n", kPlane + "seed: 1.5\n",
        kPlane + "path: {ring: 1}\n", kPlane + "initializer: waypoints\n", kPlane + "path: {ring: true}\n",
        std::string("manifold: euclidean\ncost: euclidean\n"), ring,
        std::string("manifold: mesh\n") + kPlane.substr(kPlane.find('\n') + 1),
        mesh + "{vertex: 0, point: [0, 0, 0]}}\n", mesh + "{face: 1}}\n"}) {
    CAPTURE(text);
    CHECK_FALSE(validator.valid(yaml(text)));
    CHECK(errors_of(text) != "");
  }
}

}  // namespace leastcost::test
