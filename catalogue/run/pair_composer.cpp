// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/pair_composer.hpp"

#include <utility>

#include "catalogue/plugins/kinds.hpp"
#include "catalogue/run/ends.hpp"
#include "catalogue/run/preparation.hpp"

namespace leastcost {

PairComposer::PairComposer(RunConfig config, BuildContext context,
                           std::shared_ptr<const ConstraintManifold> open_domain, RunParts parts)
    : config_(std::move(config)),
      context_(std::move(context)),
      open_domain_(std::move(open_domain)),
      parts_(std::move(parts)) {}

RunParts PairComposer::compose(EndOptions source, EndOptions target) const {
  source = in_coordinates(std::move(source), *open_domain_, parts_.problem.cost.get(), "source");
  target = in_coordinates(std::move(target), *open_domain_, parts_.problem.cost.get(), "target");
  for (EndOptions* end : {&source, &target})
    if (end->point && !end->tolerance) end->tolerance = config_.pair_tolerance;
  RunParts out = parts_;
  out.notes.clear();
  Problem& problem = out.problem;
  // As for one path: ends are placed before the obstacles are, and one within a clearance is refused, not moved.
  problem.manifold = open_domain_;
  out.source = place_end(*open_domain_, source, "source");
  problem.source = out.source.end;
  place_target(target, "target", out);
  problem.manifold = parts_.problem.manifold;
  refuse_end_in_clearance(problem, problem.source, "source");
  refuse_end_in_clearance(problem, problem.target, "target");
  if (are_one_place(problem)) return out;
  if (config_.cost.plugin->follows_source) {
    BuildContext context = context_;
    context.source = source_position(problem);
    context.target = positions(*problem.manifold, {problem.target.u, {}, true});
    problem.cost = make<std::shared_ptr<const SegmentCost>>(config_.cost, context);
  }
  take_cheapest_image(config_, open_domain_, out);
  if (asks_for_preparation(out, false)) std::call_once(prepared_, [&] { prepare(problem); });
  return out;
}

}  // namespace leastcost
