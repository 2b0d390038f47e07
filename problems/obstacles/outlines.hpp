// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>

namespace leastcost {

/// Adds to a drawing of the plane where the obstacles end and, with a clearance, where points may begin to be.
void draw_outlines(const std::vector<std::shared_ptr<const Obstacle>>& obstacles, double clearance, Drawing& out);

}  // namespace leastcost
