// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include <leastcost/problems/occupancy/occupancy_grid.hpp>

namespace leastcost {

/// The free cells as triangles at z = 0, a strip of them for each box.
struct FreeMesh {
  PolygonSoup triangles;                 ///< corners counterclockwise
  std::vector<std::int32_t> face_begin;  ///< box i has triangles [face_begin[i], face_begin[i + 1])
};

/// Boxes of free_boxes(). Where two of them meet along a side both have the ends of the common part as vertices, so
/// that no edge meets another in its middle. Each such pair of ends belongs to these two boxes alone: where two boxes
/// meet in a corner only, as free cells diagonally beside two blocked ones do, the corner is two vertices, and no path
/// leads through.
FreeMesh free_mesh(const OccupancyGrid& grid, const std::vector<CellBox>& boxes);

}  // namespace leastcost
