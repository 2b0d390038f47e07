// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/catalogue/plugins/build_context.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>

namespace leastcost {

/// A cost that the library has not made may be one of another space. Throws OptionError with `key`.
inline void check_dimension(const SegmentCost& cost, const BuildContext& context, const char* key) {
  if (context.dimension == 0 || cost.dim() == context.dimension) return;
  throw OptionError(key, "the cost is one of moves in R^" + std::to_string(cost.dim()) +
                             ", but the manifold lies in R^" + std::to_string(context.dimension));
}

}  // namespace leastcost
