// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/monitor.hpp>
#include "ompl/plan_space.hpp"

namespace leastcost {

struct TightenOptions {
  int points = 100;     ///< that the path is divided into
  int rounds = 1;       ///< at most
  bool partial = true;  ///< whether a stretch that cannot be made straight is moved a part of the way
};

/// Shortcuts, long ones first, in equal windows, so that the same path gives the same: every stretch that may be
/// straight and is cheaper so becomes so. Every move of what comes back is valid in the words of the planner where
/// those of `x` are. Ends early where it is stopped.
Points tighten(const PlanSpace& space, const Points& x, const TightenOptions& options, const Monitor& monitor);

}  // namespace leastcost
