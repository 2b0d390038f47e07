// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/fast_marching.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace leastcost::bracket {
namespace {

constexpr unsigned char kFar = 0, kFront = 1, kDone = 2;

/// The value at a node from its upwind neighbours in x and in y; `step` is n h.
double upwind(double ux, double uy, double step) {
  const double apart = ux - uy;
  if (!(std::abs(apart) < step)) return std::min(ux, uy) + step;
  return 0.5 * (ux + uy + std::sqrt(2 * step * step - apart * apart));
}

}  // namespace

void FastMarching::raise(std::size_t k) {
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

void FastMarching::sink(std::size_t k) {
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

int FastMarching::pop() {
  const int least = heap_.front(), last = heap_.back();
  heap_.pop_back();
  if (!heap_.empty()) {
    heap_.front() = last;
    sink(0);
  }
  return least;
}

void FastMarching::lower_to(int node, double value) {
  unsigned char& state = state_[static_cast<std::size_t>(node)];
  if (state == kFront && !(value < u_[node])) return;
  u_[node] = value;
  if (state == kFar) {
    state = kFront;
    heap_.push_back(node);
    place_[static_cast<std::size_t>(node)] = static_cast<int>(heap_.size() - 1);
  }
  raise(static_cast<std::size_t>(place_[static_cast<std::size_t>(node)]));
}

void FastMarching::run(const CellGrid& grid, const std::vector<double>& density, const std::vector<int>& seeds,
                       std::vector<double>& u) {
  constexpr unsigned char kSeed = 3;  // in the front, never lowered
  const int stride = grid.stride(), rows = grid.ny + 2;
  u_ = u.data();
  heap_.clear();
  place_.assign(u.size(), -1);
  state_.assign(u.size(), kFar);
  for (const int seed : seeds) {
    state_[static_cast<std::size_t>(seed)] = kSeed;
    heap_.push_back(seed);
    raise(heap_.size() - 1);
  }
  const auto done = [&](int node) { return state_[static_cast<std::size_t>(node)] == kDone ? u_[node] : kInfinity; };
  while (!heap_.empty()) {
    look_.now_and_then();
    const int least = pop();
    state_[static_cast<std::size_t>(least)] = kDone;
    const int i = grid.column(least), j = grid.row(least);
    const std::array<std::array<int, 2>, 4> around = {{{i + 1, j}, {i - 1, j}, {i, j + 1}, {i, j - 1}}};
    for (const auto& [a, b] : around) {
      if (a < 0 || b < 0 || a >= stride || b >= rows) continue;
      const int node = grid.id(a, b);
      const unsigned char state = state_[static_cast<std::size_t>(node)];
      const double n = density[static_cast<std::size_t>(node)];
      if (state == kDone || state == kSeed || !(n < kInfinity)) continue;
      const double ux = std::min(a > 0 ? done(node - 1) : kInfinity, a + 1 < stride ? done(node + 1) : kInfinity);
      const double uy =
          std::min(b > 0 ? done(node - stride) : kInfinity, b + 1 < rows ? done(node + stride) : kInfinity);
      lower_to(node, upwind(ux, uy, n * grid.h));
    }
  }
}

}  // namespace leastcost::bracket
