// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// First paths over the places of the heights of a terrain.
#include <cmath>
#include <limits>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/problems/manifolds/data/terrain.hpp>
#include "problems/graph/lattice_route.hpp"
#include "problems/raster/raster_function.hpp"

namespace leastcost {

/// A height is that of the spline through it, to rounding.
Eigen::Vector3d TerrainManifold::node(int row, int column) const {
  const Eigen::Vector2d place = heights_->patches().corner(row, column);
  return {place[0], place[1], raster_.value(row, column)};
}

/// Whether a straight step from a node stays in or beside patches that are known.
bool TerrainManifold::is_step(int row, int column, int rows, int columns) const {
  const RasterPatches& patches = heights_->patches();
  const int low = std::min(row, row + rows), left = std::min(column, column + columns);
  return patches.known(low, left) || (rows == 0 && patches.known(low - 1, left)) ||
         (columns == 0 && patches.known(low, left - 1));
}

FirstPath TerrainManifold::least_cost_edges(const Problem& problem, const Monitor& monitor) const {
  const Lattice lattice{{raster_.columns, raster_.rows, 1}};
  const std::vector<LatticeStep> steps = steps_of(lattice);
  const SegmentCost& cost = *problem.cost;
  const auto place_of = [&](std::int32_t number) {
    const auto at = lattice.place(number);
    return node(at[1], at[0]);
  };
  const auto move = [&](std::int32_t from, const std::array<std::int32_t, 3>& at, std::size_t k) {
    if (!is_step(at[1], at[0], steps[k][1], steps[k][0])) return std::numeric_limits<double>::infinity();
    return move_cost(cost, place_of(from), node(at[1] + steps[k][1], at[0] + steps[k][0]));
  };
  const auto ends_at = [&](const PathEnd& end, bool leaves) {  // the corners of its patch
    std::vector<RouteEnd> ends;
    const Eigen::Vector2d cells = heights_->patches().in_cells(end.u[0], end.u[1]);
    const std::optional<RasterPatch> patch = heights_->patches().at(cells[0], cells[1]);
    if (!patch) return ends;
    const Eigen::Vector3d place = on_surface(end.u);
    for (const int row : {patch->row, patch->row + 1})
      for (const int column : {patch->column, patch->column + 1}) {
        const Eigen::Vector3d corner = node(row, column);
        const double c = leaves ? move_cost(cost, place, corner) : move_cost(cost, corner, place);
        if (std::isfinite(c)) ends.push_back({lattice.number({column, row, 0}), c});
      }
    return ends;
  };
  const Eigen::Vector3d target = on_surface(problem.target.u);
  const bool below = cost.traits().below_curves;
  const auto bound = [&](std::int32_t number, const std::array<std::int32_t, 3>&) {
    return below ? move_cost(cost, place_of(number), target) : 0.0;
  };
  const auto stop = [&monitor] { return monitor.interrupted(); };
  const auto* obstacles = find_ability<ChecksMoves>(*problem.manifold);
  const auto clear = [&](std::int32_t from, std::int32_t to) {
    return obstacles->clearance(place_of(from), place_of(to)).upper >= 0;
  };
  const std::vector<RouteEnd> starts = ends_at(problem.source, true), ends = ends_at(problem.target, false);
  const GraphRoute route = obstacles != nullptr ? lattice_route(lattice, starts, ends, move, bound, stop, clear)
                                                : lattice_route(lattice, starts, ends, move, bound, stop);
  if (route.outcome == RouteOutcome::stopped)
    throw Interrupted("the search over the cells of the terrain was interrupted");
  if (route.outcome == RouteOutcome::unreachable)
    throw InitializationError("no path over cells with data joins the ends (" + std::to_string(route.settled) +
                              " cells can be reached from the source)");
  FirstPath first;
  first.graph_vertices = static_cast<int>(route.nodes.size());
  const auto m = static_cast<Index>(route.nodes.size());
  first.path.u.resize(2, m + 2);
  first.path.u.col(0) = problem.source.u;
  first.path.u.col(m + 1) = problem.target.u;
  for (Index i = 0; i < m; ++i) first.path.u.col(i + 1) = place_of(route.nodes[static_cast<std::size_t>(i)]).head<2>();
  return first;
}

}  // namespace leastcost
