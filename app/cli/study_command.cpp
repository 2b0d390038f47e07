// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <utility>

#include <leastcost/app/report/report.hpp>
#include "app/cli/command_options.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/interrupt.hpp"
#include "app/cli/study_progress.hpp"
#include "app/study/study_summary.hpp"
#include "catalogue/output/json_numbers.hpp"
#include "catalogue/output/output_folder.hpp"
#include "catalogue/yaml/scalars.hpp"

namespace leastcost::app {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> axes_of(const StudyGrid& grid) {
  std::vector<std::string> axes = standing_axes();
  axes.insert(axes.end(), grid.swept_keys.begin(), grid.swept_keys.end());
  return axes;
}

std::string grid_text(const StudyRequest& request, const StudyGrid& grid) {
  std::string out = fmt::format("cell  {}\n", fmt::join(axes_of(grid), ", "));
  std::size_t run = 0;
  for (const StudyCell& cell : grid.cells) {
    if (!request.shard.has(cell.number)) continue;
    out += fmt::format("{:>4}  {}", cell.number, fmt::join(cell.values, ", "));
    out += cell.skipped.empty() ? "\n" : fmt::format("  (skipped: {})\n", cell.skipped);
    run += cell.skipped.empty() ? 1 : 0;
  }
  return out + fmt::format("{} cell{} of {} would be run, each {} time{}, into {}\n", run, run == 1 ? "" : "s",
                           grid.cells.size(), grid.config.repetitions, grid.config.repetitions == 1 ? "" : "s",
                           output_of(request, grid).string());
}

std::string grid_json(const StudyRequest& request, const StudyGrid& grid) {
  const std::vector<std::string> axes = axes_of(grid);
  Json cells = Json::array();
  for (const StudyCell& cell : grid.cells) {
    if (!request.shard.has(cell.number)) continue;
    Json item = {{"cell", cell.number}};
    for (std::size_t k = 0; k < axes.size(); ++k) item[axes[k]] = cell.values[k];
    item["skipped"] = cell.skipped.empty() ? Json(nullptr) : Json(cell.skipped);
    cells.push_back(std::move(item));
  }
  return to_text({{"schema_version", kSchemaVersion},
                  {"status", "dry_run"},
                  {"name", grid.name},
                  {"cells_in_grid", grid.cells.size()},
                  {"repetitions", grid.config.repetitions},
                  {"output", output_of(request, grid).string()},
                  {"cells", cells}});
}

std::string interrupted_json(const std::string& message) {
  return to_text({{"schema_version", kSchemaVersion}, {"status", "interrupted"}, {"message", message}});
}

Exit finish(const StudyOutcome& outcome, bool json, const Streams& streams) {
  if (!outcome.journal.results.empty()) write_report(outcome.output);
  const StudySummary summary = summarize(outcome.journal);
  if (json) {
    Json out = Json::parse(summary_json(outcome.journal));
    out["output"] = outcome.output.string();
    streams.out << to_text(out);
  } else {
    streams.out << summary_text(summary) << "output: " << outcome.output.string() << '\n';
  }
  return summary.complete_and_ok() ? Exit::certified : Exit::study_failed;
}

/// "2/8"; empty: everything. What it is not is an error of usage.
Shard parse_shard(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = text.find('/');
  const std::optional<std::size_t> index = list_index(text.substr(0, slash));
  const std::optional<std::size_t> count =
      slash == std::string::npos ? std::nullopt : list_index(text.substr(slash + 1));
  if (!index || !count || *count == 0 || *index >= *count)
    throw CLI::ValidationError("--shard", "must be i/N with i from 0 to N - 1, like 0/8 (found '" + text + "')");
  return {static_cast<int>(*index), static_cast<int>(*count)};
}

constexpr const char* kStudyHelp =
    "On one machine:         leastcost study CONFIG -j 4 -o DIR     (if killed: add --resume)\n"
    "Shards, GNU parallel:   seq 0 7 | parallel leastcost study CONFIG --shard {}/8 -o DIR/{} --resume\n"
    "Shards, Slurm:          sbatch --array=0-7 --wrap 'leastcost study CONFIG --shard $SLURM_ARRAY_TASK_ID/8 "
    "-o DIR/$SLURM_ARRAY_TASK_ID --resume'\n"
    "Then:                   leastcost merge DIR/* -o MERGED\n"
    "Times are comparable only if cells do not compete: use -j 1, or fewer jobs than cores.";

}  // namespace

Exit study_command(const StudyArguments& arguments, const Streams& streams) {
  if (arguments.dry_run) {
    const StudyGrid grid = load_grid(arguments.request.config_file, arguments.request.overrides);
    streams.out << (arguments.json ? grid_json(arguments.request, grid) : grid_text(arguments.request, grid));
    return Exit::certified;
  }
  catch_interrupts();
  StudyProgressPrinter progress(streams, arguments.quiet);
  StudyRequest request = arguments.request;
  request.observe = [&](const StudyProgress& p) { progress.show(p); };
  request.stop_requested = interrupted;
  const std::string early = "interrupted before the study started";
  std::optional<EndsAtOnce> reading(std::in_place, arguments.json ? interrupted_json(early) : "",
                                    early + "; nothing was written\n");
  request.loaded = [&] { reading.reset(); };
  const StudyOutcome outcome = run_study(request);
  progress.clear();
  if (!outcome.interrupted) return finish(outcome, arguments.json, streams);
  if (!outcome.journal.results.empty()) write_report(outcome.output);
  const std::string message = fmt::format("{} results are in {}; to continue, add --resume to the same command",
                                          outcome.journal.results.size(), outcome.output.string());
  streams.err << "interrupted: " << message << '\n';
  if (arguments.json) streams.out << interrupted_json(message);
  return Exit::interrupted;
}

Exit merge_command(const MergeArguments& arguments, const Streams& streams) {
  catch_interrupts();
  const std::string early = "interrupted before the shards were read";
  std::optional<EndsAtOnce> reading(std::in_place, arguments.json ? interrupted_json(early) : "",
                                    early + "; nothing was written\n");
  MergeRequest request = arguments.request;
  request.loaded = [&] { reading.reset(); };
  return finish(merge_studies(request), arguments.json, streams);
}

void add_study(const CommandLine& line) {
  OptionValues& v = line.values;
  CLI::App& c = *line.app.add_subcommand("study", "Run a grid of problems, solvers and options, and compare");
  c.footer(kStudyHelp);
  c.add_option("config", v.config, "Study (YAML with `problems`)")->required()->type_name("CONFIG");
  add_set(c, v);
  add_format(c, v);
  add_output(c, v, "Output folder; default: results/<name>", "DIR");
  c.add_option("-j,--jobs", v.parallel, "Number of cells to run in parallel")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  c.add_option("--shard", v.shard, "Run only shard i of N, with i from 0 to N - 1")->type_name("i/N");
  c.add_option("--timeout", v.timeout, "Same as --set max_seconds=S")->type_name("S");
  c.add_option("--repetitions", v.repetitions, "Same as --set repetitions=R")->type_name("R");
  auto* resume = c.add_flag("--resume", v.resume, "Resume an interrupted or killed study");
  c.add_flag("--force", v.force, "Replace the output folder of an earlier study")->excludes(resume);
  c.add_flag("-n,--dry-run", v.dry_run,
             "Check the keys and types of every cell and print the grid; validate also composes each cell");
  c.add_flag("-q,--quiet", v.quiet, "Print no progress");
  c.callback([&] {
    line.chosen = [&, shard = parse_shard(v.shard)] {
      StudyArguments study;
      study.request.config_file = v.config;
      study.request.overrides = v.overrides();
      study.request.output = v.output;
      study.request.force = v.force;
      study.request.resume = v.resume;
      study.request.parallel = v.parallel;
      study.request.shard = shard;
      study.request.arguments = line.arguments;
      study.dry_run = v.dry_run;
      study.json = v.json();
      study.quiet = v.quiet;
      return study_command(study, line.streams);
    };
  });
}

void add_merge(const CommandLine& line) {
  OptionValues& v = line.values;
  CLI::App& c = *line.app.add_subcommand("merge", "Merge the shards of a study");
  c.add_option("folders", v.configs, "Output folders of the shards")->required()->type_name("DIR...");
  c.add_option("-o,--output", v.output, "Output folder")->required()->type_name("DIR")->check(empty_fault);
  c.add_flag("--force", v.force, "Replace the output folder of an earlier study");
  add_format(c, v);
  c.callback([&] {
    line.chosen = [&] {
      const MergeRequest request{{v.configs.begin(), v.configs.end()}, v.output, v.force, line.arguments};
      return merge_command({request, v.json()}, line.streams);
    };
  });
}

}  // namespace leastcost::app
