// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cells/has_cost_cells.hpp"

#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/domain/has_box.hpp>

namespace leastcost {

CellMap cells_in_box(const HasCostCells& cost, const ConstraintManifold& domain) {
  const auto* box = find_ability<HasBox>(domain);
  if (box == nullptr) return cost.cell_map();
  return cost.cell_map().within({Eigen::Vector2d(box->box_lower()), Eigen::Vector2d(box->box_upper())});
}

std::string why_no_cells(const Problem& problem) {
  if (find_ability<HasCostCells>(*problem.cost) == nullptr)
    return "needs a cost map that is constant in each cell (interpolation: cells)";
  if (problem.ring || problem.based) return "joins two ends, but this path is a ring";
  const ConstraintManifold& domain = *problem.manifold;
  const Dimensions d = domain.dimensions();
  if (domain.shape() != Shape::flat || d.coordinate != 2 || d.ambient != 2 || d.tangent != 2 ||
      find_ability<HasChart>(domain) != nullptr || find_ability<ChecksMoves>(domain) != nullptr)
    return "needs the plane, or a box in it, without obstacles";
  return "";
}

CellMap cells_of(const Problem& problem, const std::string& who) {
  if (const std::string why = why_no_cells(problem); !why.empty()) throw InputError(who + " " + why);
  const auto* cost = find_ability<HasCostCells>(*problem.cost);
  const ConstraintManifold& domain = *problem.manifold;
  CellMap map = cells_in_box(*cost, domain);
  for (const PathEnd* end : {&problem.source, &problem.target})
    if (const std::string why = map.why_no_end(end->u); !why.empty())
      throw InputError(std::string("the ") + (end == &problem.source ? "source " : "target ") + why);
  return map;
}

}  // namespace leastcost
