// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <leastcost/framework/cost/has_interfaces.hpp>
#include <leastcost/problems/layers/layer_stack.hpp>

namespace leastcost {

/// HasInterfaces::crossings() of a stack.
std::vector<Crossing> measure_crossings(const LayerStack& stack, const Points& polyline);

/// Polyline without its points of no leg between (closer than rounding).
Points without_repeats(const Points& polyline);

}  // namespace leastcost
