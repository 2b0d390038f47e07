// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <utility>

#include "app/cli/command_options.hpp"
#include "app/cli/commands.hpp"
#include "app/init/templates.hpp"
#include "app/reference/describe.hpp"
#include "catalogue/yaml/suggest.hpp"

namespace leastcost::app {
namespace {

constexpr const char* kSchemaFile = "leastcost.schema.json";

Exit print_templates(const Streams& streams) {
  for (const Template& t : templates()) streams.out << fmt::format("{:<16} {}\n", t.name, t.summary);
  return Exit::certified;
}

Exit unknown_template(const std::string& name, const Streams& streams) {
  std::vector<std::string> names;
  for (const Template& t : templates()) names.push_back(t.name);
  streams.err << fmt::format("error: unknown template '{}'{}; valid: {}\n", name, did_you_mean(name, names),
                             joined(names));
  return Exit::usage;
}

/// Where the configuration goes: into a folder, unless a file is asked for.
std::filesystem::path configuration_file(const Template& starter, const std::string& path) {
  const std::filesystem::path given = path.empty() ? starter.name : path;
  const bool is_file = given.extension() == ".yaml" || given.extension() == ".yml";
  return is_file ? given : given / (starter.name + ".yaml");
}

bool write_file(const std::filesystem::path& file, const std::string& text) {
  std::error_code failed;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), failed);
  std::ofstream out(file, std::ios::binary);
  out << text << std::flush;
  return static_cast<bool>(out);
}

/// A name as a word of a shell.
std::string shell_word(const std::filesystem::path& file) {
  const std::string text = file.string();
  return text.find_first_of(" '\"$\\&|;<>()*?[]`#~") == std::string::npos ? text : "\"" + text + "\"";
}

Exit write_starter(const Template& starter, const std::filesystem::path& config, bool force, const Streams& streams) {
  const std::filesystem::path folder = config.parent_path();
  std::vector<std::pair<std::filesystem::path, std::string>> files = {{config, starter.text}};
  for (const SampleFile& sample : starter.files) files.emplace_back(folder / sample.name, sample.text());
  for (const auto& [file, text] : files)
    if (!force && std::filesystem::exists(file)) {
      streams.err << fmt::format(
          "error: {} exists and nothing was written; use another name with -o, or --force to overwrite it\n",
          file.string());
      return Exit::usage;
    }
  // One schema serves all the configurations of a folder.
  if (force || !std::filesystem::exists(folder / kSchemaFile)) files.emplace_back(folder / kSchemaFile, json_schema());
  for (const auto& [file, text] : files) {
    if (!write_file(file, text)) {
      streams.err << fmt::format("error: cannot write {}\n", file.string());
      return Exit::output;
    }
    streams.out << file.string() << '\n';
  }
  streams.out << fmt::format("Next: leastcost {} {}\n", starter.command, shell_word(config));
  return Exit::certified;
}

}  // namespace

Exit init_command(const std::string& name, const std::string& path, bool force, const Streams& streams) {
  if (name.empty()) return print_templates(streams);
  const std::vector<Template>& all = templates();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Template& t) { return t.name == name; });
  if (found == all.end()) return unknown_template(name, streams);
  if (path != "-") return write_starter(*found, configuration_file(*found, path), force, streams);
  streams.out << found->text;
  return Exit::certified;
}

void add_init(const CommandLine& line) {
  OptionValues& v = line.values;
  CLI::App& init = *line.app.add_subcommand(
      "init", "Write a commented starting configuration that runs, or, without a name, print the list of templates");
  init.footer(
      "Each template becomes a folder: the configuration, the sample data that it reads, and leastcost.schema.json, "
      "which the first line of the configuration names, for editors with the YAML language server. Files that exist "
      "are not overwritten.\n"
      "  leastcost init mesh                      mesh/mesh.yaml, ...\n"
      "  leastcost init mesh -o work/first.yaml   work/first.yaml, ...\n"
      "  leastcost init mesh -o -                 the configuration alone, on standard output");
  init.add_option("template", v.name, "Name of the template")->type_name("TEMPLATE");
  add_output(init, v, "Folder, or a .yaml file in it; default: the name of the template", "PATH");
  init.add_flag("--force", v.force, "Overwrite files that exist");
  init.callback([&] { line.chosen = [&] { return init_command(v.name, v.output, v.force, line.streams); }; });
}

}  // namespace leastcost::app
