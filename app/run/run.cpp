// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/run/run.hpp"

#include <chrono>
#include <utility>

#include <leastcost/catalogue/output/output_folder.hpp>
#include <leastcost/catalogue/output/results.hpp>
#include "app/report/report.hpp"

namespace leastcost::app {
namespace {

/// The data as it is when it is used: a file may change while a long run goes on.
std::vector<ManifestInput> inputs_of(const LoadedConfig& loaded) {
  const auto absolute = [](const std::filesystem::path& p) { return std::filesystem::absolute(p).lexically_normal(); };
  std::vector<ManifestInput> inputs = {{"configuration", absolute(loaded.file), sha256_of_text(loaded.text)}};
  for (const std::string& name : files_of(loaded.config))
    inputs.push_back({"data", absolute(loaded.folder / name), sha256_of_file(loaded.folder / name)});
  return inputs;
}

}  // namespace

Exit exit_of(Status status) {
  switch (status) {
    case Status::certified: return Exit::certified;
    case Status::uncertified:
    case Status::collapsed: return Exit::uncertified;
    case Status::interrupted: return Exit::interrupted;
  }
  return Exit::internal;
}

std::filesystem::path output_of(const RunRequest& request, const RunConfig& config) {
  if (!request.output.empty()) return request.output;
  if (config.output_folder) return *config.output_folder;
  return std::filesystem::path("results") / config.name;
}

WrittenRun run(const RunRequest& request, const Monitor& monitor) {
  ManifestFacts facts;
  facts.arguments = request.arguments;
  facts.started = std::chrono::system_clock::now();
  Run loaded = load_run(request.config_file, request.overrides, request.building);
  facts.inputs = inputs_of(loaded.loaded);
  facts.seed = loaded.loaded.config.seed;
  OutputFolder folder(output_of(request, loaded.loaded.config), request.force);

  WrittenRun outcome{solve(std::move(loaded.loaded.config), std::move(loaded.parts), monitor), folder.target(), ""};
  facts.finished = std::chrono::system_clock::now();
  try {
    write_results(outcome, loaded.loaded.folder, facts, folder);
    // As `leastcost report` would make it: from the files alone.
    for (const ReportFile& file : make_report(folder.staging())) folder.write(file.name, file.content);
    folder.commit();
  } catch (const OutputError& e) {
    outcome.output_error = e.what();
  }
  return outcome;
}

}  // namespace leastcost::app
