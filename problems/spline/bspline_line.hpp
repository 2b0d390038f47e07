// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace leastcost {

/// Fewest values of a line that a cubic spline goes through: its ends take their slopes from four of them.
inline constexpr int kFewestOfSpline = 4;

/// B-spline coefficients c_-1 .. c_n of lines of n values, `width` lines side by side; value i of line w is first[i *
/// stride + w]. Solves (c_i-1 + 4 c_i + c_i+1) / 6 = f_i with (c_1 - c_-1) / 2 and (c_n - c_n-2) / 2 the slopes at the
/// ends (times the cell), which are those of the cubic through the four nodes there.
void to_bspline_coefficients(double* first, int n, std::size_t stride, std::size_t width);

/// Weights of the four coefficients around a place `u` of the way from one node to the next, and their derivatives.
struct BsplineWeights {
  double w[4], d[4];
  explicit BsplineWeights(double u) {
    const double v = 1 - u;
    w[0] = v * v * v / 6;
    w[1] = (3 * u - 6) * u * u / 6 + 2.0 / 3;
    w[2] = (3 * v - 6) * v * v / 6 + 2.0 / 3;
    w[3] = u * u * u / 6;
    d[0] = -v * v / 2;
    d[1] = (1.5 * u - 2) * u;
    d[2] = -(1.5 * v - 2) * v;
    d[3] = u * u / 2;
  }
};

}  // namespace leastcost
