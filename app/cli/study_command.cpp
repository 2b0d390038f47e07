// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <utility>

#include <leastcost/app/report/report.hpp>
#include "app/cli/commands.hpp"
#include "app/cli/interrupt.hpp"
#include "app/cli/study_progress.hpp"
#include "app/study/study_summary.hpp"
#include "catalogue/output/json_numbers.hpp"
#include "catalogue/output/output_folder.hpp"

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

}  // namespace leastcost::app
