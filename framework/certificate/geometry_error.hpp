// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// Coarser versions of the domain that are asked for.
inline constexpr int kGeometryLevels = 2;

/// What the representation of the domain does to the cost of a path.
struct GeometryError {
  std::optional<double> value;  ///< units of the cost; nothing: the domain has no coarser version, or see `trouble`
  std::string trouble;          ///< why it could not be measured; empty: all is well
};

/// Solves the chain once more, with as many points, on the coarser version of the domain between the ends projected
/// onto that (cost C_1), and again on the coarser version of that one, where it has one (C_2). Twice the largest
/// (docs/numerics.md Sec. 6.5) of
/// * |C - C_1|;
/// * |C_1 - C_2| / 2, the half standing for the least that a difference shrinks from one level to the next;
/// * the sum over the points of the change of the cost as the point alone moves to its foot on the first coarser
/// version. A cost that is made from the data of the domain (FollowsDomain) is made again on each version. One
/// difference alone happens to vanish now and then: on sampled tori (1350 random geodesics, 3000 to 20,000 points)
/// twice the first covered the true error in 87 to 98 of 100 cases, twice the largest of the three in all of them, at
/// about ten times the error. (The rule was chosen on these same geodesics: expect somewhat less elsewhere.) The same
/// number of points on all versions takes the error of the chain out of it.
/// Throws Interrupted after the monitor's deadline.
GeometryError measure_geometry_error(const Problem& problem, const CoordinatePath& chain, const Monitor& monitor);

/// Where the data of the domain do not say what it is (HasUnresolvedPlaces), at the points of the chain or in the
/// middle between two of them: why and where. Empty where nothing is known against them. Throws Interrupted after the
/// monitor's deadline.
std::string why_unresolved(const Problem& problem, const CoordinatePath& chain, const Monitor& monitor);

}  // namespace leastcost
