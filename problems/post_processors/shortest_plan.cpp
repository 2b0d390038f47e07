// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/shortest_plan.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include "framework/base/point_text.hpp"
#include "problems/post_processors/plan_curve.hpp"
#include "problems/post_processors/search_time.hpp"
#include "problems/taut/tangent_path.hpp"
#include "problems/taut/tangent_search.hpp"
#include "problems/taut/taut_path.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr double kPolylineExcess = 1e-6;  ///< relative: of what is delivered over the path along the circles

TangentSearchOptions search_options(const Problem& problem, const GlobalBudget& budget, const Monitor& monitor) {
  TangentSearchOptions options;
  options.tolerance = budget.tolerance;
  if (budget.max_windows) options.max_tangents = *budget.max_windows;
  options.stop = stop_of_search(budget, monitor);
  if (const auto* box = find_ability<HasBox>(*problem.manifold))
    options.box = Eigen::AlignedBox2d(Vector2d(box->box_lower()), Vector2d(box->box_upper()));
  return options;
}

/// The path around these discs, if it is clear.
std::optional<TightPath> around(const Walls& walls, const Vector2d& source, const Vector2d& target,
                                const std::vector<Bend>& bends, const Deadline& deadline) {
  const auto path = TangentPath::make(walls, source, target, bends, deadline);
  if (!path) return std::nullopt;
  auto taut = taut_path(walls, path->polyline(kPolylineExcess), kPolylineExcess, deadline);
  if (!taut) return std::nullopt;
  return TightPath{std::move(taut->polyline), taut->length, taut->least};
}

}  // namespace

PostProcessed ShortestPlanPostProcessor::apply(const Problem& problem, const FirstPath&, PostProcessed current,
                                               const Monitor& monitor) const {
  const Walls& walls = walls_of(problem, "shortest_plan");
  if (walls.dimension() != 2) throw InputError("shortest_plan needs the plane");
  const double unit = cost_of_length(problem, "shortest_plan");
  if (std::holds_alternative<GlobalOff>(proof_) || !current.curve.least_of_class || monitor.interrupted())
    return current;
  const auto begin = Monitor::Clock::now();
  const GlobalBudget budget =
      std::holds_alternative<GlobalBudget>(proof_) ? std::get<GlobalBudget>(proof_) : GlobalBudget{};
  const Vector2d source = current.curve.x.leftCols(1), target = current.curve.x.rightCols(1);
  const double before = *current.curve.least_of_class / unit;
  const TangentSearchResult found =
      shorter_tangent_path(walls, source, target, before, search_options(problem, budget, monitor));

  GlobalBound global;
  global.proved = found.finished && !found.shorter;
  global.outcome = global.proved ? ProofOutcome::proved : ProofOutcome::bounded;
  if (found.shorter) {
    const auto path = around(walls, source, target, found.bends, monitor.deadline);
    if (path && path->least < before && deliver_plan(problem, walls, unit, *path, monitor, current)) {
      global.proved = path->least - found.lower_bound <= budget.tolerance * path->least + 2 * found.rounding;
      current.notes.push_back(
          "shortest_plan: a shorter path than the taut one was found and is delivered; the taut one was longer by " +
          short_number(100 * (before / path->least - 1)) + " %");
    }
    global.outcome = global.proved ? ProofOutcome::improved : ProofOutcome::blocked;
    if (!global.proved) global.reason = "rounding hides whether a shorter candidate touches an obstacle";
  }
  global.scope = Scope::global;
  global.counts = "tangents";
  global.steps = found.tangents;
  global.bound = "euclid";
  global.lower_bound = unit * found.lower_bound;
  global.gap = 1 - global.lower_bound / current.curve.cost;
  global.seconds = std::chrono::duration<double>(Monitor::Clock::now() - begin).count();
  current.curve.global = std::move(global);
  return current;
}

}  // namespace leastcost
