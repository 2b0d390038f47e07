// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/reference/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "app/reference/field_list.hpp"
#include "catalogue/registry/registry.hpp"
#include "catalogue/yaml/suggest.hpp"

namespace leastcost::app {
namespace {

/// Our sentences are plain text: what Markdown would read as a mark is escaped.
std::string plain_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\`*_[]<>|$").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string code(std::string_view text) {
  if (text.empty()) return "";
  std::string out = "`";
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);  // a bar would end the cell
  return out + "`";
}

std::string page_of(const PluginKind& kind) { return kind.plural + ".md"; }

/// Tables of options. The options of a type of a variant get a table of their own, under its heading.
class OptionTables {
 public:
  explicit OptionTables(std::string root) : root_(std::move(root)) {}  ///< root: "../" where the page is in a folder

  std::string text(const std::vector<FieldInfo>& fields) {
    table("", fields);
    for (std::size_t next = 0; next < variants_.size();) {  // tables add to the list
      const auto [name, field] = variants_[next++];
      variant(name, field);
    }
    return std::move(out_);
  }

 private:
  void table(const std::string& prefix, const std::vector<FieldInfo>& fields) {
    out_ += "| option | value | default | meaning |\n|---|---|---|---|\n";
    rows(prefix, fields);
    out_ += "\n";
  }

  void rows(const std::string& prefix, const std::vector<FieldInfo>& fields) {
    bool end_listed = false;  // both ends have the same options
    for (const FieldInfo& field : fields) {
      const std::string name = prefix + field.key;
      out_ += fmt::format("| {} | {} | {} | {} |\n", code(name), value(field),
                          field.required ? "required" : code(field.default_value), plain_text(field.help));
      if (field.type == FieldType::variant) {
        if (has_options(field)) variants_.emplace_back(name, field);
        continue;
      }
      const bool is_end = field.type == FieldType::end;
      if (!is_end || !end_listed) rows(name + ".", field.children);
      end_listed = end_listed || is_end;
    }
  }

  void variant(const std::string& name, const FieldInfo& field) {
    for (const FieldInfo& type : field.children) {
      out_ += fmt::format("### {}: {}\n\n{}\n\n", code(name), code(type.key), plain_text(type.help));
      if (!type.children.empty()) table(name + ".", type.children);
    }
  }

  static bool has_options(const FieldInfo& variant) {
    return std::any_of(variant.children.begin(), variant.children.end(),
                       [](const FieldInfo& type) { return !type.children.empty() || !type.help.empty(); });
  }

  std::string value(const FieldInfo& field) const {
    std::string words = plain_text(field.type_in_words());
    if (field.kind != nullptr && field.type != FieldType::tree)
      words += fmt::format(" ([{}]({}{}))", field.kind->plural, root_, page_of(*field.kind));
    if (!field.unit.empty()) words += fmt::format("; unit {}", plain_text(field.unit));
    return words;
  }

  std::string root_, out_;
  std::vector<std::pair<std::string, FieldInfo>> variants_;
};

std::string options(const std::vector<FieldInfo>& fields, const char* root) {
  return fields.empty() ? "It has no options.\n" : "## Options\n\n" + OptionTables(root).text(fields);
}

std::string plugin_page(const PluginKind& kind, const PluginEntry& plugin) {
  std::string out = fmt::format("# {}\n\n{}\n\n", plain_text(plugin.type), plain_text(plugin.summary));
  out += fmt::format("A type of [{}](../{}): {}.\n\n", kind.plural, page_of(kind), plain_text(kind.summary));
  if (!plugin.needs.empty()) out += "Needs: " + plain_text(joined(plugin.needs)) + ".\n\n";
  if (!plugin.provides.empty()) out += "Provides: " + plain_text(joined(plugin.provides)) + ".\n\n";
  if (!plugin.library.empty()) out += "Uses: " + plain_text(plugin.library) + ".\n\n";
  if (!plugin.missing.empty()) out += "Not in the build that made this page: " + plain_text(plugin.missing) + "\n\n";
  return out + options(fields_of(*plugin.defaults()), "../");
}

std::string kind_page(const PluginKind& kind) {
  std::string title = plain_text(kind.plural), out;
  std::replace(title.begin(), title.end(), '_', '-');
  title.erase(std::remove(title.begin(), title.end(), '\\'), title.end());
  title.front() = static_cast<char>(title.front() - 'a' + 'A');
  out = fmt::format("# {}\n\n{}.\n\n| type | what it is |\n|---|---|\n", title, plain_text(kind.summary));
  for (const PluginEntry* plugin : kind.entries)
    out += fmt::format("| [{}]({}/{}.md) | {} |\n", plain_text(plugin->type), kind.name, plugin->type,
                       plain_text(plugin->summary));
  return out;
}

}  // namespace

std::map<std::string, std::string> reference_pages() {
  std::map<std::string, std::string> pages;
  pages["run.md"] = "# Keys of a configuration\n\nKeys that start with `x-` are for your own notes.\n\n" +
                    options(fields_of_run(), "");
  pages["study.md"] = "# Keys of a study\n\nA study is a grid of runs. A file with `problems` is a study.\n\n" +
                      options(fields_of_study(), "");
  for (const PluginKind& kind : plugin_kinds()) {
    pages[page_of(kind)] = kind_page(kind);
    for (const PluginEntry* plugin : kind.entries)
      pages[kind.name + "/" + plugin->type + ".md"] = plugin_page(kind, *plugin);
  }
  return pages;
}

}  // namespace leastcost::app
