// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/grid/study_config.hpp"

#include "catalogue/config/load_config.hpp"
#include "catalogue/config/run_checks.hpp"
#include "catalogue/options/options_reader.hpp"
#include "catalogue/registry/registry.hpp"
#include "catalogue/yaml/yaml_reader.hpp"

namespace leastcost::app {
namespace {

/// The conditions of a skip: which axes there are depends on the sweep.
BlockList skips_of(StudyConfig& config) {
  const auto fields = [&config](std::size_t i, RunVisitor& visit) {
    StudySkip& skip = config.skip[i];
    std::vector<std::string> axes = standing_axes();
    for (const ConfigEntry& swept : config.sweep.entries) axes.push_back(swept.key);
    for (const std::string& axis : axes)
      visit.field(axis, skip.values[axis], {.help = "Skip only cells whose " + axis + " is one of these values."});
    visit.field("because", skip.because, {.help = "Reason, shown in the summary.", .required = true});
  };
  return {[&config] { return config.skip.size(); }, [&config](std::size_t n) { config.skip.resize(n); }, fields};
}

/// The keys of `set` and `sweep` are paths themselves: --set set.path.points=10 gives `set` the entry path.points.
/// Returns false for other overrides.
bool put_path_entry(const Override& override, ConfigNode& tree, Diagnostics& errors) {
  for (const std::string block : {"set", "sweep"}) {
    const std::size_t equals = override.assignment.find('=');
    if (override.assignment.rfind(block + ".", 0) != 0 || equals == std::string::npos) continue;
    const std::string key = override.assignment.substr(block.size() + 1, equals - block.size() - 1);
    const Place place{0, 0, 1, override.origin};
    ConfigNode value = read_yaml_value(override.assignment.substr(equals + 1), override.origin, errors);
    value.place = place;
    ConfigEntry* entry = tree.find(block);
    if (entry == nullptr || !entry->value.is_block()) {
      put_option(block, {}, place, tree, errors);
      entry = tree.find(block);
      entry->value.kind = ConfigNode::Kind::block;
    }
    if (ConfigEntry* old = entry->value.find(key))
      old->value = std::move(value);
    else
      entry->value.entries.push_back({key, place, std::move(value)});
    return true;
  }
  return false;
}

}  // namespace

const std::vector<std::string>& standing_axes() {
  static const std::vector<std::string> axes = {"problem", "solver", "kernel", "points", "seed"};
  return axes;
}

void StudyProblem::fields(RunVisitor& visit) {
  visit.field("name", name, {.help = "Name of the problem in tables; default: the name of its configuration."});
  visit.tree(
      "config", config, TreeForm::run, nullptr,
      {.help = "The run: a configuration file relative to this one, or the configuration itself.", .required = true});
  visit.field("optimum", optimum,
              {.help = "True least cost, if known.", .unit = "cost", .minimum = 0, .exclusive_minimum = true});
  visit.tree("set", set, TreeForm::options, nullptr, {.help = "Options of this problem only."});
  visit.field("optional", optional, {.help = "Skip the problem if one of its files does not exist."});
}

void StudyConfig::fields(RunVisitor& visit) {
  visit.field("name", name, {.help = "Name of the study and of its output folder; default: that of the file."});
  visit.field("seed", seed,
              {.help = "Master seed. The seed of a cell comes from `seeds`, else from its configuration, else from "
                       "this seed and the problem's name.",
               .minimum = 0});
  visit.blocks("problems", blocks_of(problems), {.help = "Problems to solve.", .required = true});
  visit.tree("solvers", solvers, TreeForm::plugins, &kind("solver"),
             {.help = "Solvers; give each a name if two have the same type. Default: that of each problem."});
  visit.tree("kernels", kernels, TreeForm::plugins, &kind("kernel"),
             {.help = "Kernels; default: that of each problem."});
  visit.tree("points", points, TreeForm::counts, nullptr,
             {.help = "Numbers of points; default: that of each problem."});
  visit.tree("seeds", seeds, TreeForm::integers, nullptr, {.help = "Seeds of the random numbers."});
  visit.tree("sweep", sweep, TreeForm::sweep, nullptr, {.help = "Further axes: any options, each with its values."});
  visit.tree("set", set, TreeForm::options, nullptr, {.help = "Options of every cell."});
  visit.blocks("skip", skips_of(*this), {.help = "Cells to leave out, with the reason."});
  visit.field("repetitions", repetitions, {.help = "How often each cell is run.", .minimum = 1, .maximum = 1000});
  visit.field_or_zero(
      "max_seconds", max_seconds,
      {.help = "Time budget of one repetition of one cell, from the first path to the certificate; 0: none.",
       .unit = "s",
       .minimum = 0,
       .maximum = 1e9});
  visit.field("grace_seconds", grace_seconds,
              {.help = "Time after the budget at which the process is killed; includes reading files.",
               .unit = "s",
               .minimum = 0,
               .maximum = 1e9});
  visit.field_or_zero(
      "max_evaluations", max_evaluations,
      {.help = "Limit on energy and gradient evaluations of every solver without its own limit; 0: the solver's.",
       .minimum = 0});
  visit.field_or_zero("max_memory", max_memory,
                      {.help = "Limit on the address space of one cell; 0: none.", .unit = "MB", .minimum = 0});
}

bool is_study(const std::string& text) {
  Diagnostics ignored("", text);
  return read_yaml(text, ignored).find("problems") != nullptr;
}

LoadedStudy parse_study(std::string text, const std::string& file_name, const std::filesystem::path& folder,
                        const std::vector<Override>& overrides, const Externals& externals) {
  LoadedStudy loaded{file_name, folder, std::move(text), {}, {}, {file_name, ""}, externals};
  loaded.errors = Diagnostics(file_name, loaded.text);
  loaded.tree = read_yaml(loaded.text, loaded.errors);
  const bool readable = loaded.errors.empty();
  for (const Override& override : overrides)
    if (!put_path_entry(override, loaded.tree, loaded.errors)) apply_overrides({override}, loaded.tree, loaded.errors);
  if (!readable && !loaded.tree.is_block()) return loaded;
  const std::string stem = std::filesystem::path(file_name).stem().string();
  loaded.config.name = stem.empty() ? "study" : stem;
  if (const ConfigEntry* run = loaded.tree.find("manifold"); run != nullptr && !loaded.tree.find("problems")) {
    loaded.errors.error(run->place, "this file has 'manifold', so it is a run: run it with leastcost run");
    return loaded;
  }
  OptionsReader reader(loaded.tree, "", {1, 1, 1, ""}, loaded.errors);
  loaded.config.fields(reader);
  reader.finish();
  const ConfigEntry* name = loaded.tree.find("name");
  const std::string fault = name_fault(loaded.config.name);
  if (!fault.empty()) loaded.errors.error(name != nullptr ? name->value.place : Place{1, 1, 1, ""}, fault);
  return loaded;
}

LoadedStudy load_study(const std::filesystem::path& file, const std::vector<Override>& overrides,
                       const Externals& externals) {
  return parse_study(config_text(file), file.string(), file.parent_path(), overrides, externals);
}

}  // namespace leastcost::app
