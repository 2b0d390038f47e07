// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/cells/sampled_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "problems/bracket/cells/sampled_norms.hpp"

namespace leastcost::bracket {
namespace {

/// Of a cell, from its middle, in units of its side.
constexpr std::array<std::array<double, 2>, 4> kQuarters = {
    {{-0.25, -0.25}, {0.25, -0.25}, {-0.25, 0.25}, {0.25, 0.25}}};

/// Slope of a biquadratic spline at a place of its cell.
Eigen::Vector2d slope_at(const Net<2>& u, double a, double b, double h) {
  const auto weights = [](double t) {
    return std::array<double, 3>{0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t)};
  };
  const auto slopes = [](double t) { return std::array<double, 3>{t - 0.5, -2 * t, t + 0.5}; };
  const std::array<double, 3> wx = weights(a), wy = weights(b), sx = slopes(a), sy = slopes(b);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t q = 0; q < 3; ++q)
    for (std::size_t p = 0; p < 3; ++p) sum += u[3 * q + p] * Eigen::Vector2d(sx[p] * wy[q], wx[p] * sy[q]);
  return sum / h;
}

}  // namespace

SampledCells::SampledCells(const CoordinateCost& cost, const Grid<2>& grid, const AllNodes& nodes,
                           const std::vector<int>& cells)
    : cost_(&cost) {
  Eigen::Matrix2Xd u(2, kPlaces * static_cast<Index>(cells.size()));
  Index column = 0;
  for (const int node : cells)
    for (const auto& [a, b] : kQuarters)
      u.col(column++) = grid.in_box(grid.node(nodes.place(node)) + grid.h * Eigen::Vector2d(a, b));
  places_ = cost.places(u);
}

double SampledCells::ratio(const Net<2>& coefficients, double h, std::size_t k, double sign,
                           const BlockedParts& blocked) const {
  CoordinateCost::Element element(*cost_);
  double worst = 0;
  for (std::size_t i = 0; i < kQuarters.size(); ++i) {
    const int right = kQuarters[i][0] > 0 ? 1 : 0, upper = kQuarters[i][1] > 0 ? 1 : 0;
    if (blocked.holds(CellPart<2>{}.half({right, upper}))) continue;
    element.move_to(places_.middleCols<3>(3 * static_cast<Index>(kPlaces * k + i)));
    if (!element.is_inside()) continue;  // no path is there
    const Eigen::Vector2d p = sign * slope_at(coefficients, kQuarters[i][0], kQuarters[i][1], h);
    const double here = p.allFinite() ? dual_norm(element, p, std::atan2(p[1], p[0])) : kInfinity;
    worst = larger_or_nan(worst, here);
  }
  return worst;
}

}  // namespace leastcost::bracket
