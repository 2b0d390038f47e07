// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/reference/describe.hpp"
#include "app/reference/field_list.hpp"
#include "catalogue/registry/registry.hpp"

namespace leastcost::app {
namespace {

using Json = nlohmann::ordered_json;

Json object_schema(const std::vector<FieldInfo>& fields);

std::string definition(const PluginKind& kind) { return "#/definitions/" + kind.name; }

void add_range(const FieldInfo& field, Json& out) {
  if (std::isfinite(field.minimum)) out[field.exclusive_minimum ? "exclusiveMinimum" : "minimum"] = field.minimum;
  if (std::isfinite(field.maximum)) out["maximum"] = field.maximum;
}

Json ranged(const char* type, const FieldInfo& field) {
  Json out = {{"type", type}};
  add_range(field, out);
  return out;
}

Json list_of(Json items) { return {{"type", "array"}, {"minItems", 1}, {"items", std::move(items)}}; }

Json named_numbers_schema(const FieldInfo& field) {
  return {{"type", "object"},
          {"patternProperties", {{"^x-", Json::object()}}},
          {"additionalProperties", ranged("number", field)}};
}

/// A text, or several; any scalar is taken as it is written.
Json texts_schema() {
  const Json text = {{"type", {"string", "number", "boolean"}}};
  return {{"anyOf", {text, list_of(text)}}};
}

/// A block whose `type` decides which options it has, or the word alone where no option is required. A type that alone
/// has options need not be named beside them where `lone_options`.
Json variant_schema(const std::vector<FieldInfo>& types, bool lone_options = false) {
  Json words = Json::array(), names = Json::array(), cases = Json::array();
  for (const FieldInfo& type : types) {
    Json then = object_schema(type.children);
    then["properties"]["type"] = {{"const", type.key}, {"description", type.help}};
    names.push_back(type.key);
    if (!then.contains("required")) words.push_back(type.key);
    cases.push_back(
        {{"if", {{"properties", {{"type", {{"const", type.key}}}}}, {"required", {"type"}}}}, {"then", then}});
  }
  Json block = {{"type", "object"}, {"properties", {{"type", {{"enum", names}}}}}};
  const auto has_options = [](const FieldInfo& type) { return !type.children.empty(); };
  if (lone_options && std::count_if(types.begin(), types.end(), has_options) == 1) {
    const auto lone = std::find_if(types.begin(), types.end(), has_options);
    Json then = object_schema(lone->children);
    then["properties"]["type"] = {{"const", lone->key}};
    cases.push_back({{"if", {{"not", {{"required", {"type"}}}}}}, {"then", then}});
  } else {
    block["required"] = {"type"};
  }
  block["allOf"] = cases;
  Json out = Json::object();
  out["anyOf"] = words.empty() ? Json::array({block}) : Json::array({{{"enum", words}}, block});
  return out;
}

/// Exactly one way to say where an end is.
Json end_schema(const FieldInfo& field) {
  Json out = object_schema(field.children);
  out["oneOf"] = {{{"required", {"vertex"}}}, {{"required", {"face", "barycentric"}}},
                  {{"required", {"point"}}},  {{"required", {"lonlat"}}},
                  {{"required", {"state"}}},  {{"required", {"points"}}},
                  {{"required", {"tool"}}}};
  return out;
}

/// What a study puts into configurations.
Json tree_schema(const FieldInfo& field) {
  const Json whole = {{"type", "integer"}};
  switch (field.form) {
    case TreeForm::run: return {{"anyOf", {{{"type", "string"}}, {{"$ref", "#/definitions/part_of_run"}}}}};
    case TreeForm::options: return {{"type", "object"}};
    case TreeForm::sweep:
      return {{"type", "object"},
              {"patternProperties", {{"^x-", Json::object()}}},
              {"additionalProperties", list_of(Json::object())}};
    case TreeForm::plugins: return list_of({{"$ref", definition(*field.kind) + "_with_name"}});
    case TreeForm::counts: return list_of({{"anyOf", {whole, {{"const", "auto"}}}}});
    case TreeForm::integers: return list_of(whole);
  }
  return Json::object();
}

Json value_schema(const FieldInfo& field) {
  switch (field.type) {
    case FieldType::boolean: return {{"type", "boolean"}};
    case FieldType::integer: return ranged("integer", field);
    case FieldType::number: return ranged("number", field);
    case FieldType::text: return {{"type", {"string", "number", "boolean"}}};  // any scalar is taken as it is written
    case FieldType::file: return {{"type", "string"}, {"minLength", 1}};
    case FieldType::numbers: return {{"anyOf", {ranged("number", field), list_of(ranged("number", field))}}};
    case FieldType::matrix: return list_of(list_of(ranged("number", field)));
    case FieldType::named_numbers: return named_numbers_schema(field);
    case FieldType::texts: return texts_schema();
    case FieldType::choice: return {{"enum", field.choices}};
    case FieldType::block: return object_schema(field.children);
    case FieldType::variant: return variant_schema(field.children, true);
    case FieldType::switch_or_number: return {{"anyOf", {{{"type", "boolean"}}, ranged("number", field)}}};
    case FieldType::points: return {{"anyOf", {ranged("integer", field), {{"const", "auto"}}}}};
    case FieldType::end: return end_schema(field);
    case FieldType::plugin: return {{"$ref", definition(*field.kind)}};
    case FieldType::plugins: return {{"type", "array"}, {"items", {{"$ref", definition(*field.kind)}}}};
    case FieldType::blocks: return list_of(object_schema(field.children));
    case FieldType::tree: return tree_schema(field);
  }
  return Json::object();
}

Json field_schema(const FieldInfo& field) {
  Json out = value_schema(field);
  if (out.contains("$ref")) return {{"allOf", {out}}, {"description", field.help}};  // nothing may stand beside $ref
  out["description"] = field.unit.empty() ? field.help : field.help + " [" + field.unit + "]";
  if (!field.default_value.empty()) {
    const Json value = Json::parse(field.default_value, nullptr, false);
    out["default"] = value.is_discarded() ? Json(field.default_value) : value;
  }
  return out;
}

Json object_schema(const std::vector<FieldInfo>& fields) {
  Json properties = Json::object(), required = Json::array();
  for (const FieldInfo& field : fields) {
    properties[field.key] = field_schema(field);
    if (field.required) required.push_back(field.key);
  }
  Json out = {{"type", "object"},
              {"properties", properties},
              {"patternProperties", {{"^x-", Json::object()}}},
              {"additionalProperties", false}};
  if (!required.empty()) out["required"] = required;
  return out;
}

FieldInfo name_field() {
  FieldInfo name;
  name.key = "name";
  name.help = "Name in the tables of the study; default: the type.";
  return name;
}

Json plugin_schema(const PluginKind& kind, bool with_name = false) {
  std::vector<FieldInfo> types;
  for (const PluginEntry* plugin : kind.entries) {
    FieldInfo& type = types.emplace_back();
    type.key = plugin->type;
    type.help = plugin->summary;
    type.children = fields_of(*plugin->defaults());
    if (with_name) type.children.push_back(name_field());
  }
  Json out = {{"description", kind.summary}};
  out.update(variant_schema(types));
  return out;
}

Json run_schema() {
  Json out = object_schema(fields_of_run());
  // A ring has no ends, but for a fixed point; an open path needs them.
  const Json ring = {
      {"properties", {{"path", {{"properties", {{"ring", {{"const", true}}}}}, {"required", {"ring"}}}}}},
      {"required", {"path"}}};
  out["if"] = ring;
  const Json beyond = {{"anyOf", {{{"required", {"target"}}}, {{"required", {"pairs"}}}}}};
  const Json fixed_point = {{"required", {"source"}}, {"not", beyond}};
  const Json two_or_many = {{"oneOf", {{{"required", {"source", "target"}}}, {{"required", {"pairs"}}}}}};
  out["then"] = {{"properties", {{"ends", fixed_point}}}, {"required", {"initializer"}}};
  out["else"] = {{"properties", {{"ends", two_or_many}}}, {"required", {"ends"}}};
  return out;
}

/// A configuration in a study: what it lacks, the study may set.
Json part_of_run_schema() {
  std::vector<FieldInfo> fields = fields_of_run();
  for (FieldInfo& field : fields) {
    field.required = false;
    for (FieldInfo& child : field.children) child.required = false;
  }
  return object_schema(fields);
}

Json study_schema() {
  Json out = object_schema(fields_of_study());
  // Swept keys are axes too.
  out["properties"]["skip"]["items"]["additionalProperties"] = texts_schema();
  return out;
}

}  // namespace

std::string json_schema() {
  Json out = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "leastcost run or study"}};
  out["if"] = {{"required", {"problems"}}};
  out["then"] = {{"$ref", "#/definitions/study"}};
  out["else"] = {{"$ref", "#/definitions/run"}};
  out["definitions"]["run"] = run_schema();
  out["definitions"]["part_of_run"] = part_of_run_schema();
  out["definitions"]["study"] = study_schema();
  for (const PluginKind& kind : plugin_kinds()) {
    out["definitions"][kind.name] = plugin_schema(kind);
    if (kind.name == "solver" || kind.name == "kernel")
      out["definitions"][kind.name + "_with_name"] = plugin_schema(kind, true);
  }
  return out.dump(2) + "\n";
}

}  // namespace leastcost::app
