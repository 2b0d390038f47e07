// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <leastcost/framework/base/monitor.hpp>
#include "ompl/plans/plan_space.hpp"

namespace leastcost {

/// A plan of two random trees between places of the space, clear of its walls (Kuffner and LaValle 2000, RRT-Connect);
/// angles and quaternions of one place follow from those of the place before, so that the last may be `to` by another
/// name. The same seed gives the same plan. Nothing: the trees had that many nodes, or the monitor says stop.
std::optional<Points> random_plan(const PlanSpace& space, const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                  std::uint64_t seed, int most_nodes, const Monitor& monitor);

}  // namespace leastcost
