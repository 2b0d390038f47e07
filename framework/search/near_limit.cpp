// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/near_limit.hpp"

#include <optional>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/limits_moves.hpp>
#include "framework/base/point_text.hpp"
#include "framework/energy/spacing.hpp"
#include "framework/search/begin.hpp"
#include "framework/search/run_search.hpp"

namespace leastcost {
namespace {

constexpr double kDear = 0.01;       ///< relative: what points may cost above the limit of more of them
constexpr Index kMostOfAuto = 1600;  ///< points

/// Of the cost of the delivered points, above the limit of more of them.
double excess(const Result& result) { return result.curve.cost / result.certificate.estimate.value - 1; }

bool is_dear(const Result& result) { return result.status == Status::certified && excess(result) > kDear; }

std::string percent(double part) { return short_number(100 * part) + " %"; }

/// Nothing where there is no such chain, or it is no better.
std::optional<Result> with_twice_the_points(const Problem& problem, const Result& found, const Search& search) {
  FindOptions finer = search.options;
  finer.reference_cost = found.reference_cost / 2;
  finer.cascade = false;
  finer.certificate.refine = 0;
  try {
    const CoordinatePath chain = refine(problem, found.path, search.monitor.deadline);
    Problem copy = problem;
    Result next = run_search(copy, from_chain(chain), {search.solver, finer, search.monitor});
    if (next.status == Status::certified && next.curve.cost < found.curve.cost) return next;
  } catch (const InputError&) {  // a finer chain could not be made
  } catch (const InitializationError&) {
  } catch (const Interrupted&) {
  }
  return std::nullopt;
}

}  // namespace

Result near_limit(const Problem& problem, Result found, const Search& search) {
  if (search.options.points || problem.ring || !search.solver.moves_points() ||
      find_ability<LimitsMoves>(*problem.manifold) == nullptr || !is_dear(found))
    return found;
  const Index before = found.path.free_count();
  const double excess_before = excess(found);
  while (is_dear(found) && 2 * found.path.free_count() + 1 <= kMostOfAuto && !search.monitor.interrupted()) {
    std::optional<Result> next = with_twice_the_points(problem, found, search);
    if (!next) break;
    found = joined(found, std::move(*next));
  }
  if (found.path.free_count() > before)
    found.notes.push_back("points: auto: used " + std::to_string(found.path.free_count()) + " points instead of " +
                          std::to_string(before) + ", which cost " + percent(excess_before) +
                          " more than the limit of more points");
  if (is_dear(found))
    found.notes.push_back("the delivered points cost " + percent(excess(found)) +
                          " more than the limit of more points; for a cheaper path give more points");
  return found;
}

}  // namespace leastcost
