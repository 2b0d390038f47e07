// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "problems/exact/window.hpp"

namespace leastcost {

/// A window no wider than rounding, beside an end of an edge, with what makes it stand for others that differ from it
/// by less than that.
template <class Real>
struct Sliver {
  Window<Real> window;
  std::int32_t next = -1;  ///< of the same half-edge and root, or -1
};

/// Slivers by the half-edge over which they enter and by their root. A surface that is flat but for noise has a root at
/// every other vertex, and slivers of hundreds of them over one edge. Open addressing; keeps its memory.
template <class Real>
class SliverTable {
 public:
  void clear() {
    slivers_.clear();
    used_ = 0;
    ++query_;
  }

  /// The sliver of this half-edge and root that was added last, or -1; others follow by `next`.
  std::int32_t first(std::int32_t halfedge, std::int32_t root) const {
    return slots_.empty() ? -1 : slots_[find(slots_, halfedge, root)].first_in(query_);
  }
  std::size_t size() const { return slivers_.size(); }  ///< number of slivers
  Sliver<Real>& operator[](std::int32_t i) { return slivers_[static_cast<std::size_t>(i)]; }

  void add(std::int32_t halfedge, const Window<Real>& w) {
    if (2 * (used_ + 1) > slots_.size()) grow();
    Slot& slot = slots_[find(slots_, halfedge, w.root)];
    if (slot.query != query_) {
      slot = {query_, halfedge, w.root, -1};
      ++used_;
    }
    slivers_.push_back({w, slot.first});
    slot.first = static_cast<std::int32_t>(slivers_.size()) - 1;
  }

 private:
  struct Slot {
    std::uint32_t query = 0;  // of an older query: free
    std::int32_t halfedge = -1, root = -1, first = -1;

    std::int32_t first_in(std::uint32_t now) const { return query == now ? first : -1; }
  };

  /// Where it is, or the free slot where it belongs.
  std::size_t find(const std::vector<Slot>& slots, std::int32_t halfedge, std::int32_t root) const {
    const std::uint64_t key =
        (std::uint64_t{static_cast<std::uint32_t>(halfedge)} << 32) | static_cast<std::uint32_t>(root);
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;  // Fibonacci hashing (Knuth, vol. 3, Sec. 6.4)
    std::size_t i = static_cast<std::size_t>((key * kGolden) >> 32) & (slots.size() - 1);
    while (slots[i].query == query_ && (slots[i].halfedge != halfedge || slots[i].root != root))
      i = (i + 1) & (slots.size() - 1);
    return i;
  }

  void grow() {
    constexpr std::size_t kFirst = 1024;
    std::vector<Slot> larger(slots_.empty() ? kFirst : 2 * slots_.size());
    for (const Slot& slot : slots_)
      if (slot.query == query_) larger[find(larger, slot.halfedge, slot.root)] = slot;
    slots_.swap(larger);
  }

  std::vector<Slot> slots_;  // a power of two of them, half of them used at most
  std::vector<Sliver<Real>> slivers_;
  std::size_t used_ = 0;
  std::uint32_t query_ = 1;
};

}  // namespace leastcost
