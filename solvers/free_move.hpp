// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// to = R(from, step), the domain's own retraction; whether that is where the step leads, no bound having stopped a
/// point on the way. (A border of a polyhedron is no such bound: its retraction goes along it.)
/// Throws Interrupted past the deadline.
bool move_freely(const ConstraintManifold& manifold, const CoordinatePath& from, const Points& step, CoordinatePath& to,
                 const Deadline& deadline);

}  // namespace leastcost
