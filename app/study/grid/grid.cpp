// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/grid/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <tuple>
#include <unordered_set>

#include "app/study/grid/axes.hpp"
#include "catalogue/config/load_config.hpp"
#include "catalogue/options/options_reader.hpp"
#include "catalogue/output/manifest.hpp"
#include "catalogue/registry/registry.hpp"
#include "catalogue/run/compose.hpp"
#include "catalogue/yaml/suggest.hpp"

namespace leastcost::app {
namespace {

constexpr std::size_t kMostCells = 1000000;

/// Where a study gives the values of an axis.
std::string key_of(const Axis& axis) {
  const std::vector<std::string>& standing = standing_axes();
  if (std::count(standing.begin(), standing.end(), axis.name) == 0) return "sweep";
  return axis.name == "points" ? axis.name : axis.name + "s";
}

/// Which value of each axis a cell has, the problem first.
using Choice = std::vector<std::size_t>;
using Words = std::unordered_set<std::string>;

class GridBuilder {
 public:
  GridBuilder(LoadedStudy& study, CellChecks checks)
      : study_(study),
        checks_(checks),
        problems_(read_problems(study)),
        axes_(read_axes(study)),
        errors_(study.errors) {}

  StudyGrid build() {
    StudyGrid grid{study_.config.name, study_.config, study_.file, {study_.file}, {}, {}};
    for (const ProblemBase& problem : problems_)
      if (!problem.file.empty()) grid.inputs.push_back(problem.file);
    for (std::size_t k = standing_axes().size() - 1; k < axes_.size(); ++k) grid.swept_keys.push_back(axes_[k].name);
    check_sets();
    check_skips();
    if (!errors_.empty() || !check_size()) return grid;
    Choice choice(axes_.size() + 1, 0);
    do {
      grid.cells.push_back(cell(static_cast<long>(grid.cells.size()), choice));
    } while (next(choice));
    return grid;
  }

 private:
  std::size_t size_of(std::size_t axis) const {
    return axis == 0 ? problems_.size() : std::max<std::size_t>(1, axes_[axis - 1].values.size());
  }

  bool check_size() {
    double cells = 1;
    for (std::size_t i = 0; i <= axes_.size(); ++i) cells *= static_cast<double>(size_of(i));
    if (cells <= static_cast<double>(kMostCells)) return true;
    errors_.error({1, 1, 1, ""}, fmt::format("the grid has {:.3g} cells; the limit is {}", cells, kMostCells));
    return false;
  }

  /// Counts like an odometer; false after the last one.
  bool next(Choice& choice) const {
    for (std::size_t i = choice.size(); i-- > 0;) {
      if (++choice[i] < size_of(i)) return true;
      choice[i] = 0;
    }
    return false;
  }

  StudyCell cell(long number, const Choice& choice) {
    const ProblemBase& problem = problems_[choice[0]];
    StudyCell out;
    out.number = number;
    out.folder = problem.folder;
    out.optimum = study_.config.problems[choice[0]].optimum;
    LoadedConfig loaded{{}, problem.folder, "", problem.tree, problem.place, {}, {study_.file.string(), ""}};
    for (std::size_t k = 0; k < axes_.size(); ++k)
      if (axes_[k].given()) put(axes_[k], choice[k + 1], loaded);
    add_options(study_.config.problems[choice[0]].set, loaded);
    add_options(study_.config.set, loaded);
    const std::string absent = take_absent_solver(loaded.tree, out.skipped);
    read_tree(loaded, problem.name, study_.externals);
    if (checks_ == CellChecks::parts && loaded.errors.empty()) check_parts(loaded);
    if (loaded.errors.empty() && loaded.config.has_pairs())
      loaded.add_error("ends.pairs", "is for `leastcost run`; a problem of a study has one source and one target");
    add_errors(loaded.errors, problem);
    if (!loaded.errors.empty()) return out;
    complete(loaded, problem);
    out.config = std::move(loaded.config);
    out.values = values(choice, out.config, absent);
    if (out.skipped.empty()) out.skipped = missing_file(choice[0], out);
    if (out.skipped.empty()) out.skipped = skip_reason(out.values);
    return out;
  }

  void put(const Axis& axis, std::size_t value, LoadedConfig& loaded) {
    const ConfigNode& node = axis.values[value].node;
    put_option(axis.key, node, node.place, loaded.tree, loaded.errors);
  }

  /// The options in `set` of what an axis has just put there (solver.tolerance), unless its value says otherwise.
  void add_options(const ConfigNode& set, LoadedConfig& loaded) const {
    for (const Axis& axis : axes_)
      for (const ConfigEntry& e : set.entries)
        if (axis.given() && e.key.rfind(axis.key + ".", 0) == 0 && node_at(loaded.tree, e.key) == nullptr)
          put_option(e.key, e.value, e.place, loaded.tree, loaded.errors);
  }

  /// A key has one place in a study.
  void check_sets() {
    const auto check = [&](const ConfigNode& set) {
      for (const ConfigEntry& e : set.entries)
        for (const Axis& axis : axes_)
          if (axis.given() && e.key == axis.key)
            errors_.error(e.place, fmt::format("{} is an axis of this study: its values are under {}", in_quotes(e.key),
                                               key_of(axis)));
    };
    check(study_.config.set);
    for (const StudyProblem& problem : study_.config.problems) check(problem.set);
  }

  /// A solver that this build has not: taken out of the configuration, so that the rest is checked all the same. Its
  /// type.
  static std::string take_absent_solver(ConfigNode& tree, std::string& skipped) {
    const ConfigEntry* entry = tree.find("solver");
    if (entry == nullptr) return "";
    const ConfigEntry* type = entry->value.find("type");
    std::string word = type != nullptr ? type->value.text : entry->value.text;
    const PluginEntry* plugin = find_plugin(kind("solver"), word);
    if (plugin == nullptr || plugin->missing.empty()) return "";
    skipped = fmt::format("solver {} is not in this build: {}", in_quotes(word), plugin->missing);
    tree.entries.erase(std::remove_if(tree.entries.begin(), tree.entries.end(),
                                      [](const ConfigEntry& e) { return e.key == "solver"; }),
                       tree.entries.end());
    return word;
  }

  /// What the study says for every cell, and its seed.
  void complete(LoadedConfig& loaded, const ProblemBase& problem) const {
    const StudyConfig& study = study_.config;
    if (study.max_seconds) loaded.config.max_seconds = study.max_seconds;
    if (loaded.tree.find("seed") == nullptr) loaded.config.seed = seed_of(problem);
    const ConfigEntry* solver = loaded.tree.find("solver");
    const bool limited = solver != nullptr && solver->value.find("max_evaluations") != nullptr;
    if (!study.max_evaluations || limited) return;
    // Read as if it stood there: a solver without such an option does not ask for it.
    ConfigNode block;
    block.kind = ConfigNode::Kind::block;
    block.entries.push_back({"max_evaluations", {}, scalar_node(std::to_string(*study.max_evaluations))});
    Diagnostics ignored("", "");
    OptionsReader reader(block, "solver", {}, ignored);
    loaded.config.solver.options->fields(reader);
  }

  /// One seed per problem, whatever the solver, kernel and number of points: they are compared from the same first
  /// path.
  int seed_of(const ProblemBase& problem) const {
    const std::string hash = sha256_of_text(fmt::format("{}\n{}", study_.config.seed, problem.name));
    return static_cast<int>(std::strtoul(hash.substr(0, 8).c_str(), nullptr, 16) & 0x7fffffffU);
  }

  std::vector<std::string> values(const Choice& choice, const RunConfig& config, const std::string& absent) const {
    std::vector<std::string> out = {problems_[choice[0]].name, absent.empty() ? config.solver.plugin->type : absent,
                                    config.kernel.plugin->type, config.points ? std::to_string(*config.points) : "auto",
                                    std::to_string(config.seed)};
    out.resize(axes_.size() + 1);
    for (std::size_t k = 0; k < axes_.size(); ++k)
      if (axes_[k].given()) out[k + 1] = axes_[k].values[choice[k + 1]].name;
    return out;
  }

  std::string missing_file(std::size_t problem, const StudyCell& cell) const {
    if (!study_.config.problems[problem].optional) return "";
    std::error_code error;
    for (const std::string& file : files_of(cell.config))
      if (!std::filesystem::exists(cell.folder / file, error)) return fmt::format("there is no file {}", file);
    return "";
  }

  /// The values of a skip by the number of their axis, for a quick look in every cell.
  std::vector<Words> words_of(const StudySkip& skip) const {
    std::vector<Words> out(axes_.size() + 1);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const auto wanted = skip.values.find(i == 0 ? "problem" : axes_[i - 1].name);
      if (wanted != skip.values.end()) out[i] = Words(wanted->second.begin(), wanted->second.end());
    }
    return out;
  }

  /// Why the cell is left out on purpose; empty when it is not.
  std::string skip_reason(const std::vector<std::string>& values) {
    if (skips_.empty())
      for (const StudySkip& skip : study_.config.skip) skips_.push_back(words_of(skip));
    for (std::size_t s = 0; s < skips_.size(); ++s) {
      bool all = true;
      for (std::size_t i = 0; i < values.size(); ++i)
        all = all && (skips_[s][i].empty() || skips_[s][i].count(values[i]) > 0);
      if (all) return study_.config.skip[s].because;
    }
    return "";
  }

  /// Values that no cell can have are typing errors.
  void check_skips() {
    for (std::size_t s = 0; s < study_.config.skip.size(); ++s) {
      std::size_t conditions = 0;
      for (std::size_t i = 0; i <= axes_.size(); ++i) {
        const std::string axis = i == 0 ? "problem" : axes_[i - 1].name;
        const std::vector<std::string>& values = study_.config.skip[s].values.at(axis);
        conditions += values.size();
        std::vector<std::string> known;
        if (i == 0)
          for (const ProblemBase& p : problems_) known.push_back(p.name);
        else
          for (const AxisValue& v : axes_[i - 1].values) known.push_back(v.name);
        // An axis that is not given takes what the problems say; one that --set narrows leaves conditions without a
        // value.
        const std::string key = i == 0 ? "problems" : key_of(axes_[i - 1]);
        if (known.empty() || !place_of(study_.tree, key).origin.empty()) continue;
        const Words words(known.begin(), known.end());
        for (const std::string& value : values)
          if (words.count(value) == 0)
            errors_.error(place_of(study_.tree, fmt::format("skip.{}.{}", s, axis)),
                          fmt::format("no value of the axis {} is called {}{}", axis, in_quotes(value),
                                      did_you_mean(value, known)));
      }
      if (conditions == 0)
        errors_.error(place_of(study_.tree, fmt::format("skip.{}", s)),
                      "would leave out every cell: restrict it, for example {solver: x, because: ..}");
    }
  }

  /// What is wrong in one cell is mostly wrong in many: said once. What stands in the file of a problem is reported
  /// where the study names that file.
  void add_errors(const Diagnostics& errors, const ProblemBase& problem) {
    for (const Diagnostic& e : errors.sorted()) {
      if (!seen_.insert({e.place.origin, e.place.line, e.place.column, e.message}).second) continue;
      const bool in_file = !problem.file.empty() && e.place.origin.rfind(problem.file.string() + ":", 0) == 0;
      if (in_file)
        errors_.error(problem.place, e.place.origin + ": " + e.message);
      else
        errors_.error(e.place, e.message);
    }
  }

  LoadedStudy& study_;
  CellChecks checks_;
  std::vector<ProblemBase> problems_;
  std::vector<Axis> axes_;
  Diagnostics& errors_;
  std::set<std::tuple<std::string, int, int, std::string>> seen_;
  std::vector<std::vector<Words>> skips_;  ///< one per skip of the study, made when it is first needed
};

}  // namespace

StudyGrid make_grid(LoadedStudy& study, CellChecks checks) {
  if (!study.errors.empty()) return {};
  return GridBuilder(study, checks).build();
}

StudyGrid checked_grid(LoadedStudy study) {
  StudyGrid grid = make_grid(study);
  if (!study.errors.empty()) throw ConfigError(study.errors);
  return grid;
}

StudyGrid load_grid(const std::filesystem::path& file, const std::vector<Override>& overrides,
                    const Externals& externals) {
  return checked_grid(load_study(file, overrides, externals));
}

}  // namespace leastcost::app
