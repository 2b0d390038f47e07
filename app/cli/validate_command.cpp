// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/cli/command_options.hpp"
#include "app/study/study_files.hpp"
#include "catalogue/config/load_config.hpp"
#include "catalogue/config/raster_reading.hpp"
#include "catalogue/output/json_numbers.hpp"
#include "catalogue/run/compose.hpp"
#include "catalogue/run/missing_files.hpp"

namespace leastcost::app {
namespace {

using Json = nlohmann::ordered_json;

Json diagnostics_json(const Diagnostics& diagnostics) {
  Json out = Json::array();
  for (const Diagnostic& e : diagnostics.sorted()) {
    Json error = {{"line", nullptr}, {"column", nullptr}, {"origin", nullptr}, {"message", e.message}};
    if (!e.place.origin.empty())
      error["origin"] = e.place.origin;
    else if (e.place.line > 0)
      error["line"] = e.place.line, error["column"] = e.place.column;
    out.push_back(error);
  }
  return out;
}

/// What a default is chosen for that may take a while, and how to do without it; else nothing.
std::string word_on_default(const LoadedConfig& loaded) {
  std::string words = word_on_interpolation(loaded);
  if (!words.empty()) words = "  " + words + "\n";
  const PluginChoice& first = loaded.config.initializer;
  if (!first || first.plugin->type != "eikonal" || loaded.tree.find("initializer") != nullptr) return words;
  return words +
         "  first path: from an arrival-cost field over the two coordinates, which finds paths on all sides\n"
         "  (initializer: eikonal); to begin with the straight line, set 'initializer: straight'\n";
}

/// What is known only with the contents of files, which are not read.
std::string word_on_files(const std::vector<std::string>& files, const char* command) {
  if (files.empty()) return "";
  return fmt::format("  not checked: the contents of {}; leastcost {} reads {}\n", fmt::join(files, ", "), command,
                     files.size() == 1 ? "it" : "them");
}

/// The files of all cells that are run, each once, in the order of the cells.
std::vector<std::string> files_of_cells(const StudyGrid& grid) {
  std::vector<std::string> all;
  for (const StudyCell& cell : grid.cells) {
    if (!cell.skipped.empty()) continue;
    for (std::string& file : files_of(cell.config))
      if (std::find(all.begin(), all.end(), file) == all.end()) all.push_back(std::move(file));
  }
  return all;
}

/// What is beside the errors of a configuration.
struct Beside {
  std::string word;                      ///< to say
  std::vector<std::string> not_checked;  ///< files whose contents were not
};

/// The errors of a configuration or a study. An unreadable file is one more error, so that the other files get their
/// turn.
Diagnostics errors_in(const std::string& file, const std::vector<Override>& overrides, bool& readable, Beside& beside) {
  try {
    const ConfigText source = config_source(file);
    if (is_study(source.text)) {
      LoadedStudy study = parse_study(source.text, source.name, source.folder, overrides);
      const StudyGrid grid = make_grid(study, CellChecks::parts);
      if (study.errors.empty()) beside.not_checked = files_of_cells(grid);
      beside.word = word_on_files(beside.not_checked, "study");
      return study.errors;
    }
    LoadedConfig loaded = parse_config(source.text, source.name, source.folder, overrides);
    if (loaded.errors.empty()) check_parts(loaded);
    if (loaded.errors.empty())
      for (const MissingFile& missing : missing_files(loaded))
        loaded.errors.error(missing.named, missing.file + ": no such file");
    if (!loaded.errors.empty()) return loaded.errors;
    beside.not_checked = files_of(loaded.config);
    beside.word = word_on_default(loaded) + word_on_files(beside.not_checked, "run");
    return loaded.errors;
  } catch (const InputError& e) {
    readable = false;
    Diagnostics none(file, "");
    none.error({}, e.what());
    return none;
  }
}

}  // namespace

Exit validate_command(const std::vector<std::string>& files, const std::vector<Override>& overrides, bool json,
                      const Streams& streams) {
  Json report = Json::array();
  bool all_valid = true, all_readable = true;
  for (const std::string& file : files) {
    Beside beside;
    const Diagnostics errors = errors_in(file, overrides, all_readable, beside);
    const bool valid = errors.empty();
    all_valid = all_valid && valid;
    report.push_back(
        {{"file", file}, {"valid", valid}, {"errors", diagnostics_json(errors)}, {"not_checked", beside.not_checked}});
    if (!valid) streams.err << errors.render(streams.color) << errors.count() << '\n';
    if (valid && !json) streams.out << file << ": valid\n" << beside.word;
  }
  if (json) streams.out << to_text({{"valid", all_valid}, {"files", report}});
  if (!all_readable) return Exit::input;
  return all_valid ? Exit::certified : Exit::configuration;
}

void add_validate(const CommandLine& line) {
  OptionValues& v = line.values;
  CLI::App& c = *line.app.add_subcommand(
      "validate", "Check configurations and print every error with its position, without solving");
  c.add_option("configs", v.configs, "Configurations (YAML); - reads standard input")
      ->required()
      ->type_name("CONFIG...");
  add_set(c, v);
  add_format(c, v);
  c.callback([&] { line.chosen = [&] { return validate_command(v.configs, v.overrides(), v.json(), line.streams); }; });
}

}  // namespace leastcost::app
