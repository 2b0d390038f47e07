// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/eikonal.hpp>

#include <sstream>
#include <string>
#include <vector>

#include <leastcost/framework/errors.hpp>
#include "problems/initializers/arrival_field.hpp"
#include "problems/initializers/grid_search.hpp"
#include "problems/initializers/lattice_box.hpp"

namespace leastcost {
namespace {

constexpr int kFewestCells = 4, kMostCells = 2000;

std::string lattice_in_words(const Lattice& lattice) {
  std::ostringstream out;
  out << lattice.count[0] - 1 << " x " << lattice.count[1] - 1 << " cells";
  return out.str();
}

}  // namespace

void EikonalOptions::fields(FieldVisitor& visit) {
  visit.field("cells", cells,
              {.help = "Cells along the longest side of the box.", .minimum = kFewestCells, .maximum = kMostCells});
  visit.field(
      "lower", lower,
      {.help = "Lower corner of the box of coordinates that is searched; default: that of the domain, and where "
               "it has none the ends with as much around them as they are apart."});
  visit.field("upper", upper, {.help = "Upper corner of that box."});
}

EikonalInitializer::EikonalInitializer(const EikonalOptions& options) : options_(options) {
  if (options.cells < kFewestCells || options.cells > kMostCells)
    throw OptionError("cells", "must be from " + std::to_string(kFewestCells) + " to " + std::to_string(kMostCells));
}

FirstPath EikonalInitializer::first_path(const Problem& problem, const Monitor& monitor) const {
  if (problem.ring) throw InitializationError("eikonal: a ring has no ends to join: give waypoints");
  const ConstraintManifold& domain = *problem.manifold;
  if (domain.dimensions().coordinate != 2 || domain.shape() == Shape::polyhedral)
    throw InitializationError(
        "eikonal works where two coordinates name a point: the plane, charts, terrain; on a mesh or a cloud use "
        "dijkstra, elsewhere rrt");
  const MoveCheck moves(problem);
  const LatticeBox box = LatticeBox::of(problem, options_.lower, options_.upper);
  for (const PathEnd* end : {&problem.source, &problem.target})
    if ((end->u.array() < box.lower.array()).any() || (end->u.array() > box.upper.array()).any())
      throw InitializationError("eikonal: an end lies outside the box that is searched: widen lower and upper");
  const ArrivalField field(problem, moves, box, options_.cells, [&monitor] { return monitor.interrupted(); });
  const std::string lattice = "eikonal: " + lattice_in_words(field.lattice());
  if (!field.arrival_cost())
    throw InitializationError(lattice +
                              ": no way arrives at the target. More cells may find a narrower one, a wider box "
                              "(lower, upper) one around");
  const std::vector<Eigen::Vector2d> way = field.way();
  FirstPath first;
  first.notes.push_back(lattice);
  first.path.u.resize(2, static_cast<Index>(way.size()));
  for (std::size_t k = 0; k < way.size(); ++k) first.path.u.col(static_cast<Index>(k)) = way[k];
  pin_ends(problem, first.path);
  return first;
}

}  // namespace leastcost
