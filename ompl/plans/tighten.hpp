// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/monitor.hpp>
#include "ompl/plans/plan_space.hpp"

namespace leastcost {

/// The cheapest path along a polyline, with shortcuts: straight moves between any two of `points` places on it, its
/// vertices among them. Moves are asked for only on the cheapest path so far, so that most are never asked for. Without
/// chance: the same polyline gives the same path. Ends early where it is stopped: with the moves of the polyline, which
/// are taken to be valid, in the place of those that nobody has asked for. A quaternion may come back by its other
/// name.
Points with_shortcuts(const PlanSpace& space, const Points& x, int points, const Monitor& monitor);

/// Pulls a polyline tight where only the planner can say what is free: stretches of its points, long ones first, are
/// moved towards the straight move between their ends, as far as that is cheaper and every move is valid. Ends early
/// where it is stopped.
Points pulled_tight(const PlanSpace& space, const Points& x, int points, const Monitor& monitor);

/// Pulls a polyline tight among the walls that the space looks at: under a length of a constant metric where states are
/// no quaternions by programs (tight_chain()), until a pull gains less than `gain` of the length, else as
/// pulled_tight() does. Every move of what it returns is valid.
Points pulled_among_walls(const PlanSpace& space, const Points& x, const Monitor& monitor, double gain = 3e-4);

/// The path with its vertices and points between them, no farther apart than an equal share of its length where that
/// leaves its moves valid.
Points divided(const PlanSpace& space, const Points& x, int points);

/// Whether every move of a polyline is valid.
bool all_move(const PlanSpace& space, const Points& x);

}  // namespace leastcost
