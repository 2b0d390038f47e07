// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/framework/cost/has_constant_metric.hpp>

namespace leastcost {

/// c(a, b) = |b - a|, VFCS Eq. (9), in an ambient space of any dimension up to kMaxDimension.
std::shared_ptr<const ConstantMetricCost> make_euclidean_cost(int dim);

}  // namespace leastcost
