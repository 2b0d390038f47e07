// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/fast_marching.hpp"

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

}  // namespace

void FastMarching::run(const CellGrid& grid, const std::vector<double>& density, const std::vector<int>& seeds,
                       std::vector<double>& u) {
  const int stride = grid.stride(), rows = grid.ny + 2;
  front_.begin(u, seeds);
  const auto done = [this](int node) { return front_.final_value(node); };
  while (!front_.empty()) {
    look_.now_and_then();
    const int least = front_.pop();
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

}  // namespace leastcost::bracket
