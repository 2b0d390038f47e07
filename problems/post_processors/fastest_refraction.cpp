// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/fastest_refraction.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>

#include <leastcost/framework/domain/has_box.hpp>
#include "problems/layers/fastest_ray.hpp"
#include "problems/layers/ray_bound.hpp"
#include "problems/post_processors/refracted_curve.hpp"
#include "problems/post_processors/search_time.hpp"

namespace leastcost {
namespace {

constexpr double kSameCost = 1e-12;    ///< relative: a path so little cheaper is the same one
constexpr double kRoundedBox = 1e-14;  ///< relative: so near to an interface a box is taken to meet it

/// The lowest and the highest layer in a box: beyond an interface that does not meet it there is no way.
std::pair<int, int> layers_in(const LayerStack& stack, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  int lowest = 0, highest = stack.layers() - 1;
  for (int k = 0; k < stack.interfaces(); ++k) {
    const Eigen::ArrayXd normal = stack.normal(k).array();
    const Eigen::VectorXd bottom = (normal > 0).select(lower, upper), top = (normal > 0).select(upper, lower);
    const auto terms = [&](const Eigen::VectorXd& corner) {  // an infinite side that the normal does not see
      return (normal == 0).select(0, normal * corner.array()).eval();
    };
    const double size = std::abs(stack.offset(k)) + terms(bottom).abs().sum() + terms(top).abs().sum();
    const double margin = std::isfinite(size) ? kRoundedBox * size : 0;
    if (terms(bottom).sum() - stack.offset(k) > margin) lowest = k + 1;
    if (terms(top).sum() - stack.offset(k) < -margin) highest = std::min(highest, k);
  }
  return {lowest, highest};
}

FastestRayOptions ray_search_options(const LayerStack& stack, const Problem& problem, const GlobalBudget& budget,
                                     const Monitor& monitor) {
  FastestRayOptions options;
  options.tolerance = budget.tolerance;
  if (budget.max_windows) options.max_words = *budget.max_windows;
  if (const auto* box = find_ability<HasBox>(*problem.manifold))
    std::tie(options.lowest, options.highest) = layers_in(stack, box->box_lower(), box->box_upper());
  options.allowed = [&problem](const Points& x) { return is_in_box(problem, x); };
  options.stop = stop_of_search(budget, monitor);
  return options;
}

}  // namespace

PostProcessed FastestRefractionPostProcessor::apply(const Problem& problem, const FirstPath&, PostProcessed current,
                                                    const Monitor& monitor) const {
  const LayerStack& stack = layers_of(problem, "fastest_refraction");
  if (std::holds_alternative<GlobalOff>(proof_) || monitor.interrupted()) return current;
  const GlobalBudget budget =
      std::holds_alternative<GlobalBudget>(proof_) ? std::get<GlobalBudget>(proof_) : GlobalBudget{};
  const FastestRay found = fastest_ray(stack, current.chain.u.leftCols(1), current.chain.u.rightCols(1),
                                       ray_search_options(stack, problem, budget, monitor));
  const double before = current.curve.least_of_class ? current.curve.cost : std::numeric_limits<double>::infinity();
  const bool improved = found.best && found.best->cost < before * (1 - kSameCost);
  if (improved) {
    deliver_ray(stack, *found.best, word_bound(stack, *found.best, found.best->cost), current);
    current.notes.push_back("fastest_refraction: the cheapest of all paths passes the layers " +
                            text(found.best->word));
  }
  if (!current.curve.least_of_class) return current;  // nothing could be delivered that a bound is about
  GlobalBound& global = current.curve.global.emplace();
  global.lower_bound = std::min(found.lower_bound, current.curve.cost);
  global.gap = 1 - global.lower_bound / current.curve.cost;
  global.proved = found.finished && global.gap <= budget.tolerance;
  global.outcome = global.proved    ? (improved ? ProofOutcome::improved : ProofOutcome::proved)
                   : found.finished ? ProofOutcome::blocked
                                    : ProofOutcome::bounded;
  global.scope = Scope::global;
  global.counts = "words";
  global.steps = found.words;
  global.bound = "snell";
  if (found.finished && !global.proved)
    global.reason = "a cheaper candidate leaves the box, or passes a place where interfaces have crossed";
  return current;
}

}  // namespace leastcost
