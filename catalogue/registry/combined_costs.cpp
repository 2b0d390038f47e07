// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/registry/combined_costs.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/plugins/kinds.hpp"

namespace leastcost {
namespace {

using Cost = std::shared_ptr<const SegmentCost>;

std::string term_key(std::size_t i) { return "terms." + std::to_string(i); }

/// One step on the plug-in of a part. Its faults are those of `key`, within the options of the whole.
template <class Step>
auto on_part(const PluginChoice& choice, const std::string& key, Step step) {
  if (!choice) throw OptionError(key, "missing: give a cost, like {type: euclidean}");
  try {
    return step(static_cast<const CostPlugin&>(*choice.plugin), *choice.options);
  } catch (const OptionError& e) {
    throw e.under(key);
  }
}

Cost made_part(const PluginChoice& choice, const std::string& key, const BuildContext& context) {
  return on_part(choice, key,
                 [&](const CostPlugin& plugin, const AnyOptions& options) { return plugin.make(options, context); });
}

void check_part(const PluginChoice& choice, const std::string& key, const BuildContext& context) {
  on_part(choice, key, [&](const CostPlugin& plugin, const AnyOptions& options) {
    if (plugin.check) plugin.check(options, context);
  });
}

WaitsFor waits_of_part(const PluginChoice& choice) { return choice ? waits_for<Cost>(choice) : WaitsFor::nothing; }

}  // namespace

void CostTermOptions::fields(RunVisitor& visit) {
  visit.field("weight", weight, {.help = "Factor of the cost.", .minimum = 0, .exclusive_minimum = true});
  visit.plugin("cost", cost, "cost", {.help = "The cost.", .required = true});
}

void SumCostOptions::fields(RunVisitor& visit) {
  visit.blocks(
      "terms", blocks_of(terms),
      {.help = "The costs, like [{weight: 2, cost: euclidean}, {cost: {type: travel_time}}].", .required = true});
}

void ScaledCostOptions::fields(RunVisitor& visit) {
  scale.fields(visit);
  visit.plugin("cost", cost, "cost", {.help = "The cost to be multiplied.", .required = true});
}

Cost make_sum(const SumCostOptions& options, const BuildContext& context) {
  std::vector<WeightedCost> terms;
  for (std::size_t i = 0; i < options.terms.size(); ++i)
    terms.push_back({options.terms[i].weight, made_part(options.terms[i].cost, term_key(i) + ".cost", context)});
  return make_sum_cost(std::move(terms));
}

Cost make_scaled(const ScaledCostOptions& options, const BuildContext& context) {
  return make_scaled_cost(options.scale, made_part(options.cost, "cost", context));
}

WaitsFor waits_of(const SumCostOptions& options) {
  WaitsFor most = WaitsFor::nothing;
  for (const CostTermOptions& term : options.terms) most = std::max(most, waits_of_part(term.cost));
  return most;
}
WaitsFor waits_of(const ScaledCostOptions& options) { return waits_of_part(options.cost); }

void check_parts_of(const SumCostOptions& options, const BuildContext& context) {
  for (std::size_t i = 0; i < options.terms.size(); ++i)
    check_part(options.terms[i].cost, term_key(i) + ".cost", context);
}
void check_parts_of(const ScaledCostOptions& options, const BuildContext& context) {
  check_part(options.cost, "cost", context);
}

}  // namespace leastcost
