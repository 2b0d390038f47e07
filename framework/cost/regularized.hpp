// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// How the least cost that is meant lies to the cost of a path under the one that was minimised.
struct Regularization {
  double below = 0;            ///< at most so much below it, units of the cost
  double above = 0;            ///< at most so much above it
  double free_share = 0;       ///< the part of the cost, 0 to 1, that is paid where other ways cost the same
  std::string free_ways = {};  ///< what these are, in words; empty where there are none
};

/// Ability: the cost is smooth and strictly convex, and stands for one that is not: a kink that was rounded, a hull
/// with flat parts where many ways cost the same. The certificate puts what that does to the value into the bar, and
/// where ways are free it speaks of the value alone: scope `local_value`.
class Regularized {
 public:
  virtual ~Regularized() = default;
  /// Along a chain that is stationary under this cost.
  virtual Regularization regularization(const AmbientPath& path) const = 0;
};

}  // namespace leastcost
