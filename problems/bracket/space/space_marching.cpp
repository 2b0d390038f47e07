// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/space/space_marching.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace leastcost::bracket {
namespace {

/// The value at a node from its upwind neighbours along the three axes; `step` is n h.
double upwind_in_space(double a, double b, double c, double step) {
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

}  // namespace

void SpaceMarching::run(const NodeSet& nodes, double h, const std::vector<double>& density,
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
      const std::array<int, 6>& b = nodes.beside(node);
      front_.lower_to(
          node, upwind_in_space(std::min(accepted(b[0]), accepted(b[1])), std::min(accepted(b[2]), accepted(b[3])),
                                std::min(accepted(b[4]), accepted(b[5])), n * h));
    }
  }
}

void SpaceMarching::follow(const NodeSet& nodes, double h, const std::vector<double>& density,
                           const std::vector<int>& order, std::vector<double>& u) {
  constexpr double kNoBetter = 1e-12;
  reached_.assign(u.size(), 0);
  again_.clear();
  const auto at = [&](int node) { return u[static_cast<std::size_t>(node)]; };
  const auto lower = [&](int node) {
    const auto here = static_cast<std::size_t>(node);
    const std::array<int, 6>& b = nodes.beside(node);
    const double value = upwind_in_space(std::min(at(b[0]), at(b[1])), std::min(at(b[2]), at(b[3])),
                                         std::min(at(b[4]), at(b[5])), density[here] * h);
    if (!(value < u[here] - kNoBetter * value)) return;
    u[here] = value;
    for (const int other : b)
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

}  // namespace leastcost::bracket
