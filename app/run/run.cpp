// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/run/run.hpp"

#include <chrono>
#include <exception>
#include <iostream>
#include <new>
#include <utility>

#include <leastcost/app/report/report.hpp>
#include "catalogue/config/load_config.hpp"
#include "catalogue/output/results.hpp"
#include "catalogue/run/run_origin.hpp"

namespace leastcost::app {
namespace {

bool is_standard_input(const std::filesystem::path& file) { return file == "-" || file == "/dev/stdin"; }

/// As `leastcost report` would make it: from the files alone. Why there is none; empty when there is one.
std::string add_report(WrittenRun& outcome, OutputFolder& folder) {
  const auto start = std::chrono::steady_clock::now();
  try {
    for (const ReportFile& file : make_report(folder.staging())) folder.write(file.name, file.content);
    outcome.seconds.report = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    folder.write("result.json", result_json(outcome));  // once more, with the time of the report
  } catch (const std::bad_alloc&) {
    return "there is not enough memory for the report";
  } catch (const std::exception& e) {
    return std::string("the report cannot be made: ") + e.what();
  }
  return "";
}

/// Who asks for an end does not want to wait for a picture of a million points.
bool leaves_out_report(const WrittenRun& outcome, const Monitor& monitor) {
  constexpr Index kMany = 100'000;
  return outcome.result.path.u.cols() > kMany && monitor.cancelled();
}

/// The files of a path that is found: whatever goes wrong, they stay where the outcome says.
void write_files(WrittenRun& outcome, const RunRequest& request, const Monitor& monitor, OutputFolder& folder) {
  try {
    write_results(outcome, request.arguments, folder);
    std::string missing;
    if (leaves_out_report(outcome, monitor))
      outcome.result.notes.emplace_back("interrupted: the report was left out; to make it, run leastcost report");
    else if (outcome.origin->config.writes("report"))
      missing = add_report(outcome, folder);
    folder.commit();
    outcome.in_place = true;
    outcome.output_error = missing;
  } catch (const OutputRefused& e) {
    outcome.output_error = e.what();
  } catch (const OutputError& e) {
    outcome.output_error = e.what() + folder.leave();
  } catch (const std::bad_alloc&) {
    outcome.output_error = "there is not enough memory to write them" + folder.leave();
  } catch (const std::exception& e) {
    outcome.output_error = e.what() + folder.leave();
  }
}

}  // namespace

ConfigText config_source(const std::filesystem::path& file) {
  if (!is_standard_input(file)) return {config_text(file), file.string(), file.parent_path(), file};
  std::string text = config_text(std::cin);
  if (std::cin.bad()) throw InputError("standard input: cannot be read");
  return {std::move(text), "stdin", {}, {}};
}

Run load(const RunRequest& request) {
  if (!is_standard_input(request.config_file))
    return load_run(request.config_file, request.overrides, request.building, {}, request.ends);
  const ConfigText source = config_source(request.config_file);
  return parse_run(source.text, source.name, source.folder, request.overrides, request.building, {}, request.ends);
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

std::string with_advice(const std::string& refusal, bool replaceable) {
  if (refusal.find("use -o") != std::string::npos) return refusal;  // it says so already
  return refusal +
         (replaceable ? "; use --force to replace it, or -o for another folder" : "; use -o for another folder");
}

WrittenRun run(Run loaded, const RunRequest& request, const Monitor& monitor) {
  OutputFolder folder(output_of(request, loaded), request.force);
  WrittenRun outcome{solve(std::move(loaded), monitor), folder.target(), false, ""};
  write_files(outcome, request, monitor, folder);
  return outcome;
}

WrittenRun run(const RunRequest& request, const Monitor& monitor) { return run(load(request), request, monitor); }

}  // namespace leastcost::app
