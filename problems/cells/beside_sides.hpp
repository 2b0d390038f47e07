// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "problems/cells/cell_map.hpp"

namespace leastcost {

/// A path as it is delivered: where it runs along a side, the middle of that move lies a hair, 5e-8 of a cell, inside
/// the cheaper of the two cells, so that every program reads the same cost along it, whichever cell it takes a side to
/// be of. That costs 1e-14 more.
CellPath beside_sides(const CellMap& map, const CellPath& path);
/// The path itself.
Eigen::Matrix2Xd onto_sides(const CellMap& map, const Eigen::Ref<const Eigen::Matrix2Xd>& polyline);

}  // namespace leastcost
