// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <leastcost/framework/numbers/interval.hpp>
#include <leastcost/problems/bracket/cost_density.hpp>
#include "problems/bracket/cell_grid.hpp"
#include "problems/bracket/net.hpp"
#include "problems/bracket/plane/blocked_parts.hpp"

namespace leastcost::bracket {

/// The net of a polynomial that is nowhere above the density in the part of the cell that lies in the box. -infinity
/// where nothing is known.
Net density_floor(const CostDensity& density, const CellGrid& grid, int i, int j);

/// The net of a biquadratic spline, whose coefficients are numbers at the nodes, on the cell of `node`. One average
/// away from rounding.
Net value_net(const std::vector<double>& u, int stride, std::size_t node);

/// What proves |grad u| <= ratio n on a cell: control vectors of the gradient, all of which lie within `ratio` times
/// the net of a function below n. Mutations of the rules are what tests call with other numbers.
struct CheckRules {
  double rounding = 1;   ///< times what rounding may have done to a control vector
  unsigned dropped = 0;  ///< control vectors that are not looked at, a bit each: none
  int halvings = 2;      ///< of a cell whose control vectors are too long as they are
};

/// The least ratio that is proved for the spline u on the cell of `node`, where a path may be in it; infinite where
/// nothing is. `largest`: of |u|.
double proved_ratio(const std::vector<double>& u, int stride, std::size_t node, double h, double largest,
                    const Net& floor, const CheckRules& rules = {}, const BlockedParts& blocked = {});

/// The spline at the place (a, b) of a cell, from -1/2 to 1/2 in units of its side. S: double or Interval.
template <class S>
S spline_value(const std::vector<double>& u, int stride, std::size_t node, const S& a, const S& b) {
  const auto weights = [](const S& t) {
    const S left = S(0.5) - t, right = S(0.5) + t;
    return std::array<S, 3>{S(0.5) * left * left, S(0.75) - t * t, S(0.5) * right * right};
  };
  const std::array<S, 3> wx = weights(a), wy = weights(b);
  S sum(0.0);
  for (int q = -1; q <= 1; ++q)
    for (int p = -1; p <= 1; ++p) {
      const auto at = static_cast<std::size_t>(static_cast<long>(node) + q * stride + p);
      sum = sum + wx[static_cast<std::size_t>(p + 1)] * wy[static_cast<std::size_t>(q + 1)] * S(u[at]);
    }
  return sum;
}

}  // namespace leastcost::bracket
