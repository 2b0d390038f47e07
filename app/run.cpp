// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/run.hpp"

#include <chrono>

#include "app/output/output_folder.hpp"
#include "app/output/results.hpp"
#include "app/report/report.hpp"

namespace leastcost::app {
namespace {

/// The monitor of the caller with the time budget of the configuration, which starts now.
Monitor with_budget(const Monitor& monitor, double max_seconds) {
  Monitor limited = monitor;
  if (max_seconds > 0)
    limited.deadline = Monitor::Clock::now() +
                       std::chrono::duration_cast<Monitor::Clock::duration>(std::chrono::duration<double>(max_seconds));
  return limited;
}

/// The data as it is when it is used: a file may change while a long run goes on.
std::vector<ManifestInput> inputs_of(const LoadedConfig& loaded) {
  const auto absolute = [](const std::filesystem::path& p) { return std::filesystem::absolute(p).lexically_normal(); };
  std::vector<ManifestInput> inputs = {{"configuration", absolute(loaded.file), sha256_of_text(loaded.text)}};
  for (const std::string& name : files_of(loaded.config))
    inputs.push_back({"data", absolute(loaded.folder / name), sha256_of_file(loaded.folder / name)});
  return inputs;
}

/// The path of the configuration, or the best of its family.
void find(RunOutcome& outcome, const Monitor& monitor) {
  Composition& parts = outcome.parts;
  if (parts.family.empty()) {
    outcome.result = find_path(parts.problem, *parts.initializer, *parts.solver, parts.options, monitor);
    return;
  }
  Family family = find_family(parts.family, *parts.solver, parts.options, monitor);
  parts.notes.insert(parts.notes.end(), family.notes.begin(), family.notes.end());
  outcome.family = std::move(family.members);
  outcome.result = outcome.family.front().result;
  parts.problem = outcome.family.front().problem;  // its target may be another image of the same point
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

Prepared prepare(const RunRequest& request) {
  Prepared prepared{load_config(request.config_file, request.overrides), {}};
  LoadedConfig& loaded = prepared.loaded;
  if (loaded.errors.empty()) check_constructors(loaded);
  if (!loaded.errors.empty()) throw ConfigError(loaded.errors);
  try {
    prepared.parts = compose(loaded.config, loaded.folder, request.building);
  } catch (const OptionError& e) {
    loaded.add_error(e.key(), e.what());
    throw ConfigError(loaded.errors);
  }
  return prepared;
}

std::filesystem::path output_of(const RunRequest& request, const RunConfig& config) {
  if (!request.output.empty()) return request.output;
  if (!config.output_folder.empty()) return config.output_folder;
  return std::filesystem::path("results") / config.name;
}

RunOutcome solve(RunConfig config, Composition parts, const Monitor& monitor) {
  RunOutcome outcome{std::move(config), std::move(parts), {}, {}, {}, ""};
  const Monitor limited = with_budget(monitor, outcome.config.max_seconds);
  try {
    find(outcome, limited);
  } catch (const InitializationError& e) {
    if (limited.interrupted()) throw StoppedEarly(e.what());
    throw;
  }
  return outcome;
}

RunOutcome run(const RunRequest& request, const Monitor& monitor) {
  ManifestFacts facts;
  facts.arguments = request.arguments;
  facts.started = std::chrono::system_clock::now();
  Prepared prepared = prepare(request);
  facts.inputs = inputs_of(prepared.loaded);
  facts.seed = prepared.loaded.config.seed;
  OutputFolder folder(output_of(request, prepared.loaded.config), request.force);

  RunOutcome outcome = solve(std::move(prepared.loaded.config), std::move(prepared.parts), monitor);
  outcome.output = folder.target();
  facts.finished = std::chrono::system_clock::now();
  try {
    write_results(outcome, prepared.loaded.folder, facts, folder);
    // As `leastcost report` would make it: from the files alone.
    for (const ReportFile& file : make_report(folder.staging())) folder.write(file.name, file.content);
    folder.commit();
  } catch (const OutputError& e) {
    outcome.output_error = e.what();
  }
  return outcome;
}

}  // namespace leastcost::app
