// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "problems/bracket/grid.hpp"

namespace leastcost::bracket {

/// Bernstein coefficients of a function on a cell, of degree two along each axis, or those of a spline of that degree
/// at the nodes around it; x runs fastest, then y.
template <int N>
using Net = std::array<double, N == 2 ? 9 : 27>;
template <int N>
inline constexpr std::size_t kNetMiddle = N == 2 ? 4 : 13;
inline constexpr std::array<std::size_t, 3> kNetStep = {1, 3, 9};  ///< to the next coefficient along an axis

template <int N>
Net<N> net_of(double value) {
  Net<N> net;
  net.fill(value);
  return net;
}

/// Calls f with the first of each three coefficients that lie along an axis, of so many.
template <std::size_t Size, class F>
void for_lines(std::size_t axis, const F& f) {
  const std::size_t one = kNetStep[axis == 0 ? 1 : 0];
  if constexpr (Size == 9) {
    for (std::size_t p = 0; p < 3; ++p) f(p * one);
  } else {
    const std::size_t other = kNetStep[axis == 2 ? 1 : 2];
    for (std::size_t q = 0; q < 3; ++q)
      for (std::size_t p = 0; p < 3; ++p) f(p * one + q * other);
  }
}

/// Along an axis from coefficients of the spline to those of Bernstein: averages at the ends.
template <std::size_t Axis, std::size_t Size>
std::array<double, Size> averaged(std::array<double, Size> net) {
  constexpr std::size_t step = kNetStep[Axis];
  for_lines<Size>(Axis, [&](std::size_t at) {
    const double middle = net[at + step];
    net[at] = 0.5 * (net[at] + middle);
    net[at + 2 * step] = 0.5 * (middle + net[at + 2 * step]);
  });
  return net;
}

/// The derivative along an axis of a spline, times the side of the cell, its degree raised to two.
template <std::size_t Axis, std::size_t Size>
std::array<double, Size> differenced(std::array<double, Size> net) {
  constexpr std::size_t step = kNetStep[Axis];
  for_lines<Size>(Axis, [&](std::size_t at) {
    const double left = net[at + step] - net[at], right = net[at + 2 * step] - net[at + step];
    net[at] = left;
    net[at + step] = 0.5 * (left + right);
    net[at + 2 * step] = right;
  });
  return net;
}

/// To the net on the lower or the upper half of the cell along an axis.
template <std::size_t Axis, std::size_t Size>
void halve(std::array<double, Size>& net, bool upper) {
  constexpr std::size_t step = kNetStep[Axis];
  for_lines<Size>(Axis, [&](std::size_t at) {
    double &a = net[at], &b = net[at + step], &c = net[at + 2 * step];
    const double l = 0.5 * (a + b), r = 0.5 * (b + c), m = 0.5 * (l + r);
    if (upper) {
      a = m, b = r;
    } else {
      b = l, c = m;
    }
  });
}
/// Of some nets.
template <std::size_t Axis, std::size_t Size, std::size_t Count>
void halve(std::array<std::array<double, Size>, Count>& nets, bool upper) {
  for (std::array<double, Size>& net : nets) halve<Axis>(net, upper);
}

/// Calls f with the net, or nets, on each of the 2^N halves of a cell, and 0 or 1 along each axis for which it is; x
/// runs fastest.
template <int N, std::size_t Axes = static_cast<std::size_t>(N), class Nets, class F>
void for_halves(const Nets& nets, const F& f, Place<N> half = {}) {
  if constexpr (Axes == 0)
    f(nets, half);
  else
    for (const bool upper : {false, true}) {
      Nets of_half = nets;
      halve<Axes - 1>(of_half, upper);
      half[Axes - 1] = upper ? 1 : 0;
      for_halves<N, Axes - 1>(of_half, f, half);
    }
}

/// The largest size of a coefficient; NaN where one of them is.
template <std::size_t Size>
double largest_of(const std::array<double, Size>& net) {
  double largest = 0;
  for (const double value : net) largest = larger_or_nan(largest, std::abs(value));
  return largest;
}
/// The least coefficient, or one of which nothing is known.
template <std::size_t Size>
double least_of(const std::array<double, Size>& net) {
  double least = kInfinity;
  for (const double value : net) least = value < least || value != value ? value : least;
  return least;
}

/// The net of the spline with these coefficients. One average per axis away from rounding.
template <int N>
Net<N> value_net(const Net<N>& coefficients) {
  const Net<N> net = averaged<1>(averaged<0>(coefficients));
  if constexpr (N == 2)
    return net;
  else
    return averaged<2>(net);
}

/// Those of the gradient, times the side of the cell.
template <int N>
std::array<Net<N>, static_cast<std::size_t>(N)> gradient_nets(const Net<N>& u) {
  if constexpr (N == 2) {
    return {averaged<1>(differenced<0>(u)), averaged<0>(differenced<1>(u))};
  } else {
    const Net<3> along_z = averaged<2>(u), along_y = averaged<1>(u);
    return {differenced<0>(averaged<1>(along_z)), differenced<1>(averaged<0>(along_z)),
            differenced<2>(averaged<0>(along_y))};
  }
}

/// The spline with these coefficients at a place of the cell, from -1/2 to 1/2 in units of its side. S: double,
/// Interval or Dual.
template <int N, class S>
S spline_value(const Net<N>& coefficients, const std::array<S, static_cast<std::size_t>(N)>& at) {
  std::array<std::array<S, 3>, static_cast<std::size_t>(N)> w;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const S left = S(0.5) - at[k], right = S(0.5) + at[k];
    w[k] = {S(0.5) * left * left, S(0.75) - at[k] * at[k], S(0.5) * right * right};
  }
  S sum(0.0);
  if constexpr (N == 2) {
    for (std::size_t q = 0; q < 3; ++q)
      for (std::size_t p = 0; p < 3; ++p) sum = sum + w[0][p] * w[1][q] * S(coefficients[p + 3 * q]);
  } else {
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t q = 0; q < 3; ++q) {
        S row(0.0);
        for (std::size_t p = 0; p < 3; ++p) row = row + w[0][p] * S(coefficients[p + 3 * q + 9 * r]);
        sum = sum + w[1][q] * w[2][r] * row;
      }
  }
  return sum;
}

}  // namespace leastcost::bracket
