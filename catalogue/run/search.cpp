// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/search.hpp"

#include <chrono>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/family/find_family.hpp>
#include "catalogue/run/family_ways.hpp"

namespace leastcost {
namespace {

/// The monitor of the caller with the time budget of the configuration, which starts now.
Monitor with_budget(const Monitor& monitor, std::optional<double> max_seconds) {
  Monitor limited = monitor;
  if (max_seconds)
    limited.deadline = Monitor::Clock::now() + std::chrono::duration_cast<Monitor::Clock::duration>(
                                                   std::chrono::duration<double>(*max_seconds));
  return limited;
}

/// The path of the configuration, or the best of its family.
void find(RunOutcome& outcome, const Monitor& monitor) {
  RunParts& parts = outcome.parts;
  if (!parts.wants_family()) {
    outcome.result = find_path(parts.problem, *parts.initializer, *parts.solver, parts.options, monitor);
    return;
  }
  Family family = find_family(family_starts(parts), *parts.solver, parts.options, monitor);
  parts.notes.insert(parts.notes.end(), family.notes.begin(), family.notes.end());
  outcome.family = std::move(family.members);
  outcome.result = outcome.family.front().result;
  parts.problem = outcome.family.front().problem;  // its target may be another image of the same point, or another goal
  for (const PlacedEnd& goal : parts.goals)
    if (goal.end.u == parts.problem.target.u) parts.target = goal;
}

}  // namespace

void search(RunOutcome& outcome, std::optional<double> max_seconds, const Monitor& monitor) {
  find(outcome, with_budget(monitor, max_seconds));
  const RunParts& parts = outcome.parts;
  const Result& result = outcome.result;
  if (result.path.u.size() == 0) throw StoppedEarly(result.notes.empty() ? "no path yet" : result.notes.back());
  complete_interrupted(parts.problem, parts.options, outcome.result);
  for (FamilyMember& member : outcome.family) complete_interrupted(member.problem, parts.options, member.result);
}

}  // namespace leastcost
