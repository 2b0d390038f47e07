// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/study_facts.hpp"

#include <fmt/format.h>

#include <limits>
#include <map>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/options/options_writer.hpp"
#include "catalogue/output/manifest.hpp"
#include "catalogue/output/results.hpp"
#include "catalogue/yaml/yaml_reader.hpp"
#include "catalogue/yaml/yaml_writer.hpp"

namespace leastcost::app {
namespace {

namespace fs = std::filesystem;

std::string hash_or_missing(const fs::path& file) {
  try {
    return sha256_of_file(file);
  } catch (const InputError&) {
    return "missing";
  }
}

/// Hashes every data file once, and calls it by its place as seen from the study.
class DataFiles {
 public:
  explicit DataFiles(const fs::path& study) : root_(fs::absolute(study).lexically_normal().parent_path()) {}

  /// `file`: as the configuration in `folder` names it.
  std::string hash(const fs::path& folder, const fs::path& file) {
    const fs::path absolute = fs::absolute(folder / file).lexically_normal();
    const std::string name =
        file.is_absolute() ? absolute.string() : absolute.lexically_relative(root_).generic_string();
    const auto [entry, is_new] = hashes_.try_emplace(name);
    if (is_new) entry->second = hash_or_missing(absolute);
    return entry->second;
  }
  std::vector<std::pair<std::string, std::string>> all() const { return {hashes_.begin(), hashes_.end()}; }

 private:
  fs::path root_;
  std::map<std::string, std::string> hashes_;
};

ConfigNode inline_config(const RunConfig& config, const RenameFile& rename) {
  const std::string text = resolved_yaml(config, rename);
  Diagnostics errors("", text);
  return read_yaml(text, errors);
}

}  // namespace

StudyFacts facts_of(const StudyGrid& grid) {
  StudyFacts facts;
  facts.name = grid.name;
  facts.version = program_version();
  facts.seed = grid.config.seed;
  facts.cells = static_cast<long>(grid.cells.size());
  facts.repetitions = grid.config.repetitions;
  facts.swept_keys = grid.swept_keys;
  DataFiles data(grid.file);
  std::string all = fmt::format("{} cells, {} repetitions, {} MB\n", facts.cells, facts.repetitions,
                                grid.config.max_memory.value_or(0));
  for (const StudyCell& cell : grid.cells) {
    if (!cell.skipped.empty()) {
      facts.skipped.push_back({cell.number, cell.values, cell.skipped});
      continue;
    }
    const auto content = [&](const std::string& file) { return data.hash(cell.folder, file); };
    all += fmt::format("cell {}: {}\noptimum {:.17g}\n{}", cell.number, fmt::join(cell.values, ", "),
                       cell.optimum.value_or(std::numeric_limits<double>::quiet_NaN()),
                       resolved_yaml(cell.config, content));
  }
  facts.data = data.all();
  facts.configuration = sha256_of_text(all);
  return facts;
}

std::string resolved_study(const StudyGrid& grid, const fs::path& output) {
  StudyConfig config = grid.config;
  config.set = {};
  std::size_t per_problem = grid.cells.size() / config.problems.size();
  for (std::size_t i = 0; i < config.problems.size(); ++i) {
    const StudyCell& cell = grid.cells[i * per_problem];  // what its axes say is said again by the axes
    StudyProblem& problem = config.problems[i];
    problem.name = cell.values[0];
    problem.config = inline_config(cell.config, from_output(cell.folder, output));
    problem.set = {};
  }
  OptionsWriter writer;
  config.fields(writer);
  return "# Every option of this study, including defaults. To repeat the study: `leastcost study` on this file.\n" +
         to_yaml(writer.take());
}

}  // namespace leastcost::app
