// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/grid.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include "problems/fields/grid_search.hpp"
#include "problems/fields/lattice_box.hpp"
#include "problems/section/projected_line.hpp"

namespace leastcost {
namespace {

using Vector = Eigen::VectorXd;

constexpr double kMostNodes = 1 << 22;  ///< of a grid that is searched

void check_domain(const Problem& problem) {
  if (problem.ring) throw InitializationError("grid: a ring has no ends to join: give waypoints");
  const ConstraintManifold& domain = *problem.manifold;
  const Dimensions d = domain.dimensions();
  const bool all = d.coordinate == d.ambient && d.tangent == d.ambient;
  if (!all || d.ambient < 2 || d.ambient > 3 || find_ability<HasChart>(domain) != nullptr ||
      domain.shape() == Shape::polyhedral)
    throw InitializationError(
        "grid works in the plane and in space; on a mesh, a cloud or a map use dijkstra, elsewhere rrt");
}

std::string cells_in_words(const GridSearch& grid) {
  std::ostringstream out;
  out.precision(4);
  const auto& [x, y, z] = grid.lattice().count;
  out << x << " x " << y;
  if (z > 1) out << " x " << z;
  out << " cells of " << grid.resolution();
  return out.str();
}

double most_cells(const LatticeBox& box, double resolution) {
  return ((box.upper - box.lower) / resolution).cwiseMax(1.0).prod();
}

}  // namespace

void GridOptions::fields(FieldVisitor& visit) {
  visit.field(
      "resolution", resolution,
      {.help = "Side length of a cell of the first grid; default: 1/64 of the longest side of the box, in space 1/32.",
       .unit = "length",
       .minimum = 0,
       .exclusive_minimum = true});
  visit.field("lower", lower,
              {.help = "Lower corner of the searched box. Default: that of the domain; if it has none, a box around "
                       "the ends with their distance as margin.",
               .unit = "length"});
  visit.field("upper", upper, {.help = "Upper corner of that box.", .unit = "length"});
  visit.field("refinements", refinements,
              {.help = "How often the cells are halved if the grid has no passage.", .minimum = 0, .maximum = 20});
  visit.field("shortcuts", shortcuts, {.help = "Removes points of the route that a straight move can skip."});
  visit.field("trees", trees, {.help = "If no grid has a passage, random trees search for one, as in rrt."});
}

GridInitializer::GridInitializer(const GridOptions& options) : options_(checked(options)) {
  if (options.lower && !options.lower->allFinite()) throw OptionError("lower", "must be finite");
  if (options.upper && !options.upper->allFinite()) throw OptionError("upper", "must be finite");
}

FirstPath GridInitializer::first_path(const Problem& problem, const Monitor& monitor) const {
  constexpr double kCellsInPlane = 64, kCellsInSpace = 32;  // along the longest side
  check_domain(problem);
  const MoveCheck moves(problem);
  LatticeBox box = LatticeBox::of(problem, options_.lower, options_.upper);
  const double cells = problem.source.u.size() == 2 ? kCellsInPlane : kCellsInSpace;
  double resolution = options_.resolution.value_or((box.upper - box.lower).maxCoeff() / cells);
  std::string tried;
  for (int k = 0; k <= options_.refinements; ++k, resolution /= 2, box.widen()) {
    if (most_cells(box, resolution) > kMostNodes) {
      tried += "; a finer grid would have more than " + std::to_string(static_cast<long>(kMostNodes)) + " cells";
      break;
    }
    const GridSearch grid(problem, moves, box.lower, box.upper, resolution);
    tried += (k == 0 ? "" : ", ") + cells_in_words(grid);
    std::vector<Vector> route = grid.route(monitor);
    if (route.empty()) continue;
    FirstPath first;
    first.notes.push_back("grid: " + cells_in_words(grid));
    if (options_.shortcuts) route = with_shortcuts(route, moves, 2 * resolution, monitor);
    first.path = as_open_path(route);
    pin_ends(problem, first.path);
    return first;
  }
  const std::string none = "grid: no passage at this resolution: " + tried;
  if (!options_.trees)
    throw InitializationError(none + ". Use a smaller resolution, or more refinements, to find a narrower one");
  try {
    FirstPath first = RrtInitializer().first_path(problem, monitor);
    first.notes.insert(first.notes.begin(), none);
    return first;
  } catch (const InitializationError& error) {
    throw InitializationError(none + "; " + error.what());
  }
}

}  // namespace leastcost
