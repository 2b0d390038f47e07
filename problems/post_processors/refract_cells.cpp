// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/refract_cells.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "framework/domain/in_parts.hpp"
#include "problems/cells/beside_sides.hpp"
#include "problems/cells/cell_refraction.hpp"
#include "problems/cells/has_cost_cells.hpp"
#include "problems/post_processors/refracted_curve.hpp"

namespace leastcost {
namespace {

void deliver_in_cells(const CellMap& map, const RefractedCellPath& found, PostProcessed& current) {
  const CellPath path = beside_sides(map, found.path);
  const Index places = static_cast<Index>(path.size());
  Points x(2, places);
  Eigen::VectorXd legs(places - 1);
  for (Index i = 0; i < places; ++i) x.col(i) = path[static_cast<std::size_t>(i)];
  for (Index i = 0; i + 1 < places; ++i) legs[i] = map.leg(x.col(i), x.col(i + 1)).value().cost;
  current.curve = {};
  current.curve.x = x;
  current.curve.cost = legs.sum();
  current.chain.u = spaced_by_cost(x, legs, current.chain.u.cols(), current.curve_costs);
  current.curve.least_of_class = std::min(found.least, current.curve.cost);
  double worst = 0;
  for (const Crossing& crossing : measure_cell_crossings(map, onto_sides(map, x)))
    worst = std::max(worst, crossing.mismatch - crossing.rounding);
  current.curve.straightness = -worst;
}

}  // namespace

PostProcessed RefractCellsPostProcessor::apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                                               const Monitor& monitor) const {
  const CellMap map = cells_of(problem, "refract_cells");
  const auto look = [&monitor] { look_at_clock(monitor.deadline); };
  std::optional<RefractedCellPath> best;
  for (const Points& polyline : {first.path.u, current.chain.u}) {
    if (polyline.cols() < 2) continue;
    const CellPath path = cut_at_sides(map, polyline);
    if (!std::isfinite(cost_of(map, path))) continue;
    RefractedCellPath found = refract_in_cells(map, path, look);
    if (!best || found.cost < best->cost) best = std::move(found);
  }
  if (!best) {
    current.notes.emplace_back("refract_cells: the first path crosses cells without data; the chain is kept");
    return current;
  }
  deliver_in_cells(map, *best, current);
  if (!best->finished) current.notes.emplace_back("refract_cells: stopped before every corner was on its cheaper side");
  return current;
}

}  // namespace leastcost
