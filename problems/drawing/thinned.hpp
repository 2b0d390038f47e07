// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <leastcost/problems/drawing/draws_itself.hpp>

namespace leastcost {

/// A surface with vertices merged in the cells of a grid until at most `budget` triangles are left, except near the
/// columns of `focus` (3 x m, may be empty), where it stays as it is. As it is where it is small enough, or where that
/// does not help.
TriangleSoup thinned(TriangleSoup surface, const Points& focus, std::size_t budget);

}  // namespace leastcost
