// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

/// Takes away the pairs of capsules that touch in each of 200 random configurations, as coverings of links beside the
/// same joint do: with them there would be no free configuration. `whose` of the robot then names them. Pairs before
/// number `first` stay.
void leave_out_what_always_touches(Robot& robot, std::size_t first);

}  // namespace leastcost
