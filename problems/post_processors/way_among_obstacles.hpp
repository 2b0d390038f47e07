// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// A way down a field on cells cuts in at obstacles by some of them. The same way on the domain, ambient x points,
/// whose moves enter obstacles by less than a part of a step; nothing where it leads through one, for then what is
/// beside its points lies on both sides. `way`: coordinate x points of a flat domain, in steps of part of a cell.
std::optional<Points> way_among_obstacles(const Problem& problem, const Points& way);

}  // namespace leastcost
