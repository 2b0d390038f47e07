// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/field_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include "framework/base/point_text.hpp"
#include "framework/base/sound_size.hpp"
#include "problems/cells/has_cost_cells.hpp"
#include "problems/raster/has_cell_index.hpp"

namespace leastcost {

using Eigen::Vector2d;

std::optional<RasterPlaces> raster_places_of(const SegmentCost& cost) {
  if (const auto* raster = find_ability<HasCellIndex>(cost)) {
    const RasterPatches& patches = raster->patches();
    return RasterPlaces{patches.lower(), patches.cell(), patches.upper(), patches.lower(), patches.upper()};
  }
  if (const auto* cells = find_ability<HasCostCells>(cost)) {
    const CellMap& map = cells->cell_map();
    if (map.empty()) return std::nullopt;
    const Vector2d lower(map.line(0, 0), map.line(1, 0)), upper(map.line(0, map.columns()), map.line(1, map.rows()));
    const Vector2d cell = (upper - lower).cwiseQuotient(Vector2d(map.columns(), map.rows()));
    return RasterPlaces{lower + cell / 2, cell, upper - cell / 2, lower, upper};
  }
  return std::nullopt;
}

LatticeBox field_box(const Problem& problem, const std::optional<RasterPlaces>& raster, const ChartBox& chart) {
  if (!raster && chart.complete()) return {chart.lower, chart.upper, {}, {}};
  const auto* domain = find_ability<HasBox>(*problem.manifold);
  const bool boxed = domain != nullptr && domain->box_lower().allFinite() && domain->box_upper().allFinite() &&
                     domain->box_lower().size() > 0 && domain->box_upper().size() > 0;
  if (!raster && !boxed && problem.source.u == problem.target.u)
    throw InputError(
        "field: the domain has no box, and one place alone gives none: give the manifold lower and upper, or name a "
        "second place (--to X,Y, or ends)");
  if (!raster) {
    LatticeBox box = LatticeBox::of(problem, {}, {});
    for (Eigen::Index c = 0; c < box.lower.size() && c < 2; ++c) {
      if (std::isfinite(chart.lower[c])) box.lower[c] = chart.lower[c];
      if (std::isfinite(chart.upper[c])) box.upper[c] = chart.upper[c];
    }
    return box;
  }
  LatticeBox box{raster->lower, raster->upper, {}, {}};
  if (domain != nullptr && domain->box_lower().size() > 0) box.lower = box.lower.cwiseMax(domain->box_lower());
  if (domain != nullptr && domain->box_upper().size() > 0) box.upper = box.upper.cwiseMin(domain->box_upper());
  if (!(box.lower.array() < box.upper.array()).all())
    throw InputError("field: the domain and the raster of costs do not meet");
  return box;
}

void check_extent(const LatticeBox& box) {
  constexpr double kMost = 1e100;  // whose square is a number
  const Eigen::VectorXd size = box.upper - box.lower;
  if (size.maxCoeff() > 0 && size.maxCoeff() < 1)
    check_sound_size("field: the longest side of the box", size.maxCoeff());
  if ((size.array() > 0).all() && size.maxCoeff() < kMost) return;
  throw InputError("field: the box from " + point_text(box.lower) + " to " + point_text(box.upper) +
                   (size.maxCoeff() < kMost ? " has no extent" : " is too large"));
}

double cells_to_edge(double side, double& step) {
  constexpr double kRounding = 1e-6;  // a side of 8 steps has 8 of them
  const double cells = std::max(1.0, std::ceil(side / step - kRounding));
  if (std::abs(cells * step - side) > kRounding * side) step = side / cells;
  return cells;
}

void check_resolution(const std::optional<double>& resolution, const Eigen::VectorXd& size) {
  constexpr double kRounding = 1e-6;
  if (!resolution) return;
  if (!(*resolution > 0) || !std::isfinite(*resolution)) throw OptionError("resolution", "must be a number above 0");
  const double longest = size.minCoeff() / kFewestCells;
  if (*resolution > longest * (1 + kRounding))
    throw OptionError("resolution", "is " + short_number(*resolution, 6) + ", but the shortest side of the box is " +
                                        short_number(size.minCoeff(), 6) + " long: choose at most a quarter of it, " +
                                        short_number(longest, 6));
}

IsotropicMarch::Lattice field_lattice(const LatticeBox& box, const std::optional<RasterPlaces>& raster,
                                      const std::optional<double>& resolution, bool equal_steps) {
  constexpr double kCells = 200, kRounding = 1e-6;
  constexpr double kMostFieldNodes = 5e7;  // 24 bytes each while the front runs
  IsotropicMarch::Lattice lattice{};
  const Vector2d size = box.upper - box.lower;
  check_extent(box);
  check_resolution(resolution, size);
  for (std::size_t d = 0; d < 2; ++d) {
    const auto k = static_cast<Eigen::Index>(d);
    double cells = 0;
    if (raster && !resolution) {
      const double cell = raster->cell[k];
      const double skipped = std::max(std::ceil((box.lower[k] - raster->first[k]) / cell - kRounding), 0.0);
      lattice.lower[k] = raster->first[k] + skipped * cell;
      lattice.step[k] = cell;
      cells = std::floor((std::min(box.upper[k], raster->last[k]) - lattice.lower[k]) / cell + kRounding);
    } else {
      double step = resolution ? *resolution : std::min(size.maxCoeff() / kCells, size[k] / kFewestCells);
      cells = equal_steps ? std::floor(size[k] / step + kRounding) : cells_to_edge(size[k], step);
      lattice.lower[k] = box.lower[k];
      lattice.step[k] = step;
    }
    if (!(cells >= 1))
      throw InputError(
          "field: the box has fewer than two values of the raster along a side: choose a resolution (--resolution), "
          "for "
          "nodes between them");
    if (!(cells < kMostFieldNodes)) cells = kMostFieldNodes;
    lattice.count[d] = static_cast<std::int32_t>(cells) + 1;
  }
  if (double(lattice.count[0]) * lattice.count[1] > kMostFieldNodes)
    throw OptionError("resolution", "gives more than 50 million nodes: choose a larger one");
  return lattice;
}

}  // namespace leastcost
