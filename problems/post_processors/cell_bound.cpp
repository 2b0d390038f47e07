// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/cell_bound.hpp>

#include <algorithm>
#include <chrono>
#include <string>
#include <variant>

#include "framework/base/point_text.hpp"
#include "problems/cells/cell_bound.hpp"
#include "problems/cells/has_cost_cells.hpp"
#include "problems/cells/side_nodes.hpp"
#include "problems/post_processors/search_time.hpp"

namespace leastcost {
namespace {

constexpr double kMostPlaces = 4e6;  ///< of a budget that does not say
constexpr double kWorthSaying = 0.01;
constexpr double kEnough = 0.005;  ///< gap at which the search ends where no budget says another

}  // namespace

PostProcessed CellBoundPostProcessor::apply(const Problem& problem, const FirstPath&, PostProcessed current,
                                            const Monitor& monitor) const {
  if (std::holds_alternative<GlobalOff>(proof_) || monitor.interrupted() || !current.curve.least_of_class)
    return current;
  const auto begin = Monitor::Clock::now();
  const CellMap map = cells_of(problem, "cell_bound");
  CellBoundOptions options;
  GlobalBudget budget;
  options.tolerance = kEnough;
  if (const auto* asked = std::get_if<GlobalBudget>(&proof_)) {
    budget = *asked;
    options.most_places = budget.max_windows ? *budget.max_windows : kMostPlaces;
    options.tolerance = budget.tolerance;
  }
  options.upper = current.curve.cost;
  options.stop = stop_of_search(budget, monitor);
  const CellBound found = bound_in_cells(map, current.chain.u.leftCols(1), current.chain.u.rightCols(1), options);
  if (!(found.lower > 0)) {
    if (found.stopped) return current;
    const auto places = static_cast<long>(SideNodes::count_for(map, 3)) + 1;
    current.notes.push_back(
        "cell_bound: no bound over paths through other cells was computed, because the raster is large; for a bound, "
        "set 'certificate: {global: {tolerance: 0.01, max_windows: " +
        std::to_string(places) + "}}'");
    return current;
  }
  GlobalBound& global = current.curve.global.emplace();
  global.lower_bound = found.lower;
  global.gap = 1 - found.lower / current.curve.cost;
  global.proved = global.gap <= budget.tolerance;
  global.outcome = global.proved ? ProofOutcome::proved : ProofOutcome::bounded;
  global.scope = Scope::global;
  global.counts = "places";
  global.steps = found.places;
  global.bound = "potential";
  global.seconds = std::chrono::duration<double>(Monitor::Clock::now() - begin).count();
  if (global.gap > kWorthSaying)
    current.notes.push_back("cell_bound: no path over the cells costs less than " + short_number(found.lower, 6) +
                            "; this one costs at most " + short_number(100 * global.gap / (1 - global.gap), 2) +
                            " % more than the least");
  return current;
}

}  // namespace leastcost
