// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/catalogue/run/run.hpp>

#include <chrono>
#include <utility>

namespace leastcost {
namespace {

/// The monitor of the caller with the time budget of the configuration, which starts now.
Monitor with_budget(const Monitor& monitor, double max_seconds) {
  Monitor limited = monitor;
  if (max_seconds > 0)
    limited.deadline = Monitor::Clock::now() +
                       std::chrono::duration_cast<Monitor::Clock::duration>(std::chrono::duration<double>(max_seconds));
  return limited;
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

Run load_run(const std::filesystem::path& file, const std::vector<Override>& overrides, const BuildProgress& progress) {
  Run run{load_config(file, overrides), {}};
  LoadedConfig& loaded = run.loaded;
  if (loaded.errors.empty()) check_constructors(loaded);
  if (!loaded.errors.empty()) throw ConfigError(loaded.errors);
  try {
    run.parts = compose(loaded.config, loaded.folder, progress);
  } catch (const OptionError& e) {
    loaded.add_error(e.key(), e.what());
    throw ConfigError(loaded.errors);
  }
  return run;
}

RunOutcome solve(RunConfig config, Composition parts, const Monitor& monitor) {
  RunOutcome outcome{std::move(config), std::move(parts), {}, {}};
  const bool limited = outcome.config.max_seconds > 0 || monitor.deadline;
  if (limited && outcome.parts.options.certificate.enabled) prepare(outcome.parts.problem);
  find(outcome, with_budget(monitor, outcome.config.max_seconds));
  const Result& result = outcome.result;
  if (result.path.u.size() == 0) throw StoppedEarly(result.notes.empty() ? "no path yet" : result.notes.back());
  complete_interrupted(outcome.parts.problem, outcome.parts.options, outcome.result);
  for (FamilyMember& member : outcome.family)
    complete_interrupted(member.problem, outcome.parts.options, member.result);
  return outcome;
}

}  // namespace leastcost
