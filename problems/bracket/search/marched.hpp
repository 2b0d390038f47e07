// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "problems/bracket/search/level.hpp"

/// Potentials on one grid: marched, corrected, proved.
namespace leastcost::bracket {

/// From an end: the cost of moves near it, less what the least cost is below it.
template <Medium M>
Front front_around(const M& medium, const Level<M>& level, const typename M::End& end) {
  constexpr int N = M::kDimension;
  const Grid<N>& grid = level.grid;
  Front front;
  front.density = level.density;
  front.values.assign(level.density.size(), kInfinity);
  front.reversed = end.reversed;
  const double reach = (end.k + 2) * grid.h * std::sqrt(static_cast<double>(N));
  const int span = 2 * end.k + 6, side = 2 * span + 1, count = N == 2 ? side * side : side * side * side;
  for (int number = 0; number < count; ++number) {
    Place<N> p = end.middle;
    for (int k = 0, rest = number; k < N; ++k, rest /= side) p[static_cast<std::size_t>(k)] += rest % side - span;
    const Vector<N> x = grid.node(p);
    if ((x - end.place).norm() > reach) continue;
    const int node = level.nodes.find(p);
    const double density = level.density[static_cast<std::size_t>(node)];
    if (!(density < kInfinity)) continue;
    const double cost = medium.cost_near(end, grid, x, density);
    if (!std::isfinite(cost)) continue;
    front.values[static_cast<std::size_t>(node)] = cost;
    front.seeds.push_back(node);
  }
  return front;
}

/// Whether two fronts meet about a node: there the mean of their slopes says nothing of n.
template <class SomeLevel, std::size_t Count>
bool is_at_shock(const SomeLevel& level, const std::vector<double>& u, int node, const std::array<int, Count>& beside) {
  constexpr double kKink = 0.2;  // of n: a slope that falls by more within two cells is a shock's
  const auto size = [&](int k) { return std::abs(u[static_cast<std::size_t>(k)]); };
  const double least = -kKink * level.grid.h * level.density[static_cast<std::size_t>(node)], here = 2 * size(node);
  for (std::size_t axis = 0; axis < Count; axis += 2)
    if (size(beside[axis + 1]) + size(beside[axis]) - here < least) return true;
  return false;
}

/// Towards a density for which the central differences of u have the length of n.
template <Medium M>
void correct(const Level<M>& level, const std::vector<double>& u, Front& front) {
  constexpr double kLeast = 0.6, kMost = M::kDimension == 2 ? 1.15 : 1.05;  // beyond is a shock
  level.nodes.for_each_with_neighbours([&](int node, const auto& beside) {
    const auto at = static_cast<std::size_t>(node);
    if (!(level.density[at] < kInfinity) || is_at_shock(level, u, node, beside)) return;
    Vector<M::kDimension> rise;
    for (int k = 0; k < M::kDimension; ++k) {
      const auto axis = 2 * static_cast<std::size_t>(k);
      rise[k] = u[static_cast<std::size_t>(beside[axis + 1])] - u[static_cast<std::size_t>(beside[axis])];
    }
    const double factor = 2 * level.grid.h * level.density[at] / level.known.size(node, rise, front.reversed);
    if (factor > kLeast && factor < kMost) front.density[at] *= factor;
  });
}

/// Marches, and again after so many corrections: second order instead of first.
template <Medium M>
std::vector<double> march(const Level<M>& level, Front& front, int corrections, FastMarching& marching) {
  for (int pass = 0;; ++pass) {
    std::vector<double> u = front.values;
    level.known.march(level, front, u, marching);
    if (!front.sign.empty())
      for (std::size_t node = 0; node < u.size(); ++node) u[node] *= front.sign[node];
    if (pass == corrections) return u;
    correct(level, u, front);
  }
}

inline double largest_finite(const std::vector<double>& u) {
  double largest = 0;
  for (const double value : u)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Whether a function with this net is nowhere below `cap`.
template <std::size_t Size>
bool is_above(const std::array<double, Size>& net, double cap) {
  constexpr double kRounding = 1e-14;
  return std::ranges::all_of(net, [&](double value) { return value * (1 - kRounding) >= cap; });
}

/// Proved ratios of |grad u| to n, or dual norms of grad u, in the searched cells outside the sets around the ends, but
/// for those where u is nowhere below `cap`; returns the largest, at least 1.
template <Medium M>
double check(const Level<M>& level, const std::vector<double>& u, const typename M::End& s, const typename M::End& t,
             std::vector<double>& ratios, const StopLook& look, bool reversed = false, double cap = kInfinity) {
  constexpr int N = M::kDimension;
  const double largest = largest_finite(u);
  ratios.assign(u.size(), 0);
  double worst = 1;
  const Blocked<N> nowhere;
  for (std::size_t k = 0; k < level.cells.size(); ++k) {
    look.now_and_then();
    const int node = level.cells[k];
    const Place<N> p = level.nodes.place(node);
    if ((s.valid && s.holds(p)) || (t.valid && t.holds(p))) continue;
    const Net<N> coefficients = around(level.nodes, u, node);
    if (cap < kInfinity && is_above(value_net<N>(coefficients), cap)) continue;
    const Blocked<N>& blocked = level.blocked.empty() ? nowhere : level.blocked[k];
    const double ratio = level.known.ratio(level, coefficients, largest, k, reversed, blocked);
    ratios[static_cast<std::size_t>(node)] = ratio;
    worst = std::max(worst, ratio);
  }
  return worst;
}

/// Lowers the density where the ratio exceeds 1, so that the next march has less of an excess there.
template <Medium M>
void deflate(const Level<M>& level, const std::vector<double>& ratios, Front& front) {
  constexpr double kOvershoot = 1.1;
  std::vector<double> worst(ratios.size(), 1);  // of the cells that depend on a node
  for (const int cell : level.cells) {
    const double ratio = ratios[static_cast<std::size_t>(cell)];
    if (!(ratio > 1)) continue;
    for (const int row : level.nodes.rows_around(cell))
      for (int p = -1; p <= 1; ++p) {
        double& here = worst[static_cast<std::size_t>(row + p)];
        here = std::max(here, ratio);
      }
  }
  for (double& value : worst) value = value > 1 && std::isfinite(value) ? kOvershoot * (value - 1) : 0;
  level.known.spread(level, worst);
  for (std::size_t node = 0; node < worst.size(); ++node) {
    if (!(worst[node] > 0)) continue;
    front.density[node] /= 1 + worst[node];
    if (!front.sign.empty() || M::kSeedsGiveWay) front.values[node] /= 1 + worst[node];
  }
}

}  // namespace leastcost::bracket
