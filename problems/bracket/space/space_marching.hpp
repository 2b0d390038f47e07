// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "problems/bracket/front_heap.hpp"
#include "problems/bracket/space/node_set.hpp"
#include "problems/bracket/stopped.hpp"

namespace leastcost::bracket {

/// First-order upwind fast marching for |grad u| = n on nodes in space (Sethian, PNAS 93, 1996). A march that differs
/// little from one before may follow its order, without a front that is sorted: as in the plane (FastMarching).
class SpaceMarching {
 public:
  explicit SpaceMarching(const StopLook& look) : look_(look) {}
  /// `u`: values at the seeds, infinite elsewhere; filled where `density` is finite and a seed is connected. Seeds keep
  /// their values. `order`: of the nodes as the front reaches them. Throws Stopped.
  void run(const NodeSet& nodes, double h, const std::vector<double>& density, const std::vector<int>& seeds,
           std::vector<double>& u, std::vector<int>& order);
  /// The same outcome in the order of an earlier run from the same seeds.
  void follow(const NodeSet& nodes, double h, const std::vector<double>& density, const std::vector<int>& order,
              std::vector<double>& u);
  const StopLook& look() const { return look_; }

 private:
  const StopLook& look_;
  FrontHeap front_;
  std::vector<unsigned char> reached_;
  std::vector<int> again_;
};

}  // namespace leastcost::bracket
