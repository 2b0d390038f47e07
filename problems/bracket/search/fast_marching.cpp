// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/search/fast_marching.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace leastcost::bracket {
namespace {

/// The value at a node from its upwind neighbours along the axes; `step` is n h.
double upwind(const std::array<double, 2>& u, double step) {
  const double apart = u[0] - u[1];
  if (!(std::abs(apart) < step)) return std::min(u[0], u[1]) + step;
  return 0.5 * (u[0] + u[1] + std::sqrt(2 * step * step - apart * apart));
}
double upwind(std::array<double, 3> u, double step) {
  auto& [a, b, c] = u;
  if (b < a) std::swap(a, b);
  if (c < b) std::swap(b, c);
  if (b < a) std::swap(a, b);
  if (!(a + step > b)) return a + step;
  const double second = b - a, squares = step * step;
  const double by_two = 0.5 * (second + std::sqrt(2 * squares - second * second));
  if (!(a + by_two > c)) return a + by_two;
  const double third = c - a, sum = second + third;
  const double root = sum * sum - 3 * (second * second + third * third - squares);
  return a + (sum + std::sqrt(std::max(root, 0.0))) / 3;
}

/// The same of the values of all neighbours.
template <std::size_t Count, class Value>
double from_neighbours(const std::array<int, Count>& beside, double step, const Value& value) {
  std::array<double, Count / 2> least;
  for (std::size_t axis = 0; axis < least.size(); ++axis)
    least[axis] = std::min(value(beside[2 * axis]), value(beside[2 * axis + 1]));
  return upwind(least, step);
}

}  // namespace

template <class SomeNodes>
void FastMarching::run(const SomeNodes& nodes, double h, const std::vector<double>& density,
                       const std::vector<int>& seeds, std::vector<double>& u, std::vector<int>& order) {
  order.clear();
  front_.begin(u, seeds);
  const auto accepted = [this](int node) { return front_.final_value(node); };
  while (!front_.empty()) {
    look_.now_and_then();
    const int least = front_.pop();
    if (!front_.is_seed(least)) order.push_back(least);
    front_.finish(least);
    for (const int node : nodes.beside(least)) {
      const double n = density[static_cast<std::size_t>(node)];
      if (!front_.is_open(node) || !(n < kInfinity)) continue;
      front_.lower_to(node, from_neighbours(nodes.beside(node), n * h, accepted));
    }
  }
}

template <class SomeNodes>
void FastMarching::follow(const SomeNodes& nodes, double h, const std::vector<double>& density,
                          const std::vector<int>& order, std::vector<double>& u) {
  constexpr double kNoBetter = 1e-12;
  reached_.assign(u.size(), 0);
  again_.clear();
  const auto at = [&](int node) { return u[static_cast<std::size_t>(node)]; };
  const auto lower = [&](int node) {
    const auto here = static_cast<std::size_t>(node);
    const auto& beside = nodes.beside(node);
    const double value = from_neighbours(beside, density[here] * h, at);
    if (!(value < u[here] - kNoBetter * value)) return;
    u[here] = value;
    for (const int other : beside)
      if (at(other) > value && reached_[static_cast<std::size_t>(other)]) again_.push_back(other);
  };
  for (const int node : order) {
    look_.now_and_then();
    lower(node);
    reached_[static_cast<std::size_t>(node)] = 1;
    for (std::size_t next = 0; next < again_.size();) lower(again_[next++]);  // grows meanwhile
    again_.clear();
  }
}

template void FastMarching::run(const AllNodes&, double, const std::vector<double>&, const std::vector<int>&,
                                std::vector<double>&, std::vector<int>&);
template void FastMarching::run(const NodeSet&, double, const std::vector<double>&, const std::vector<int>&,
                                std::vector<double>&, std::vector<int>&);
template void FastMarching::follow(const AllNodes&, double, const std::vector<double>&, const std::vector<int>&,
                                   std::vector<double>&);
template void FastMarching::follow(const NodeSet&, double, const std::vector<double>&, const std::vector<int>&,
                                   std::vector<double>&);

}  // namespace leastcost::bracket
