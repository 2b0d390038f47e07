// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/eikonal.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_free_places.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/problem/has_graph.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include "framework/energy/spacing.hpp"
#include "problems/fields/arrival_field.hpp"
#include "problems/fields/grid_search.hpp"
#include "problems/fields/lattice_box.hpp"
#include "problems/raster/has_cell_index.hpp"

namespace leastcost {
namespace {

constexpr int kFewestCells = 4, kMostCells = 2000, kCells = 100, kMostMargin = 16;

std::string lattice_in_words(const Lattice& lattice) {
  std::ostringstream out;
  out << lattice.count[0] - 1 << " x " << lattice.count[1] - 1 << " cells";
  return out.str();
}

/// Where the domain has no box a raster of costs has one: nothing is known beyond it.
void close_by_raster(LatticeBox& box, const Problem& problem) {
  const auto* raster = find_ability<HasCellIndex>(*problem.cost);
  if (raster == nullptr) return;
  const Eigen::Vector2d lower = raster->patches().lower(), upper = raster->patches().upper();
  for (std::size_t d = 0; d < 2; ++d) {
    const auto k = static_cast<Eigen::Index>(d);
    if (box.open_lower[d]) box.lower[k] = lower[k];
    if (box.open_upper[d]) box.upper[k] = upper[k];
  }
}

/// Along the longest side: nodes on the values of a raster, and between them, as long as there are not too many.
int cells_for(const LatticeBox& box, const Problem& problem, bool obstacles) {
  constexpr double kMostParts = 16, kNodes = 80000, kMostNodes = 640000, kNodesAmongObstacles = 40000;
  const auto* raster = find_ability<HasCellIndex>(*problem.cost);
  if (raster == nullptr) return kCells;
  const Eigen::Vector2d size = box.upper - box.lower;
  const double longest = size.maxCoeff(), along = longest / raster->patches().cell().minCoeff();
  const double ratio = size.minCoeff() / longest;  // nodes: ratio cells^2
  const double parts = std::clamp(std::floor(std::sqrt(kNodes / ratio) / along), 1.0, kMostParts);
  const double most = std::sqrt((obstacles ? kNodesAmongObstacles : kMostNodes) / ratio);
  return static_cast<int>(
      std::clamp(std::round(std::min(parts * along, most)), double{kFewestCells}, double{kMostCells}));
}

/// The way down a field. Throws InitializationError where there is none, or where it costs infinitely much.
CoordinatePath way_of(const ArrivalField& field, const Problem& problem) {
  if (!field.arrival_cost())
    throw InitializationError("eikonal: " + lattice_in_words(field.lattice()) +
                              ": no path reaches the target. Use more cells to find a narrower passage, or a wider box "
                              "(lower, upper) to find a way around");
  const std::vector<Eigen::Vector2d> way = field.way();
  CoordinatePath path{Points(2, static_cast<Index>(way.size())), {}, false};
  for (std::size_t k = 0; k < way.size(); ++k) path.u.col(static_cast<Index>(k)) = way[k];
  if (!std::isfinite(PathEnergy(problem, 1).cost(path)))
    throw InitializationError("eikonal: " + lattice_in_words(field.lattice()) +
                              ": the path found crosses places with infinite cost between the nodes. Use more cells");
  return path;
}

/// Whether points on the path, as many as a run has by default, keep clear of places without a cost.
bool can_be_sampled(const Problem& problem, const CoordinatePath& path) {
  constexpr int kPoints = 64;
  return static_cast<bool>(try_sampling(problem, path, kPoints));
}

struct Found {
  CoordinatePath path;
  std::string lattice;
  bool has_gaps = false, is_carried = false;
};

/// Cost of a path in many pieces: that of a long move may be far from that of the curve.
double cost_in_pieces(const Problem& problem, const CoordinatePath& path) {
  constexpr Index kPieces = 256;
  const Index moves = path.u.cols() - 1, each = std::max<Index>(1, kPieces / moves);
  CoordinatePath fine{Points(path.u.rows(), moves * each + 1), {}, false};
  for (Index i = 0; i < moves; ++i)
    for (Index k = 0; k < each; ++k)
      fine.u.col(i * each + k) = path.u.col(i) + double(k) / double(each) * (path.u.col(i + 1) - path.u.col(i));
  fine.u.rightCols<1>() = path.u.rightCols<1>();
  return PathEnergy(problem, 1).cost(fine);
}

FirstPath straight_line(const Problem& problem, const Monitor& monitor) {
  return StraightInitializer().first_path(problem, monitor);
}

/// What else finds a way; throws `error` where there is nothing.
FirstPath among_obstacles(const Problem& problem, const Monitor& monitor, const InitializationError& error) {
  if (const auto* graph = find_ability<HasGraph>(*problem.manifold)) return graph->least_cost_edges(problem, monitor);
  if (find_ability<HasChart>(*problem.manifold) != nullptr) throw error;
  return GridInitializer().first_path(problem, monitor);
}

}  // namespace

void EikonalOptions::fields(FieldVisitor& visit) {
  visit.field("cells", cells,
              {.help = "Number of cells along the longest side of the box. Default: as in the cost raster, or a "
                       "multiple, limited so that the field takes a fraction of a second; 100 without a raster.",
               .minimum = kFewestCells,
               .maximum = kMostCells});
  visit.field("lower", lower,
              {.help = "Lower corner of the searched box of coordinates. Default: that of the domain; if it has none, "
                       "a box around the ends with their distance as margin."});
  visit.field("upper", upper, {.help = "Upper corner of that box."});
  visit.field(
      "fallback", fallback,
      {.help = "If no path is found, use the straight line, or, among obstacles, a grid in the plane or the edges of "
               "the domain. Without obstacles, also use the line if it costs no more. On if eikonal is the default."});
}

EikonalInitializer::EikonalInitializer(const EikonalOptions& options) : options_(checked(options)) {
  if (options.cells && (*options.cells < kFewestCells || *options.cells > kMostCells))
    throw OptionError("cells", "must be from " + std::to_string(kFewestCells) + " to " + std::to_string(kMostCells));
}

FirstPath EikonalInitializer::first_path(const Problem& problem, const Monitor& monitor) const {
  if (!options_.fallback) return down_the_field(problem, monitor);
  // Where moves cost nothing in some places every field leads by them: a path that keeps away is another answer.
  if (const auto* free = find_ability<HasFreePlaces>(*problem.cost); free != nullptr && free->present())
    return straight_line(problem, monitor);
  const bool obstacles = MoveCheck(problem).among_obstacles();
  FirstPath first;
  try {
    first = down_the_field(problem, monitor);
  } catch (const InitializationError& error) {
    FirstPath other = obstacles ? among_obstacles(problem, monitor, error) : straight_line(problem, monitor);
    other.notes.insert(other.notes.begin(), error.what());
    return other;
  }
  if (obstacles) return first;
  try {
    FirstPath line = straight_line(problem, monitor);
    if (cost_in_pieces(problem, line.path) <= cost_in_pieces(problem, first.path)) return line;
  } catch (const InitializationError&) {  // there is a path
  }
  return first;
}

FirstPath EikonalInitializer::down_the_field(const Problem& problem, const Monitor& monitor) const {
  if (problem.ring) throw InitializationError("eikonal: a ring has no ends to join: give waypoints");
  const ConstraintManifold& domain = *problem.manifold;
  if (domain.dimensions().coordinate != 2 || domain.shape() == Shape::polyhedral)
    throw InitializationError(
        "eikonal needs points with two coordinates (the plane, charts, terrain); on a mesh or a cloud use dijkstra, "
        "elsewhere rrt");
  const MoveCheck moves(problem);
  LatticeBox box = LatticeBox::of(problem, options_.lower, options_.upper);
  close_by_raster(box, problem);
  for (const PathEnd* end : {&problem.source, &problem.target})
    if ((end->u.array() < box.lower.array()).any() || (end->u.array() > box.upper.array()).any())
      throw InitializationError("eikonal: an end is outside the searched box: widen lower and upper");
  const int cells = options_.cells.value_or(cells_for(box, problem, moves.among_obstacles()));
  const auto search = [&](int count, const ArrivalField::Way& how) {
    const ArrivalField field(problem, moves, box, count, how, [&monitor] { return monitor.interrupted(); });
    return Found{way_of(field, problem), "eikonal: " + lattice_in_words(field.lattice()), field.has_gaps(),
                 field.is_carried()};
  };
  // The field of line elements may miss what lies between its nodes, and where a current leaves few directions its
  // fixed ones are too few: then each move is asked for, on fewer cells.
  std::optional<Found> quick;
  try {
    quick = search(cells, {});
  } catch (const InitializationError&) {
  }
  Found found = quick && !quick->is_carried ? std::move(*quick)
                                            : search(std::min(cells, options_.cells.value_or(kCells)), {.exact = true});
  // Points sampled on the way cut its corners: further off places without a cost they may.
  for (int margin = 1; found.has_gaps && margin <= kMostMargin && !can_be_sampled(problem, found.path); margin *= 2) {
    try {
      Found wider = search(cells, {.margin = margin});
      if (can_be_sampled(problem, wider.path)) found = std::move(wider);
    } catch (const InitializationError&) {  // too narrow
    }
  }
  FirstPath first;
  first.notes.push_back(found.lattice);
  first.path = std::move(found.path);
  pin_ends(problem, first.path);
  return first;
}

}  // namespace leastcost
