// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "problems/bracket/grid.hpp"

namespace leastcost::bracket {

/// The nodes that a front has reached, the one of the least value first, and what has become of each node: what fast
/// marching keeps (Sethian, PNAS 93:1591, 1996). A binary heap that knows where each node is.
class FrontHeap {
 public:
  /// `u`: values at the seeds, infinite elsewhere; it has to outlive the march. Seeds keep their values.
  void begin(std::vector<double>& u, const std::vector<int>& seeds);
  bool empty() const { return heap_.empty(); }
  /// Takes out the node of the least value.
  int pop();
  bool is_seed(int node) const { return state_[static_cast<std::size_t>(node)] == kSeed; }
  /// Its value is final from now on.
  void finish(int node) { state_[static_cast<std::size_t>(node)] = kDone; }
  /// Whether the front may still lower the value of a node.
  bool is_open(int node) const {
    const unsigned char state = state_[static_cast<std::size_t>(node)];
    return state != kDone && state != kSeed;
  }
  /// Infinite before it is final.
  double final_value(int node) const { return state_[static_cast<std::size_t>(node)] == kDone ? u_[node] : kInfinity; }
  /// Of an open node; a value that is no less changes nothing.
  void lower_to(int node, double value);

 private:
  static constexpr unsigned char kFar = 0, kFront = 1, kDone = 2, kSeed = 3;

  void raise(std::size_t k);
  void sink(std::size_t k);

  std::vector<int> heap_, place_;  ///< nodes in the front, and where each is
  std::vector<unsigned char> state_;
  double* u_ = nullptr;
};

}  // namespace leastcost::bracket
