// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <leastcost/framework/numbers/interval.hpp>
#include "problems/bracket/net.hpp"

namespace leastcost::bracket {

/// Number within an interval, and what the interval adds to it.
struct Ball {
  double middle, radius;
  explicit Ball(const Interval& x) : middle(x.middle()), radius(std::max(x.hi - middle, middle - x.lo) * (1 + kEps)) {}
};

/// The gradient of the spline on a cell, times its side.
inline void gradient_nets(const std::vector<double>& u, int stride, std::size_t node, Net& gx, Net& gy) {
  Net dx, dy;  // differences; the degree raised to two
  const auto at = [&](int p, int q) { return u[static_cast<std::size_t>(static_cast<long>(node) + q * stride + p)]; };
  for (int q = 0; q < 3; ++q) {
    const double left = at(0, q - 1) - at(-1, q - 1), right = at(1, q - 1) - at(0, q - 1);
    dx[static_cast<std::size_t>(q)] = {left, 0.5 * (left + right), right};
  }
  for (std::size_t p = 0; p < 3; ++p) {
    const int i = static_cast<int>(p) - 1;
    const double low = at(i, 0) - at(i, -1), high = at(i, 1) - at(i, 0);
    dy[0][p] = low, dy[1][p] = 0.5 * (low + high), dy[2][p] = high;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    gx[0][k] = 0.5 * (dx[0][k] + dx[1][k]), gx[1][k] = dx[1][k], gx[2][k] = 0.5 * (dx[1][k] + dx[2][k]);
    gy[k][0] = 0.5 * (dy[k][0] + dy[k][1]), gy[k][1] = dy[k][1], gy[k][2] = 0.5 * (dy[k][1] + dy[k][2]);
  }
}

/// The net on the left or the right half of the cell.
inline Net half_of_columns(const Net& net, bool right) {
  Net out;
  for (std::size_t q = 0; q < 3; ++q) {
    const std::array<double, 3>& row = net[q];
    const double l = 0.5 * (row[0] + row[1]), r = 0.5 * (row[1] + row[2]), m = 0.5 * (l + r);
    out[q] = right ? std::array<double, 3>{m, r, row[2]} : std::array<double, 3>{row[0], l, m};
  }
  return out;
}

/// The net on the lower or the upper half of the cell.
inline Net half_of_rows(const Net& net, bool upper) {
  Net out = net;
  for (std::size_t k = 0; k < 3; ++k) {
    const double l = 0.5 * (net[0][k] + net[1][k]), r = 0.5 * (net[1][k] + net[2][k]), m = 0.5 * (l + r);
    out[0][k] = upper ? m : net[0][k];
    out[1][k] = upper ? r : l;
    out[2][k] = upper ? net[2][k] : m;
  }
  return out;
}

}  // namespace leastcost::bracket
