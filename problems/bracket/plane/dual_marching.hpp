// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "problems/bracket/plane/level.hpp"

namespace leastcost::bracket {

/// Costs that arrive at the nodes, of first order, for costs that depend on the direction: H(x, grad u) is the density
/// of the front. Over the eight triangles around a node (Tsitsiklis, IEEE T. Automat. Contr. 40, 1995; Bornemann,
/// Rasch 2006), in the order of the costs, and again where a node becomes cheaper, for no order is right for all costs.
/// `u`: values at the seeds, which are kept, infinite elsewhere. Throws Stopped.
void march_dual(const Level& level, const Front& front, std::vector<double>& u, const StopLook& look);

}  // namespace leastcost::bracket
