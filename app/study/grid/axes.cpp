// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/grid/axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/config/load_config.hpp"
#include "catalogue/yaml/yaml_reader.hpp"
#include "catalogue/yaml/yaml_writer.hpp"

namespace leastcost::app {
namespace {

std::string where(const std::filesystem::path& file, const Place& place) {
  return fmt::format("{}:{}:{}", file.string(), place.line, place.column);
}

/// From now on the tree says of itself in which file it stands.
void name_places(const std::filesystem::path& file, ConfigNode& node) {
  node.place.origin = where(file, node.place);
  for (ConfigNode& item : node.items) name_places(file, item);
  for (ConfigEntry& e : node.entries) {
    e.place.origin = where(file, e.place);
    name_places(file, e.value);
  }
}

/// The configuration of a problem that names a file.
ConfigNode read_problem_file(LoadedStudy& study, const ConfigNode& name, const std::filesystem::path& file) {
  try {
    const std::string text = config_text(file);
    Diagnostics errors(file.string(), text);
    ConfigNode tree = read_yaml(text, errors);
    for (const Diagnostic& e : errors.sorted()) study.errors.error(name.place, where(file, e.place) + ": " + e.message);
    name_places(file, tree);
    return tree;
  } catch (const InputError& e) {
    study.errors.error(name.place, e.what());
    return {};
  }
}

/// Puts `set` into a configuration: every key is a path, its value replaces what is there, as --set does.
void put_options(const ConfigNode& set, ConfigNode& tree, Diagnostics& errors) {
  for (const ConfigEntry& e : set.entries)
    if (!is_note(e.key)) put_option(e.key, e.value, e.place, tree, errors);
}

std::string name_of(const StudyProblem& problem, const ProblemBase& base) {
  if (problem.name) return *problem.name;
  const ConfigEntry* named = base.tree.find("name");
  if (named != nullptr && named->value.is_scalar()) return named->value.text;
  return base.file.stem().string();
}

std::string without_line_breaks(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) text.replace(at, 1, "; ");
  return text;
}

/// A plug-in with a name is that plug-in; the name is the study's.
AxisValue named_value(ConfigNode node) {
  std::string name = node.is_scalar() ? node.text : "";
  if (node.is_block()) {
    const ConfigEntry* given = node.find("name");
    if (given == nullptr) given = node.find("type");
    if (given != nullptr) name = given->value.text;
    node.entries.erase(
        std::remove_if(node.entries.begin(), node.entries.end(), [](const ConfigEntry& e) { return e.key == "name"; }),
        node.entries.end());
  }
  if (name.empty()) name = without_line_breaks(to_yaml(node));
  return {name, std::move(node)};
}

Axis axis_of(std::string name, std::string key, const ConfigNode& list, bool plugins, Diagnostics& errors) {
  Axis axis{std::move(name), std::move(key), {}};
  std::unordered_set<std::string> known;
  for (const ConfigNode& item : list.items) {
    AxisValue value =
        plugins || item.is_scalar() ? named_value(item) : AxisValue{without_line_breaks(to_yaml(item)), item};
    if (!known.insert(value.name).second)
      errors.error(item.place,
                   fmt::format("two values of the axis {} are called {}{}", axis.name, in_quotes(value.name),
                               plugins ? ": give one another name, like {name: .., type: ..}" : ""));
    axis.values.push_back(std::move(value));
  }
  return axis;
}

}  // namespace

std::vector<ProblemBase> read_problems(LoadedStudy& study) {
  std::vector<ProblemBase> problems;
  std::unordered_set<std::string> known;
  for (const StudyProblem& problem : study.config.problems) {
    ProblemBase& base = problems.emplace_back();
    base.folder = study.folder;
    base.tree = problem.config;
    base.place = problem.config.place;
    if (problem.config.is_scalar()) {
      base.file = std::filesystem::path(problem.config.text);
      if (base.file.is_relative()) base.file = (study.folder / base.file).lexically_normal();
      base.folder = base.file.parent_path();
      base.tree = read_problem_file(study, problem.config, base.file);
    }
    base.name = name_of(problem, base);
    if (base.name.empty()) study.errors.error(base.place, "an inline problem needs a name");
    if (!known.insert(base.name).second)
      study.errors.error(base.place,
                         fmt::format("two problems are called {}: give one another name", in_quotes(base.name)));
    put_options(study.config.set, base.tree, study.errors);
    put_options(problem.set, base.tree, study.errors);
  }
  return problems;
}

std::vector<Axis> read_axes(LoadedStudy& study) {
  const StudyConfig& config = study.config;
  std::vector<Axis> axes;
  axes.push_back(axis_of("solver", "solver", config.solvers, true, study.errors));
  axes.push_back(axis_of("kernel", "kernel", config.kernels, true, study.errors));
  axes.push_back(axis_of("points", "path.points", config.points, false, study.errors));
  axes.push_back(axis_of("seed", "seed", config.seeds, false, study.errors));
  for (const ConfigEntry& swept : config.sweep.entries) {
    if (is_note(swept.key)) continue;
    for (const Axis& axis : axes)
      if (axis.key == swept.key && (axis.given() || axis.name == axis.key))
        study.errors.error(swept.place, fmt::format("{} has an axis of its own: {}", in_quotes(swept.key), axis.name));
    axes.push_back(axis_of(swept.key, swept.key, swept.value, false, study.errors));
  }
  return axes;
}

}  // namespace leastcost::app
