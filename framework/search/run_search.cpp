// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/run_search.hpp"

#include <array>
#include <optional>
#include <span>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_notes.hpp>
#include "framework/result/find_path_checks.hpp"
#include "framework/search/certify_outcome.hpp"
#include "framework/search/make_curve.hpp"
#include "framework/search/placement.hpp"
#include "framework/search/reference_cost.hpp"
#include "framework/search/retry.hpp"
#include "framework/search/solve_chain.hpp"
#include "framework/search/unfinished.hpp"

namespace leastcost {
namespace {

void refuse_wrong_ends(const Search&, Outcome& out) {
  refuse_one_point(out.problem);
  refuse_end_in_clearance(out.problem);
}

/// What is made of the problem before there is a path.
constexpr std::array<Step, 2> kPreparations = {locate_ends, refuse_wrong_ends};

/// The stages of a search and why each may be tried again.
struct Phase {
  Step run;
  const Retry& again = kNoRetry;
};
const std::array<Phase, 5> kPhases = {{{solve_chain, kDenserBetweenObstacles},
                                       {note_denser_points},
                                       {leave_saddles},
                                       {make_curve, kFromCheaperWay},
                                       {certify_outcome}}};

void run(std::span<const Phase> phases, const Search& search, Outcome& out);

/// Runs one phase again as long as there is reason to; `before` are the phases that lead to it. What a stop request
/// meets in the midst of an attempt is what there was before it.
void try_again(std::span<const Phase> before, const Phase& phase, const Search& search, Outcome& out) {
  for (int tries = 0; phase.again.has_reason(search, out, tries); ++tries) {
    std::optional<Outcome> attempt;
    bool kept = false;
    try {
      attempt = phase.again.attempt(search, out);
      if (attempt) run(before, search, *attempt);
      kept = attempt && phase.again.keeps(search, out, *attempt);
    } catch (const Interrupted&) {
      if (!search.monitor.cancelled()) throw;
      return;
    }
    if (kept)
      out = std::move(*attempt);
    else if (attempt)
      out.result.seconds = attempt->result.seconds;
    if (!kept && !phase.again.repeats) return;
    phase.run(search, out);
  }
}

/// Ends early where a part of the problem threw: it is not asked again.
void run(std::span<const Phase> phases, const Search& search, Outcome& out) {
  for (std::size_t k = 0; k < phases.size(); ++k) {
    phases[k].run(search, out);
    try_again(phases.first(k), phases[k], search, out);
    if (out.failed()) return;
  }
}

void initialize(const Search& search, const Begin& begin, Outcome& out) {
  timed(Stage::initialize, search, out.result.seconds.initialize, [&] {
    for (const Step step : kPreparations) step(search, out);
    begin(search, out);
  });
  out.solved = out.problem;
  out.result.path = out.result.initial;
  out.points = out.result.path.free_count();
  set_reference_cost(search, out);
}

/// A stop request in the midst of a pass leaves time to deliver the path as it is by then. False: there is none, or the
/// time is over too.
bool deliver_stopped(const Search& search, Outcome& out) {
  const Result& result = out.result;
  if (!search.monitor.cancelled() || result.post_processed || result.path.u.size() == 0) return false;
  if (!(result.reference_cost > 0)) return false;
  try {
    make_curve(search, out);
    certify_outcome(search, out);
  } catch (const Interrupted&) {
    return false;
  }
  return true;
}

}  // namespace

Result run_search(Problem& problem, const Begin& begin, const Search& search) {
  check(problem);
  check(search.options);
  Outcome out{problem, problem, problem, {}};
  if (const auto* told = find_ability<HasNotes>(*problem.cost)) out.result.notes = told->notes();
  try {
    initialize(search, begin, out);
    run(kPhases, search, out);
    if (out.failed()) leave_unmeasured(out);
  } catch (const Interrupted& stopped) {
    if (!deliver_stopped(search, out)) leave_unfinished(search, stopped.what(), out);
  }
  problem = std::move(out.asked);
  Result& result = out.result;
  result.notes.insert(result.notes.begin(), result.first.notes.begin(), result.first.notes.end());
  return std::move(result);
}

}  // namespace leastcost
