// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/problems/costs/combined_cost.hpp>
#include "catalogue/plugins/plugin.hpp"
#include "catalogue/plugins/run_visitor.hpp"

namespace leastcost {

/// {weight: 2, cost: {type: ...}}
struct CostTermOptions {
  double weight = 1;
  PluginChoice cost = {};
  void fields(RunVisitor& visit);
};

struct SumCostOptions {
  std::vector<CostTermOptions> terms = {};
  void fields(RunVisitor& visit);
};

struct ScaledCostOptions {
  ScaleOptions scale = {};
  PluginChoice cost = {};
  void fields(RunVisitor& visit);
};

std::shared_ptr<const SegmentCost> make_sum(const SumCostOptions& options, const BuildContext& context);
std::shared_ptr<const SegmentCost> make_scaled(const ScaledCostOptions& options, const BuildContext& context);

/// What a sum waits for is what a part of it waits for.
WaitsFor waits_of(const SumCostOptions& options);
WaitsFor waits_of(const ScaledCostOptions& options);

/// Checks the parts. Throws OptionError.
void check_parts_of(const SumCostOptions& options, const BuildContext& context);
void check_parts_of(const ScaledCostOptions& options, const BuildContext& context);

}  // namespace leastcost
