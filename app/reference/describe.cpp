// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/reference/describe.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/reference/field_list.hpp"
#include "catalogue/yaml/suggest.hpp"

namespace leastcost::app {
namespace {

std::string facts(const FieldInfo& field) {
  std::string line = field.type_in_words();
  if (!field.unit.empty()) line += " [" + field.unit + "]";
  if (field.required) return line + "; required";
  if (!field.default_value.empty()) line += "; default " + field.default_value;
  return line;
}

void append_fields(const std::vector<FieldInfo>& fields, std::size_t indent, std::string& out);

void append_types(const std::vector<FieldInfo>& types, std::size_t indent, std::string& out) {
  for (const FieldInfo& type : types) {
    out += fmt::format("{:{}}type {}: {}\n", "", indent, type.key, type.help);
    append_fields(type.children, indent + 2, out);
  }
}

void append_fields(const std::vector<FieldInfo>& fields, std::size_t indent, std::string& out) {
  std::size_t width = 0;
  for (const FieldInfo& field : fields) width = std::max(width, field.key.size());
  bool end_described = false;  // both ends have the same options
  for (const FieldInfo& field : fields) {
    out += fmt::format("{:{}}{:<{}}  {}\n", "", indent, field.key, width, facts(field));
    out += fmt::format("{:{}}{}\n", "", indent + width + 2, field.help);
    if (field.type == FieldType::variant) {
      append_types(field.children, indent + width + 2, out);
      continue;
    }
    const bool is_end = field.type == FieldType::end;
    if (!is_end || !end_described) append_fields(field.children, indent + width + 2, out);
    end_described = end_described || is_end;
  }
}

}  // namespace

std::string describe_plugin(const PluginKind& kind, const PluginEntry& plugin) {
  std::string out = fmt::format("{} {}\n{}\n", kind.name, plugin.type, plugin.summary);
  if (!plugin.missing.empty()) out += fmt::format("Not in this build: {}\n", plugin.missing);
  if (!plugin.needs.empty()) out += "Needs: " + joined(plugin.needs) + ".\n";
  if (!plugin.provides.empty()) out += "Provides: " + joined(plugin.provides) + ".\n";
  const std::vector<FieldInfo> fields = fields_of(*plugin.defaults());
  out += fields.empty() ? "\nIt has no options.\n" : "\nOptions:\n";
  append_fields(fields, 2, out);
  return out;
}

std::string describe_kind(const PluginKind& kind) {
  std::string out = fmt::format("{}: {}\n", kind.plural, kind.summary);
  std::size_t width = 0;
  for (const PluginEntry* plugin : kind.entries) width = std::max(width, plugin->type.size());
  for (const PluginEntry* plugin : kind.entries)
    out += fmt::format("  {:<{}}  {}{}\n", plugin->type, width, plugin->summary,
                       plugin->missing.empty() ? "" : " Not in this build: " + plugin->missing);
  return out;
}

std::string describe_run() {
  std::string out = "run\nThe keys of a configuration. Keys that start with x- are for your own notes.\n\nOptions:\n";
  append_fields(fields_of_run(), 2, out);
  return out;
}

std::string describe_study() {
  std::string out =
      "study\nThe keys of a study: a grid of runs. A file with `problems` is a study.\nKeys that start with x- are for "
      "your own notes.\n\nOptions:\n";
  append_fields(fields_of_study(), 2, out);
  return out;
}

}  // namespace leastcost::app
