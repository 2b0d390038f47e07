// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/pair_composer.hpp"

#include <utility>

#include "catalogue/plugins/kinds.hpp"
#include "catalogue/run/cheapest_image.hpp"
#include "catalogue/run/ends.hpp"
#include "catalogue/run/preparation.hpp"

namespace leastcost {

PairComposer::PairComposer(RunConfig config, BuildContext context,
                           std::shared_ptr<const ConstraintManifold> open_domain, RunParts parts)
    : config_(std::move(config)),
      context_(std::move(context)),
      open_domain_(std::move(open_domain)),
      parts_(std::move(parts)) {}

/// The cost for the ends of a problem.
std::shared_ptr<const SegmentCost> PairComposer::cost_between(const Problem& problem) const {
  using Cost = std::shared_ptr<const SegmentCost>;
  BuildContext context = context_;
  if (config_.cost.plugin->follows_source) {
    context.source = source_position(problem);
    context.target = positions(*problem.manifold, {problem.target.u, {}, true});
    return make<Cost>(config_.cost, context);
  }
  if (config_.ends_come_later() || waits_for<Cost>(config_.cost) != WaitsFor::domain) return problem.cost;
  std::call_once(made_, [&] {  // the one that was composed may have looked at the ends of the configuration
    context.source = Eigen::VectorXd::Zero(context.dimension);
    context.target.reset();
    cost_of_all_ = make<Cost>(config_.cost, context);
  });
  return cost_of_all_;
}

RunParts PairComposer::compose(EndOptions source, EndOptions target, const RunParts& all) const {
  source = in_coordinates(with_state(std::move(source), context_.robot.get(), "source"), *open_domain_,
                          all.problem.cost.get(), "source");
  target = in_coordinates(with_state(std::move(target), context_.robot.get(), "target"), *open_domain_,
                          all.problem.cost.get(), "target");
  for (EndOptions* end : {&source, &target})
    if (end->point && !end->tolerance) end->tolerance = config_.pair_tolerance;
  RunParts out = all;
  out.notes.clear();
  Problem& problem = out.problem;
  // As for one path: ends are placed before the obstacles are, and one within a clearance is refused, not moved.
  problem.manifold = open_domain_;
  out.source = place_end(*open_domain_, source, "source");
  problem.source = out.source.end;
  note_far_end("the source", out.source, out);
  place_target(target, "target", out);
  problem.manifold = all.problem.manifold;
  refuse_end_in_clearance(problem, problem.source, "source");
  refuse_end_in_clearance(problem, problem.target, "target");
  const bool one_place = are_one_place(problem);
  if (one_place && config_.ends_from == EndsFrom::configuration) return out;
  if (problem.cost == parts_.problem.cost) problem.cost = cost_between(problem);  // else it was replaced in memory
  if (one_place) return out;
  take_cheapest_image(config_, open_domain_, out);
  if (asks_for_preparation(out, false)) std::call_once(prepared_, [&] { prepare(problem); });
  return out;
}

}  // namespace leastcost
