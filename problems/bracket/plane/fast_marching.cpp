// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/plane/fast_marching.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace leastcost::bracket {
namespace {

/// The value at a node from its upwind neighbours in x and in y; `step` is n h.
double upwind(double ux, double uy, double step) {
  const double apart = ux - uy;
  if (!(std::abs(apart) < step)) return std::min(ux, uy) + step;
  return 0.5 * (ux + uy + std::sqrt(2 * step * step - apart * apart));
}

/// The four neighbours of a node: left, right, below and above.
struct Neighbours {
  int stride, rows;

  int step(std::size_t k) const { return k < 2 ? 2 * static_cast<int>(k) - 1 : k == 2 ? -stride : stride; }
  /// Infinite where there is none.
  std::array<double, 4> values(const double* u, int node) const {
    const int i = node % stride, j = node / stride;
    const double* here = u + node;
    return {i > 0 ? here[-1] : kInfinity, i + 1 < stride ? here[1] : kInfinity, j > 0 ? here[-stride] : kInfinity,
            j + 1 < rows ? here[stride] : kInfinity};
  }
};

}  // namespace

void FastMarching::run(const CellGrid& grid, const std::vector<double>& density, const std::vector<int>& seeds,
                       std::vector<double>& u, std::vector<int>& order) {
  order.clear();
  const int stride = grid.stride(), rows = grid.ny + 2;
  front_.begin(u, seeds);
  const auto done = [this](int node) { return front_.final_value(node); };
  while (!front_.empty()) {
    look_.now_and_then();
    const int least = front_.pop();
    if (!front_.is_seed(least)) order.push_back(least);
    front_.finish(least);
    const int i = grid.column(least), j = grid.row(least);
    const std::array<std::array<int, 2>, 4> around = {{{i + 1, j}, {i - 1, j}, {i, j + 1}, {i, j - 1}}};
    for (const auto& [a, b] : around) {
      if (a < 0 || b < 0 || a >= stride || b >= rows) continue;
      const int node = grid.id(a, b);
      const double n = density[static_cast<std::size_t>(node)];
      if (!front_.is_open(node) || !(n < kInfinity)) continue;
      const double ux = std::min(a > 0 ? done(node - 1) : kInfinity, a + 1 < stride ? done(node + 1) : kInfinity);
      const double uy =
          std::min(b > 0 ? done(node - stride) : kInfinity, b + 1 < rows ? done(node + stride) : kInfinity);
      front_.lower_to(node, upwind(ux, uy, n * grid.h));
    }
  }
}

void FastMarching::follow(const CellGrid& grid, const std::vector<double>& density, const std::vector<int>& order,
                          std::vector<double>& u) {
  constexpr double kNoBetter = 1e-12;
  const Neighbours neighbours{grid.stride(), grid.ny + 2};
  // With a row before and behind; beyond the end of a row the next one begins, where to look again does no harm.
  const auto padded = [&](int node) { return static_cast<std::size_t>(node + grid.stride()); };
  reached_.assign(u.size() + 2 * static_cast<std::size_t>(grid.stride()), 0);
  again_.clear();
  const auto lower = [&](int node) {
    const auto at = static_cast<std::size_t>(node);
    const std::array<double, 4> around = neighbours.values(u.data(), node);
    const double value = upwind(std::min(around[0], around[1]), std::min(around[2], around[3]), density[at] * grid.h);
    if (!(value < u[at] - kNoBetter * value)) return;
    u[at] = value;
    for (std::size_t k = 0; k < around.size(); ++k)
      if (around[k] > value && reached_[padded(node + neighbours.step(k))]) again_.push_back(node + neighbours.step(k));
  };
  for (const int node : order) {
    look_.now_and_then();
    lower(node);
    reached_[padded(node)] = 1;
    for (std::size_t next = 0; next < again_.size();) lower(again_[next++]);  // grows meanwhile
    again_.clear();
  }
}

}  // namespace leastcost::bracket
