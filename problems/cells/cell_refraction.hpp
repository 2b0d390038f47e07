// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <leastcost/framework/cost/has_interfaces.hpp>
#include "problems/cells/cell_map.hpp"

namespace leastcost {

struct RefractedCellPath {
  CellPath path;  ///< with a place on every side that it crosses
  double cost = 0;
  double least = 0;      ///< no path by the same sides and corners in order costs less
  bool finished = true;  ///< no corner is left that a turn beside it would be cheaper than
};

/// The locally least-cost path beside one of finite cost: crossings by Snell's law, corners of cells passed on the
/// cheaper side or met. Never dearer than the given one.
RefractedCellPath refract_in_cells(const CellMap& map, const CellPath& path, const std::function<void()>& look = {});

/// What a polyline does at its places, measured on it alone: the difference of the slownesses along a side (Snell's
/// law), or how fast the cost falls beside a corner, relative to the larger unit cost. 2 for what no least path does: a
/// bend within a cell, a leg that shares no cell.
std::vector<Crossing> measure_cell_crossings(const CellMap& map, const Eigen::Ref<const Eigen::Matrix2Xd>& polyline);

}  // namespace leastcost
