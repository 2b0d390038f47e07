// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "problems/bracket/space/node_set.hpp"

namespace leastcost::bracket {

/// Bernstein coefficients of a function on a cubic cell, of degree two along each axis; x runs fastest, then y.
using CubeNet = std::array<double, 27>;
inline constexpr std::array<std::size_t, 3> kNetStep = {1, 3, 9};  ///< to the next coefficient along an axis

/// Calls f with the first of each three coefficients that lie along an axis.
template <class F>
void for_lines(std::size_t axis, const F& f) {
  const std::size_t one = kNetStep[axis == 0 ? 1 : 0], other = kNetStep[axis == 2 ? 1 : 2];
  for (std::size_t q = 0; q < 3; ++q)
    for (std::size_t p = 0; p < 3; ++p) f(p * one + q * other);
}

/// Along an axis from coefficients of the spline to those of Bernstein: averages at the ends.
inline CubeNet averaged(CubeNet net, std::size_t axis) {
  const std::size_t step = kNetStep[axis];
  for_lines(axis, [&](std::size_t at) {
    const double middle = net[at + step];
    net[at] = 0.5 * (net[at] + middle);
    net[at + 2 * step] = 0.5 * (middle + net[at + 2 * step]);
  });
  return net;
}

/// The derivative along an axis of a spline, times the side of the cell, its degree raised to two.
inline CubeNet differenced(CubeNet net, std::size_t axis) {
  const std::size_t step = kNetStep[axis];
  for_lines(axis, [&](std::size_t at) {
    const double left = net[at + step] - net[at], right = net[at + 2 * step] - net[at + step];
    net[at] = left;
    net[at + step] = 0.5 * (left + right);
    net[at + 2 * step] = right;
  });
  return net;
}

/// The net on the lower or the upper half of the cell along an axis.
inline CubeNet half_of(CubeNet net, std::size_t axis, bool upper) {
  const std::size_t step = kNetStep[axis];
  for_lines(axis, [&](std::size_t at) {
    double &a = net[at], &b = net[at + step], &c = net[at + 2 * step];
    const double l = 0.5 * (a + b), r = 0.5 * (b + c), m = 0.5 * (l + r);
    if (upper) {
      a = m, b = r;
    } else {
      b = l, c = m;
    }
  });
  return net;
}

/// The 27 numbers of `u` at and around an inner node.
inline CubeNet around(const NodeSet& nodes, const std::vector<double>& u, int node) {
  assert(nodes.is_inner(node));
  CubeNet out;
  std::size_t k = 0;
  for (const int row : nodes.rows_around(node))
    for (int p = -1; p <= 1; ++p) out[k++] = u[static_cast<std::size_t>(row + p)];
  return out;
}

/// The largest size of a coefficient; NaN where one of them is.
inline double largest_of(const CubeNet& net) {
  double largest = 0;
  for (const double value : net) largest = larger_or_nan(largest, std::abs(value));
  return largest;
}

/// The net of the triquadratic spline with these coefficients. Three averages away from rounding.
inline CubeNet value_net(const CubeNet& coefficients) { return averaged(averaged(averaged(coefficients, 0), 1), 2); }

/// The spline with these coefficients at a place of the cell, from -1/2 to 1/2 in units of its side. S: double,
/// Interval or Dual.
template <class S>
S spline_value(const CubeNet& coefficients, const std::array<S, 3>& at) {
  std::array<std::array<S, 3>, 3> w;
  for (std::size_t k = 0; k < 3; ++k) {
    const S left = S(0.5) - at[k], right = S(0.5) + at[k];
    w[k] = {S(0.5) * left * left, S(0.75) - at[k] * at[k], S(0.5) * right * right};
  }
  S sum(0.0);
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t q = 0; q < 3; ++q) {
      S row(0.0);
      for (std::size_t p = 0; p < 3; ++p) row = row + w[0][p] * S(coefficients[p + 3 * q + 9 * r]);
      sum = sum + w[1][q] * w[2][r] * row;
    }
  return sum;
}

}  // namespace leastcost::bracket
