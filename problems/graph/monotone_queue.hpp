// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace leastcost {

/// What waits in a search of Dijkstra's kind, the least cost first: nothing is pushed below what has been taken out, so
/// that a radix heap does (Ahuja, Mehlhorn, Orlin, Tarjan, J. ACM 37:213, 1990). No cost of a waiting item can be
/// changed: push the item again, and pass over the dearer one.
///
/// An item lies in the bucket of the highest bit in which its cost differs from `least_`. The front of a search over a
/// grid has tens of thousands of items; they are moved a few times each, in order, where a binary heap jumps.
template <class Item>
class MonotoneQueue {
 public:
  bool empty() const { return filled_ == 0; }
  /// A cost below 0, as rounding may have it, counts as 0; one below what has been taken out comes out next.
  void push(double cost, Item item) { put(cost > 0 ? std::bit_cast<std::uint64_t>(cost) : 0, item); }
  /// A cost, and an item of it. Requires !empty().
  std::pair<double, Item> pop() {
    if (lowest() > 0 && buckets_[lowest()].size() > kFew) spread(lowest());
    Bucket& bucket = buckets_[lowest()];
    if (lowest() > 0) std::swap(*std::min_element(bucket.begin(), bucket.end(), by_key), bucket.back());
    const auto [key, item] = bucket.back();
    bucket.pop_back();
    if (bucket.empty()) filled_ &= filled_ - 1;
    return {std::bit_cast<double>(key), item};
  }

 private:
  using Entry = std::pair<std::uint64_t, Item>;  ///< costs that are not negative are ordered as their bits are
  using Bucket = std::vector<Entry>;
  static constexpr std::size_t kFew = 16;  ///< are looked through faster than moved

  static bool by_key(const Entry& a, const Entry& b) { return a.first < b.first; }
  std::size_t lowest() const { return static_cast<std::size_t>(std::countr_zero(filled_)); }
  /// Costs have no sign, so that bit 63 is 0 and 64 buckets are enough.
  void put(std::uint64_t key, Item item) {
    const auto bucket = key <= least_ ? std::size_t{0} : static_cast<std::size_t>(std::bit_width(key ^ least_));
    buckets_[bucket].emplace_back(key, item);
    filled_ |= std::uint64_t{1} << bucket;
  }
  /// The lowest bucket, which is not bucket 0, over those below it.
  void spread(std::size_t bucket) {
    std::swap(buckets_[bucket], moved_);  // both keep their memory
    filled_ &= filled_ - 1;
    least_ = std::min_element(moved_.begin(), moved_.end(), by_key)->first;
    for (const auto& [key, item] : moved_) put(key, item);
    moved_.clear();
  }

  std::array<Bucket, 64> buckets_;
  Bucket moved_;
  std::uint64_t filled_ = 0;  ///< a bit for each bucket that is not empty
  std::uint64_t least_ = 0;   ///< the bits of a cost; what waits in bucket 0 is not above it, all else is
};

}  // namespace leastcost
