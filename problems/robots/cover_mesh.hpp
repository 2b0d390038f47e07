// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include <leastcost/problems/robots/covering.hpp>

namespace leastcost {

/// Up to eight capsules whose union holds a triangle mesh, and what it encloses. The mesh is cut into slabs of equal
/// thickness across its longest axis, each of which one capsule covers: what is solid in a slab is in the hull of the
/// surface in it, as its cross-sections are in the hulls of their outlines. More slabs (of 1, 2, 4
/// or 8) are taken where what they add to the hull of all, or the sum of their volumes, is smaller by a fifth. Throws
/// OptionError("points") where there is none and for numbers that are not finite, and ("faces") for one with a corner
/// that is not there.
Covering cover_mesh(const std::vector<Eigen::Vector3d>& points, const std::vector<std::array<std::int32_t, 3>>& faces);

}  // namespace leastcost
