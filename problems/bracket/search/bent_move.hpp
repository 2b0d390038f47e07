// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "problems/bracket/grid.hpp"

namespace leastcost::bracket {

/// Near an end in the plane, where the cost depends on the direction: of a move with a bend in its middle, which is
/// moved aside to where it costs least; a parabola saves 4 / 3 of what such a move saves. `element`: F(x, v).
template <class End, class Element>
double bent_move_cost(const End& end, const Grid<2>& grid, const Eigen::Vector2d& x, const Element& element) {
  using Eigen::Vector2d;
  const Vector2d d = x - end.place;
  if (d[0] == 0 && d[1] == 0) return 0;
  constexpr double kAside = 0.05, kParabola = 4.0 / 3;
  const double sign = end.reversed ? -1 : 1;
  const auto move = [&](const Vector2d& a, const Vector2d& b) {
    const Vector2d along = sign * (b - a);
    const auto at = [&](double t) { return element(grid.in_box(a + t * (b - a)), along); };
    return (at(0) + 4 * at(0.5) + at(1)) / 6;
  };
  const Vector2d there = end.place + d, aside(-kAside * d[1], kAside * d[0]);
  const auto over = [&](double s) {
    const Vector2d middle = end.place + 0.5 * d + s * aside;
    return move(end.place, middle) + move(middle, there);
  };
  const double straight = over(0), left = over(1), right = over(-1);
  const double bend = left + right - 2 * straight, saved = (left - right) * (left - right) / (8 * bend);
  return bend > 0 && saved < 0.5 * straight ? straight - kParabola * saved : straight;
}

}  // namespace leastcost::bracket
