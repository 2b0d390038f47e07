// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/front_heap.hpp"

namespace leastcost::bracket {

void FrontHeap::begin(std::vector<double>& u, const std::vector<int>& seeds) {
  u_ = u.data();
  heap_.clear();
  place_.assign(u.size(), -1);
  state_.assign(u.size(), kFar);
  for (const int seed : seeds) {
    state_[static_cast<std::size_t>(seed)] = kSeed;
    heap_.push_back(seed);
    raise(heap_.size() - 1);
  }
}

void FrontHeap::raise(std::size_t k) {
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

void FrontHeap::sink(std::size_t k) {
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

int FrontHeap::pop() {
  const int least = heap_.front(), last = heap_.back();
  heap_.pop_back();
  if (!heap_.empty()) {
    heap_.front() = last;
    sink(0);
  }
  return least;
}

void FrontHeap::lower_to(int node, double value) {
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

}  // namespace leastcost::bracket
