// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// A way, as it is walked, whose cost is lowered by moving its points across it: many at once, then fewer. `step`: of
/// the lattice that it was found on; `room`: that points may be in, beside those of the way.
std::vector<Eigen::Vector2d> tightened(const Problem& problem, const std::vector<Eigen::Vector2d>& way, double step,
                                       const Eigen::AlignedBox2d& room);

/// The same in space.
std::vector<Eigen::Vector3d> tightened(const Problem& problem, const std::vector<Eigen::Vector3d>& way, double step,
                                       const Eigen::AlignedBox3d& room);

}  // namespace leastcost
