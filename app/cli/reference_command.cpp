// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string_view>

#include "app/cli/command_options.hpp"
#include "app/reference/describe.hpp"
#include "app/reference/markdown.hpp"
#include "catalogue/back_ends/back_ends.hpp"
#include "catalogue/output/json_numbers.hpp"
#include "catalogue/registry/registry.hpp"
#include "catalogue/yaml/suggest.hpp"

namespace leastcost::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The key of a configuration whose items are post-processors.
constexpr std::string_view kPostProcess = "post_process";

/// Readers of meshes, for `list formats`. They are told apart by the extension of the file.
std::string formats_text() {
  return "formats: files of the mesh manifold\n"
         "  obj  Wavefront OBJ: v and f records\n"
         "  off  Object File Format\n"
         "  ply  Stanford PLY, ascii and binary\n"
         "  stl  STL, ascii and binary; equal vertices are merged\n";
}

/// Readers of rasters beside ESRI grids, where the build has them.
std::string raster_formats_text() {
  return raster_reader_of_libraries() != nullptr
             ? "rasters: asc (ESRI grid), csv, and all rasters that GDAL reads, such as GeoTIFF\n"
             : "rasters: asc (ESRI grid), csv; this build has no GDAL for GeoTIFF and others: install libgdal-dev and "
               "rebuild\n";
}

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const PluginKind& k : plugin_kinds()) names.push_back(k.plural);
  return names;
}

Exit unknown(const Streams& streams, const std::string& what, const std::string& word,
             const std::vector<std::string>& valid) {
  streams.err << fmt::format("error: unknown {} '{}'{}; valid: {}\n", what, word, did_you_mean(word, valid),
                             joined(valid));
  return Exit::usage;
}

Json kind_json(const PluginKind& kind) {
  Json out = Json::array();
  for (const PluginEntry* plugin : kind.entries)
    out.push_back({{"type", plugin->type},
                   {"summary", plugin->summary},
                   {"needs", plugin->needs},
                   {"provides", plugin->provides}});
  return out;
}

}  // namespace

Exit list_command(const std::string& kind, bool json, const Streams& streams) {
  std::vector<std::string> valid = kind_names();
  valid.emplace_back("formats");
  const PluginKind* wanted = find_kind(kind);
  if (!kind.empty() && kind != "formats" && wanted == nullptr) return unknown(streams, "kind", kind, valid);
  Json out = Json::object();
  std::string text;
  for (const PluginKind& k : plugin_kinds()) {
    if (!kind.empty() && &k != wanted) continue;
    out[k.plural] = kind_json(k);
    if (!text.empty()) text += '\n';
    text += describe_kind(k);
  }
  if (kind.empty() || kind == "formats") {
    out["formats"] = {"obj", "off", "ply", "stl"};
    if (!text.empty()) text += '\n';
    text += formats_text() + raster_formats_text();
  }
  streams.out << (json ? to_text(out) : text);
  return Exit::certified;
}

Exit describe_command(const std::string& kind, const std::string& type, const Streams& streams) {
  if ((kind == "run" || kind == "study") && type.empty()) {
    streams.out << (kind == "run" ? describe_run() : describe_study());
    return Exit::certified;
  }
  std::vector<std::string> valid;
  for (const PluginKind& k : plugin_kinds()) valid.push_back(k.name);
  if (kind == "run" || kind == "study") {  // a part of it is a kind
    const auto known = std::find(valid.begin(), valid.end(), type);
    if (known == valid.end() && type != kPostProcess) return unknown(streams, "part of a " + kind, type, valid);
    return describe_command(type, "", streams);
  }
  const PluginKind* found = find_kind(kind == kPostProcess ? "post_processor" : kind);
  if (found == nullptr) {
    valid.insert(valid.begin(), {"run", "study"});
    return unknown(streams, "kind", kind, valid);
  }
  if (type.empty()) {
    streams.out << describe_kind(*found);
    return Exit::certified;
  }
  const PluginEntry* plugin = find_plugin(*found, type);
  if (plugin == nullptr) return unknown(streams, found->name, type, types_of(*found));
  streams.out << describe_plugin(*found, *plugin);
  return Exit::certified;
}

Exit pages_command(const std::map<std::string, std::string>& pages, const std::string& folder, const Streams& streams) {
  for (const auto& [name, text] : pages) {
    const fs::path file = fs::path(folder) / name;
    std::error_code failed;
    fs::create_directories(file.parent_path(), failed);
    std::ofstream out(file, std::ios::binary);
    out << text << std::flush;
    if (out) continue;
    streams.err << fmt::format("error: cannot write {}\n", file.string());
    return Exit::output;
  }
  return Exit::certified;
}

void add_reference(const CommandLine& line) {
  OptionValues& v = line.values;
  CLI::App& list = *line.app.add_subcommand("list", "List the types that a configuration can use");
  list.add_option("kind", v.kind,
                  "manifolds, obstacles, robots, costs, kernels, initializers, solvers, post_processors, formats")
      ->type_name("KIND");
  add_format(list, v);
  list.callback([&] { line.chosen = [&] { return list_command(v.kind, v.json(), line.streams); }; });

  CLI::App& describe = *line.app.add_subcommand(
      "describe", "Describe every option of a type, of a configuration (describe run) or of a study (describe study)");
  describe
      .add_option("kind", v.kind,
                  "run, study, manifold, obstacle, robot, cost, kernel, initializer, solver, post_processor")
      ->type_name("KIND");
  describe.add_option("type", v.type, "Type to describe, e.g. euclidean; without it, all types of the kind")
      ->type_name("TYPE");
  describe
      .add_option("--markdown", v.output,
                  "Instead: write a Markdown page for each type, each kind, run and study into this folder")
      ->type_name("DIR")
      ->check(empty_fault);
  describe.callback([&] {
    if (v.kind.empty() == v.output.empty()) throw CLI::ValidationError("describe", "needs a KIND or --markdown DIR");
    line.chosen = [&] {
      return v.output.empty() ? describe_command(v.kind, v.type, line.streams)
                              : pages_command(reference_pages(), v.output, line.streams);
    };
  });

  CLI::App& schema =
      *line.app.add_subcommand("schema", "Print the JSON Schema (draft 7) of configurations and studies, for editors");
  schema.callback([&] { line.chosen = [&] { return line.streams.out << json_schema(), Exit::certified; }; });
}

}  // namespace leastcost::app
