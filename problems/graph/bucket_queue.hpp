// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "problems/graph/monotone_queue.hpp"

namespace leastcost {

/// What waits in a search of Dijkstra's kind whose items of nearly equal costs may be taken in any order: those whose
/// costs lie in one interval of a width come out together, the intervals in their order (Dial, Comm. ACM 12:632, 1969;
/// in continuous problems Tsitsiklis, IEEE Trans. Automatic Control 40:1528, 1995). No order is kept within a bucket,
/// which is what makes it quick. The order is right if moves between items cost more than the width.
///
/// Buckets are in a ring; items beyond it wait in a MonotoneQueue, so that costs of any range are possible.
template <class Item>
class BucketQueue {
 public:
  /// Of an interval, cost units. 0: items come out one by one, in the order of their costs.
  explicit BucketQueue(double width) : per_width_(width > 0 ? 1 / width : 0) {
    if (per_width_ > 0) ring_.resize(kRing), filled_.assign(kWords, 0);
  }
  /// A cost below 0 counts as 0; one below the interval that came out last comes out next.
  void push(double cost, Item item) {
    if (ring_.empty() || bucket_of(cost) - current_ >= kBuckets)
      push_far(cost, item);
    else
      put(bucket_of(cost), item);
  }
  /// Whether two costs lie in one interval: an item that becomes cheaper is then in the right place.
  bool together(double a, double b) const { return !ring_.empty() && bucket_of(a) == bucket_of(b); }
  /// The items of the lowest interval that has some, each as often as it was pushed there; false: nothing waits.
  bool pop(std::vector<Item>& items) {
    items.clear();
    const std::int64_t next = next_filled();
    if (far_ && (ring_.empty() || bucket_of(far_->first) <= next)) return pop_far(items);
    if (next == kNone) return false;
    take(next, items);
    return true;
  }

 private:
  static constexpr std::size_t kRing = 4096, kBits = 64, kWords = kRing / kBits;
  static constexpr std::int64_t kBuckets = kRing, kNone = std::numeric_limits<std::int64_t>::max();

  std::int64_t bucket_of(double cost) const {
    constexpr double kMost = 4e18;
    const double bucket = cost * per_width_;
    return static_cast<std::int64_t>(bucket > 0 ? (bucket < kMost ? bucket : kMost) : 0.0);
  }
  static std::size_t place(std::int64_t bucket) { return static_cast<std::size_t>(bucket) % kRing; }

  void put(std::int64_t bucket, Item item) {
    const std::size_t k = place(bucket > current_ ? bucket : current_);
    ring_[k].push_back(item);
    filled_[k / kBits] |= std::uint64_t{1} << (k % kBits);
  }
  void take(std::int64_t bucket, std::vector<Item>& items) {
    current_ = bucket;
    const std::size_t k = place(bucket);
    std::swap(items, ring_[k]);  // both keep their memory
    filled_[k / kBits] &= ~(std::uint64_t{1} << (k % kBits));
  }
  std::int64_t next_filled() const {
    const std::size_t first = place(current_);
    for (std::size_t i = 0; i <= filled_.size() && !filled_.empty(); ++i) {
      const std::size_t word = (first / kBits + i) % kWords;
      const std::uint64_t bits = filled_[word] & (i == 0 ? ~std::uint64_t{0} << (first % kBits) : ~std::uint64_t{0});
      if (bits == 0) continue;
      const std::size_t k = word * kBits + static_cast<std::size_t>(std::countr_zero(bits));
      return current_ + static_cast<std::int64_t>((k + kRing - first) % kRing);
    }
    return kNone;
  }

  /// The least of what is beyond the ring is kept apart, to be looked at.
  void push_far(double cost, Item item) {
    if (far_ && cost < far_->first) {
      std::swap(cost, far_->first);
      std::swap(item, far_->second);
    }
    if (far_)
      beyond_.push(cost, item);
    else
      far_ = {cost, item};
  }
  std::pair<double, Item> next_far() {
    const std::pair<double, Item> next = *far_;
    far_ = beyond_.empty() ? std::nullopt : std::optional(beyond_.pop());
    return next;
  }
  /// Requires far_. Fills the ring with what it has room for from there on.
  bool pop_far(std::vector<Item>& items) {
    if (ring_.empty()) {
      items.push_back(next_far().second);
      return true;
    }
    current_ = std::max(current_, bucket_of(far_->first));
    while (far_ && bucket_of(far_->first) - current_ < kBuckets) {
      const auto [cost, item] = next_far();
      put(bucket_of(cost), item);
    }
    take(current_, items);
    return true;
  }

  double per_width_;
  std::int64_t current_ = 0;  ///< the bucket that came out last
  std::vector<std::vector<Item>> ring_;
  std::vector<std::uint64_t> filled_;  ///< a bit for each bucket of the ring that is not empty
  std::optional<std::pair<double, Item>> far_;
  MonotoneQueue<Item> beyond_;
};

}  // namespace leastcost
