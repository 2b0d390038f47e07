// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/cell_graph.hpp>

#include <cmath>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "framework/domain/in_parts.hpp"
#include "problems/cells/beside_sides.hpp"
#include "problems/cells/cell_graph.hpp"
#include "problems/cells/has_cost_cells.hpp"
#include "problems/cells/side_nodes.hpp"

namespace leastcost {
namespace {

constexpr double kMostPlaces = 1.5e8;  ///< about 20 bytes each

/// So that a search without options takes about a second: a place takes half a microsecond or more. With one place the
/// path that comes out costs a tenth of a per cent more, at most 0.3 in noise and plateaus of 150 x 150 cells.
int side_points_for(const CellMap& map) {
  constexpr double kManyCells = 3e5;
  return 1.0 * map.rows() * map.columns() > kManyCells ? 1 : 3;
}

}  // namespace

void CellGraphOptions::fields(FieldVisitor& visit) {
  visit.field("side_points", side_points,
              {.help = "Points on each side of a cell, in addition to its corners; more points find more paths and "
                       "take longer. Default: 3, or 1 if the raster has more than 300,000 cells.",
               .minimum = 0,
               .maximum = 63});
}

FirstPath CellGraphInitializer::first_path(const Problem& problem, const Monitor& monitor) const {
  const CellMap map = cells_of(problem, "cell_graph");
  const int side_points = options_.side_points.value_or(side_points_for(map));
  if (SideNodes::count_for(map, side_points) > kMostPlaces)
    throw InputError("cell_graph: " + std::to_string(map.rows()) + " x " + std::to_string(map.columns()) +
                     " cells are too many for " + std::to_string(side_points) +
                     " points on each side: give fewer (initializer: {type: cell_graph, side_points: 0}), or a box "
                     "around the ends (manifold: {type: euclidean, lower: [..], upper: [..]})");
  const CellPath found = least_cell_path(map, problem.source.u, problem.target.u, side_points,
                                         [limit = monitor.limit()] { look_at_clock(limit); });
  if (found.empty()) throw InitializationError("cells without data separate the ends: there is no path between them");
  FirstPath first;
  const CellPath path = beside_sides(map, found);  // along a side of the domain's box too only cells in it count
  first.path.u.resize(2, static_cast<Index>(path.size()));
  for (std::size_t i = 0; i < path.size(); ++i) first.path.u.col(static_cast<Index>(i)) = path[i];
  return first;
}

}  // namespace leastcost
