// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "problems/bracket/cells/nodes.hpp"
#include "problems/bracket/front_heap.hpp"
#include "problems/bracket/stopped.hpp"

namespace leastcost::bracket {

/// First-order upwind fast marching for |grad u| = n on the nodes of a grid (Sethian, PNAS 93, 1996). A march that
/// differs little from one before may follow its order, without a front that is sorted. Keeps its memory between runs.
/// Vectors have a number for none(), which is infinite in `u` and `density`. Of AllNodes and NodeSet.
class FastMarching {
 public:
  explicit FastMarching(const StopLook& look) : look_(look) {}
  /// `u`: values at the seeds, infinite elsewhere; filled where `density` is finite and a seed is connected. Seeds are
  /// frozen: they keep their values. `order`: of the other nodes as the front reaches them. Throws Stopped.
  template <class SomeNodes>
  void run(const SomeNodes& nodes, double h, const std::vector<double>& density, const std::vector<int>& seeds,
           std::vector<double>& u, std::vector<int>& order);
  /// The same outcome for another density, by the order of an earlier run from the same seeds: where a node turns out
  /// to be reached before a neighbour that is earlier in the order, that one is done again, and what depends on it.
  template <class SomeNodes>
  void follow(const SomeNodes& nodes, double h, const std::vector<double>& density, const std::vector<int>& order,
              std::vector<double>& u);
  const StopLook& look() const { return look_; }

 private:
  const StopLook& look_;
  FrontHeap front_;
  std::vector<unsigned char> reached_;
  std::vector<int> again_;
};

}  // namespace leastcost::bracket
