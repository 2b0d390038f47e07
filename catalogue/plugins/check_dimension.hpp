// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/catalogue/plugins/build_context.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/raster/has_voids.hpp>

namespace leastcost {

/// A cost that the library has not made may be one of another space, or a map where there is no plane. Throws
/// OptionError with `key`.
inline void check_dimension(const SegmentCost& cost, const BuildContext& context, const char* key) {
  if (context.dimension != 0 && cost.dim() != context.dimension)
    throw OptionError(key, "the cost is defined for moves in R^" + std::to_string(cost.dim()) +
                               ", but the manifold lies in R^" + std::to_string(context.dimension));
  const std::string why = find_ability<HasVoids>(cost) != nullptr ? why_no_map_of(context.manifold.get()) : "";
  if (!why.empty()) throw OptionError(key, why);
}

}  // namespace leastcost
