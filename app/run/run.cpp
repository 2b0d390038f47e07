// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/run/run.hpp"

#include <chrono>
#include <iostream>
#include <iterator>
#include <utility>

#include "app/report/report.hpp"
#include "catalogue/output/results.hpp"
#include "catalogue/run/run_origin.hpp"

namespace leastcost::app {
namespace {

bool is_standard_input(const std::filesystem::path& file) { return file == "-" || file == "/dev/stdin"; }

}  // namespace

ConfigText config_source(const std::filesystem::path& file) {
  if (!is_standard_input(file)) return {config_text(file), file.string(), file.parent_path(), file};
  const std::string text(std::istreambuf_iterator<char>(std::cin), {});
  if (std::cin.bad()) throw InputError("standard input: cannot be read");
  return {text, "stdin", {}, {}};
}

Run load(const RunRequest& request) {
  if (!is_standard_input(request.config_file))
    return load_run(request.config_file, request.overrides, request.building);
  const ConfigText source = config_source(request.config_file);
  return parse_run(source.text, source.name, source.folder, request.overrides, request.building);
}

Exit exit_of(Status status) {
  switch (status) {
    case Status::certified: return Exit::certified;
    case Status::uncertified:
    case Status::collapsed: return Exit::uncertified;
    case Status::interrupted: return Exit::interrupted;
  }
  return Exit::internal;
}

std::filesystem::path output_of(const RunRequest& request, const Run& run) {
  if (!request.output.empty()) return request.output;
  if (run.origin->config.output_folder) return *run.origin->config.output_folder;
  return std::filesystem::path("results") / run.name;
}

WrittenRun run(const RunRequest& request, const Monitor& monitor) {
  Run loaded = load(request);
  OutputFolder folder(output_of(request, loaded), request.force);
  WrittenRun outcome{solve(std::move(loaded), monitor), folder.target(), ""};
  try {
    write_results(outcome, request.arguments, folder);
    // As `leastcost report` would make it: from the files alone.
    const auto start = std::chrono::steady_clock::now();
    for (const ReportFile& file : make_report(folder.staging())) folder.write(file.name, file.content);
    outcome.seconds.report = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    folder.write("result.json", result_json(outcome));  // once more, with the time of the report
    folder.commit();
  } catch (const OutputError& e) {
    outcome.output_error = e.what();
  }
  return outcome;
}

}  // namespace leastcost::app
