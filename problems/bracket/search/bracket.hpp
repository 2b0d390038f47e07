// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <limits>

#include <leastcost/problems/bracket/coordinate_cost.hpp>
#include <leastcost/problems/bracket/cost_density.hpp>
#include <leastcost/problems/bracket/cost_dual.hpp>
#include <leastcost/problems/bracket/search/box_bracket.hpp>
#include <leastcost/problems/bracket/space_density.hpp>

namespace leastcost {

/// No path in the box from `source` to `target` costs less than `lower`: for a potential u with |grad u| <= n every
/// path costs at least u(target) - u(source). The potential comes from fast marching, second order by correction of its
/// defect, as a spline; the inequality is proved cell by cell in outward rounded arithmetic; finer grids cover only
/// what a path of at most `upper` can reach. `upper`: proved cost of a path that is known, or infinity; then the way
/// down the field takes its place, where there are no obstacles. docs/numerics.md Sec. 6.10 says what is trusted.
/// Throws InputError for ends outside the box or a box without area.
Bracket bracket_least_cost(const CostDensity& density, const Eigen::AlignedBox2d& box, const Eigen::Vector2d& source,
                           const Eigen::Vector2d& target, double upper = std::numeric_limits<double>::infinity(),
                           const BracketOptions& options = {});

/// The same of a cost that depends on the direction, there and back alike or not: metrics, winds. H(x, grad u) <= 1
/// takes the place of |grad u| <= n.
Bracket bracket_least_cost(const CostDual& dual, const Eigen::AlignedBox2d& box, const Eigen::Vector2d& source,
                           const Eigen::Vector2d& target, double upper = std::numeric_limits<double>::infinity(),
                           const BracketOptions& options = {});

/// The same of a cost that is known by its values only, in the coordinates of its domain: nothing is proved. The
/// inequality is looked at, at four places of each cell, and so are the surroundings of the ends; `lower` and `upper`
/// are what they are if nothing lies in between.
Bracket bracket_least_cost(const CoordinateCost& cost, const Eigen::AlignedBox2d& box, const Eigen::Vector2d& source,
                           const Eigen::Vector2d& target, double upper = std::numeric_limits<double>::infinity(),
                           const BracketOptions& options = {});

/// The first of these in a box of space. Finer grids have nodes only where a path of at most `upper` can come.
SpaceBracket bracket_least_cost(const SpaceDensity& density, const Eigen::AlignedBox3d& box,
                                const Eigen::Vector3d& source, const Eigen::Vector3d& target,
                                double upper = std::numeric_limits<double>::infinity(),
                                const SpaceBracketOptions& options = {});

}  // namespace leastcost
