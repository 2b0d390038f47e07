// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/plane/sampled_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "problems/bracket/plane/sampled_norms.hpp"
#include "problems/bracket/plane/spline_check.hpp"

namespace leastcost::bracket {
namespace {

/// Of a cell, from its middle, in units of its side.
constexpr std::array<std::array<double, 2>, 4> kQuarters = {
    {{-0.25, -0.25}, {0.25, -0.25}, {-0.25, 0.25}, {0.25, 0.25}}};

/// Slope of a biquadratic spline on the cell of a node.
Eigen::Vector2d slope_at(const std::vector<double>& u, int stride, std::size_t node, double a, double b, double h) {
  const auto weights = [](double t) {
    return std::array<double, 3>{0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t)};
  };
  const auto slopes = [](double t) { return std::array<double, 3>{t - 0.5, -2 * t, t + 0.5}; };
  const std::array<double, 3> wx = weights(a), wy = weights(b), sx = slopes(a), sy = slopes(b);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t q = 0; q < 3; ++q)
    for (std::size_t p = 0; p < 3; ++p) {
      const double value = u[node + q * static_cast<std::size_t>(stride) + p - static_cast<std::size_t>(stride) - 1];
      sum += value * Eigen::Vector2d(sx[p] * wy[q], wx[p] * sy[q]);
    }
  return sum / h;
}

}  // namespace

SampledCells::SampledCells(const CoordinateCost& cost, const CellGrid& grid, const std::vector<int>& cells)
    : cost_(&cost) {
  Eigen::Matrix2Xd u(2, kPlaces * static_cast<Index>(cells.size()));
  Index column = 0;
  for (const int node : cells)
    for (const auto& [a, b] : kQuarters)
      u.col(column++) = grid.in_box(grid.node(grid.column(node), grid.row(node)) + grid.h * Eigen::Vector2d(a, b));
  places_ = cost.places(u);
}

double SampledCells::ratio(const CellGrid& grid, const std::vector<double>& u, std::size_t node, std::size_t k,
                           double sign, const BlockedParts& blocked) const {
  CoordinateCost::Element element(*cost_);
  double worst = 0;
  for (std::size_t i = 0; i < kQuarters.size(); ++i) {
    const bool right = kQuarters[i][0] > 0, upper = kQuarters[i][1] > 0;
    if (blocked.holds(CellPart{}.half(right, upper))) continue;
    element.move_to(places_.middleCols<3>(3 * static_cast<Index>(kPlaces * k + i)));
    if (!element.is_inside()) continue;  // no path is there
    const Eigen::Vector2d p = sign * slope_at(u, grid.stride(), node, kQuarters[i][0], kQuarters[i][1], grid.h);
    const double here = p.allFinite() ? dual_norm(element, p, std::atan2(p[1], p[0])) : kInfinity;
    worst = larger_or_nan(worst, here);
  }
  return worst;
}

}  // namespace leastcost::bracket
