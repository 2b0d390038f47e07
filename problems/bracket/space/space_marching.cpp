// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/space/space_marching.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace leastcost::bracket {
namespace {

constexpr unsigned char kNotReached = 0, kInFront = 1, kAccepted = 2, kSeeded = 3;  // a seed is in the front

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

void SpaceMarching::raise(std::size_t k) {
  const int node = heap_[k];
  for (; k > 0; k = (k - 1) / 2) {
    const int parent = heap_[(k - 1) / 2];
    if (u_[parent] <= u_[node]) break;
    heap_[k] = parent;
    place_[static_cast<std::size_t>(parent)] = static_cast<int>(k);
  }
  heap_[k] = node;
  place_[static_cast<std::size_t>(node)] = static_cast<int>(k);
}

void SpaceMarching::sink(std::size_t k) {
  const int node = heap_[k];
  for (std::size_t child = 2 * k + 1; child < heap_.size(); child = 2 * k + 1) {
    if (child + 1 < heap_.size() && u_[heap_[child + 1]] < u_[heap_[child]]) ++child;
    if (u_[heap_[child]] >= u_[node]) break;
    heap_[k] = heap_[child];
    place_[static_cast<std::size_t>(heap_[k])] = static_cast<int>(k);
    k = child;
  }
  heap_[k] = node;
  place_[static_cast<std::size_t>(node)] = static_cast<int>(k);
}

int SpaceMarching::pop() {
  const int least = heap_.front(), last = heap_.back();
  heap_.pop_back();
  if (!heap_.empty()) {
    heap_.front() = last;
    sink(0);
  }
  return least;
}

void SpaceMarching::lower_to(int node, double value) {
  unsigned char& state = state_[static_cast<std::size_t>(node)];
  if (state == kInFront && !(value < u_[node])) return;
  u_[node] = value;
  if (state == kNotReached) {
    state = kInFront;
    heap_.push_back(node);
    place_[static_cast<std::size_t>(node)] = static_cast<int>(heap_.size() - 1);
  }
  raise(static_cast<std::size_t>(place_[static_cast<std::size_t>(node)]));
}

void SpaceMarching::run(const NodeSet& nodes, double h, const std::vector<double>& density,
                        const std::vector<int>& seeds, std::vector<double>& u, std::vector<int>& order) {
  u_ = u.data();
  heap_.clear();
  order.clear();
  place_.assign(u.size(), -1);
  state_.assign(u.size(), kNotReached);
  for (const int seed : seeds) {
    state_[static_cast<std::size_t>(seed)] = kSeeded;
    heap_.push_back(seed);
    raise(heap_.size() - 1);
  }
  const auto accepted = [&](int node) {
    return state_[static_cast<std::size_t>(node)] == kAccepted ? u_[node] : kInfinity;
  };
  while (!heap_.empty()) {
    look_.now_and_then();
    const int least = pop();
    if (state_[static_cast<std::size_t>(least)] != kSeeded) order.push_back(least);
    state_[static_cast<std::size_t>(least)] = kAccepted;
    for (const int node : nodes.beside(least)) {
      const unsigned char state = state_[static_cast<std::size_t>(node)];
      const double n = density[static_cast<std::size_t>(node)];
      if (state == kAccepted || state == kSeeded || !(n < kInfinity)) continue;
      const std::array<int, 6>& b = nodes.beside(node);
      lower_to(node, upwind_in_space(std::min(accepted(b[0]), accepted(b[1])), std::min(accepted(b[2]), accepted(b[3])),
                                     std::min(accepted(b[4]), accepted(b[5])), n * h));
    }
  }
}

void SpaceMarching::follow(const NodeSet& nodes, double h, const std::vector<double>& density,
                           const std::vector<int>& order, std::vector<double>& u) const {
  const auto at = [&](int node) { return u[static_cast<std::size_t>(node)]; };
  for (const int node : order) {
    look_.now_and_then();
    const std::array<int, 6>& b = nodes.beside(node);
    u[static_cast<std::size_t>(node)] =
        upwind_in_space(std::min(at(b[0]), at(b[1])), std::min(at(b[2]), at(b[3])), std::min(at(b[4]), at(b[5])),
                        density[static_cast<std::size_t>(node)] * h);
  }
}

}  // namespace leastcost::bracket
