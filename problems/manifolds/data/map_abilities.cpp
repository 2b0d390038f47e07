// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What a map can do besides being a domain: the search over its cells, its picture.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/problems/manifolds/data/map.hpp>
#include "problems/graph/lattice_route.hpp"
#include "problems/mesh/mesh_curve.hpp"

namespace leastcost {
namespace {

constexpr double kNoWay = std::numeric_limits<double>::infinity();

std::int32_t clamped(double x, int begin, int end) {
  return static_cast<std::int32_t>(std::clamp(std::floor(x), double(begin), double(end - 1)));
}

/// Cells that a route of cells turns at; its ends included.
std::vector<std::int32_t> turns_of(const std::vector<std::int32_t>& cells) {
  std::vector<std::int32_t> turns;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (i == 0 || i + 1 == cells.size() || cells[i] - cells[i - 1] != cells[i + 1] - cells[i])
      turns.push_back(cells[i]);
  return turns;
}

}  // namespace

double MapManifold::end_tolerance() const {
  constexpr double kRounding = 1e-9;
  return kRounding * (1 + diameter() + grid_.origin.norm());
}

/// A place on a border of cells belongs to all free ones there, as far as they share sides: not to one on the other
/// side of a corner between two blocked cells.
std::vector<std::int32_t> MapManifold::cells_of(const PathEnd& end) const {
  const auto box = std::upper_bound(face_begin_.begin(), face_begin_.end(), end.site) - face_begin_.begin() - 1;
  const CellBox& cells = boxes_[static_cast<std::size_t>(box)];
  const Eigen::Vector2d at = (end.u.head<2>() - grid_.origin) / grid_.cell;
  const std::int32_t row = clamped(at.y(), cells.row, cells.row_end);
  const std::int32_t column = clamped(at.x(), cells.column, cells.column_end);
  const auto beyond = [](double x, std::int32_t cell) {
    return x <= cell ? cell - 1 : x >= cell + 1 ? cell + 1 : cell;
  };
  const std::int32_t other_row = beyond(at.y(), row), other_column = beyond(at.x(), column);
  std::vector<std::int32_t> all = {row * grid_.columns + column};
  const bool above = other_row != row && grid_.free(other_row, column);
  const bool beside = other_column != column && grid_.free(row, other_column);
  if (above) all.push_back(other_row * grid_.columns + column);
  if (beside) all.push_back(row * grid_.columns + other_column);
  if ((above || beside) && other_row != row && other_column != column && grid_.free(other_row, other_column))
    all.push_back(other_row * grid_.columns + other_column);
  return all;
}

Eigen::Vector2d MapManifold::center(std::int32_t cell) const {
  const std::int32_t row = cell / grid_.columns, column = cell % grid_.columns;
  return grid_.origin + grid_.cell * Eigen::Vector2d(column + 0.5, row + 0.5);
}

/// Of the centre of a cell.
Site MapManifold::site_of(std::int32_t cell) const {
  const auto box = static_cast<std::size_t>(box_of_cell_[static_cast<std::size_t>(cell)]);
  const Eigen::Vector2d at = center(cell);
  // The triangles of a box follow from left to right: the last one whose left side is not to the right of the place.
  std::int32_t first = face_begin_[box], count = face_begin_[box + 1] - first;
  while (count > 1) {
    const std::int32_t half = count / 2, face = first + half;
    const Eigen::Vector2d lower = mesh().position(mesh().face(face)[0]).head<2>();
    const Eigen::Vector2d upper = mesh().position(mesh().face(face)[2]).head<2>();
    const Eigen::Vector2d up = upper - lower, to = at - lower;
    const bool right = up.x() * to.y() - up.y() * to.x() <= 0;
    first += right ? half : 0;
    count = right ? count - half : half;
  }
  return first;
}

FirstPath MapManifold::least_cost_edges(const Problem& problem, const Monitor& monitor) const {
  const Lattice lattice{{grid_.columns, grid_.rows, 1}};
  const std::vector<LatticeStep> steps = steps_of(lattice);
  const SegmentCost& cost = *problem.cost;
  const std::optional<MetricRoot> metric = constant_metric(problem);
  const bool constant = metric.has_value();
  const Eigen::Matrix2d root =
      metric.value_or(MetricRoot{}).value_or(Eigen::Matrix3d::Identity()).topLeftCorner<2, 2>();
  std::vector<double> fixed;  // costs of the steps, where these are the same everywhere
  fixed.reserve(steps.size());
  for (const LatticeStep& step : steps) fixed.push_back(grid_.cell * (root * Eigen::Vector2d(step[0], step[1])).norm());
  const auto move = [&](std::int32_t from, const std::array<std::int32_t, 3>& at, std::size_t k) {
    const LatticeStep& step = steps[k];
    const std::int32_t to = from + step[0] + grid_.columns * step[1];
    if (grid_.blocked[static_cast<std::size_t>(to)]) return kNoWay;
    if (step[0] != 0 && step[1] != 0 &&
        (grid_.blocked[grid_.index(at[1], at[0] + step[0])] || grid_.blocked[grid_.index(at[1] + step[1], at[0])]))
      return kNoWay;
    return constant ? fixed[k] : move_cost(cost, center(from), center(to));
  };
  const auto ends_at = [&](const PathEnd& end, bool leaves) {
    std::vector<RouteEnd> ends;
    const Eigen::Vector2d given = end.u;
    for (const std::int32_t cell : cells_of(end)) {
      const Eigen::Vector2d from = leaves ? given : center(cell), to = leaves ? center(cell) : given;
      ends.push_back({cell, constant ? (root * (to - from)).norm() : move_cost(cost, from, to)});
    }
    return ends;
  };
  const std::vector<RouteEnd> ends = ends_at(problem.target, false);
  const bool euclidean = constant && !*metric;
  std::vector<std::array<std::int32_t, 3>> end_places;
  end_places.reserve(ends.size());
  for (const RouteEnd& end : ends) end_places.push_back(lattice.place(end.node));
  const auto bound = [&, below = cost.traits().below_curves](std::int32_t cell,
                                                             const std::array<std::int32_t, 3>& place) {
    double least = kNoWay;
    if (euclidean) {
      for (std::size_t i = 0; i < ends.size(); ++i)
        least = std::min(least, grid_.cell * octile_distance(place, end_places[i]) + ends[i].cost);
      return least;
    }
    if (constant) return (root * (center(cell) - problem.target.u)).norm();
    return below ? move_cost(cost, center(cell), problem.target.u) : 0.0;
  };
  const GraphRoute route = lattice_route(lattice, ends_at(problem.source, true), ends, move, bound,
                                         [&monitor] { return monitor.interrupted(); });
  if (route.outcome == RouteOutcome::stopped) throw Interrupted("the search over the cells of the map was interrupted");
  if (route.outcome == RouteOutcome::unreachable)
    throw InitializationError("no path over free cells joins the ends (" + std::to_string(route.settled) +
                              " cells can be reached from the source)");
  FirstPath first;
  first.graph_vertices = static_cast<int>(route.nodes.size());
  const std::vector<std::int32_t> cells = constant ? turns_of(route.nodes) : route.nodes;
  const auto m = static_cast<Index>(cells.size());
  first.path.u.resize(2, m + 2);
  first.path.u.col(0) = problem.source.u;
  first.path.u.col(m + 1) = problem.target.u;
  first.path.sites.assign(static_cast<std::size_t>(m) + 2, problem.source.site);
  first.path.sites.back() = problem.target.site;
  for (Index i = 0; i < m; ++i) {
    first.path.u.col(i + 1) = center(cells[static_cast<std::size_t>(i)]);
    first.path.sites[static_cast<std::size_t>(i) + 1] = site_of(cells[static_cast<std::size_t>(i)]);
  }
  return first;
}

std::vector<DataCount> MapManifold::counts() const {
  return {{"free cell", "free cells", std::count(grid_.blocked.begin(), grid_.blocked.end(), false)},
          {"face", "faces", mesh().face_count()},
          {"component", "components", static_cast<long>(mesh().component_sizes().size())}};
}

void MapManifold::draw(const DrawnPaths&, Drawing& out) const {
  // A vertex on the border has one border edge that leaves it: corners that two boxes share are two vertices.
  std::vector<std::int32_t> leaving(static_cast<std::size_t>(mesh().vertex_count()), -1);
  for (std::int32_t h = 0; h < 3 * mesh().face_count(); ++h)
    if (mesh().across(h) == TriangleMesh::kBorder) leaving[static_cast<std::size_t>(mesh().tail(h))] = h;
  for (std::int32_t v = 0; v < mesh().vertex_count(); ++v) {
    std::vector<Eigen::Vector2d> corners;
    std::int32_t at = v;
    for (std::int32_t h = leaving[static_cast<std::size_t>(v)]; h >= 0; h = leaving[static_cast<std::size_t>(at)]) {
      corners.emplace_back(mesh().position(at).head<2>());
      leaving[static_cast<std::size_t>(at)] = -1;
      at = mesh().head(h);
    }
    if (corners.empty()) continue;
    corners.push_back(corners.front());
    Points line(2, static_cast<Index>(corners.size()));
    for (std::size_t i = 0; i < corners.size(); ++i) line.col(static_cast<Index>(i)) = corners[i];
    out.free.push_back(std::move(line));
  }
}

}  // namespace leastcost
