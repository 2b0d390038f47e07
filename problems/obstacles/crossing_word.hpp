// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <leastcost/framework/path/path.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// The class of a path in the plane, 2 x m, that goes into no obstacle: a ray goes up from a place within each of them;
/// the word has the rays that the path crosses, in order, obstacle + 1 for one crossed to the right and the negative of
/// it to the left, without those that it crosses to and fro. Paths between the same ends are of one class where they
/// have the same word, and only there (the fundamental group of a plane with holes is free). `rounds`: of all
/// obstacles, ascending; the first of each counts.
std::vector<int> crossing_word(const std::vector<Round>& rounds, const Points& path);

/// Whether two polylines in the plane between the same ends, 2 x m, pass all obstacles on the same sides, in the same
/// order; nothing where the walls are not made of discs.
std::optional<bool> of_one_class(const Walls& walls, const Points& a, const Points& b);

}  // namespace leastcost
