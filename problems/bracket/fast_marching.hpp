// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "problems/bracket/cell_grid.hpp"
#include "problems/bracket/front_heap.hpp"
#include "problems/bracket/stopped.hpp"

namespace leastcost::bracket {

/// First-order upwind fast marching for |grad u| = n on the nodes of a grid (Sethian, PNAS 93, 1996). Keeps its memory
/// between runs.
class FastMarching {
 public:
  explicit FastMarching(const StopLook& look) : look_(look) {}
  /// `u`: values at the seeds, infinite elsewhere; filled where `density` is finite and a seed is connected. Seeds are
  /// frozen: they keep their values. Throws Stopped.
  void run(const CellGrid& grid, const std::vector<double>& density, const std::vector<int>& seeds,
           std::vector<double>& u);
  const StopLook& look() const { return look_; }

 private:
  const StopLook& look_;
  FrontHeap front_;
};

}  // namespace leastcost::bracket
