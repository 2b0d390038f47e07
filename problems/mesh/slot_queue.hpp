// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace leastcost {

struct OpenNode {
  double key;
  std::int32_t node;
};

/// The nodes that wait in an A* search, least key first: a heap of four children each. A node whose key has fallen is
/// in it twice; the search passes over the dearer entry.
class OpenHeap {
 public:
  void clear() { entries_.clear(); }
  bool empty() const { return entries_.empty(); }
  const OpenNode& top() const { return entries_.front(); }  ///< requires !empty()

  void push(OpenNode entry) {
    std::size_t i = entries_.size();
    entries_.push_back(entry);
    while (i > 0) {
      const std::size_t parent = (i - 1) / kChildren;
      if (!(entry.key < entries_[parent].key)) break;
      entries_[i] = entries_[parent];
      i = parent;
    }
    entries_[i] = entry;
  }

  /// Requires !empty().
  OpenNode pop() {
    const OpenNode top = entries_.front(), last = entries_.back();
    entries_.pop_back();
    const std::size_t count = entries_.size();
    if (count == 0) return top;
    std::size_t i = 0;
    while (true) {
      const std::size_t first = kChildren * i + 1, end = std::min(first + kChildren, count);
      if (first >= count) break;
      std::size_t least = first;
      for (std::size_t c = first + 1; c < end; ++c)
        if (entries_[c].key < entries_[least].key) least = c;
      if (!(entries_[least].key < last.key)) break;
      entries_[i] = entries_[least];
      i = least;
    }
    entries_[i] = last;
    return top;
  }

 private:
  static constexpr std::size_t kChildren = 4;
  std::vector<OpenNode> entries_;
};

/// What waits in an A* search, for keys that do not fall below what was taken out: in slots of equal width by its key.
/// A slot is taken out last in first out, without regard to keys, and then, by their keys, what was pushed into it
/// meanwhile. So a search comes to a node twice at most: once before its least cost is known, and once with it. Unlike
/// on a heap of all, nodes that lie side by side come one after another, and what they need is near in memory. The
/// width changes the speed alone.
class SlotQueue {
 public:
  /// Empties it. About the least key that will come, and the width of a slot, > 0.
  void begin(double least, double width) {
    std::fill(heads_.begin(), heads_.begin() + static_cast<std::ptrdiff_t>(used_), kNone);
    entries_.clear();
    later_.clear();
    near_.clear();
    slot_.clear();
    lay_out(least, width);
  }

  void push(OpenNode node) {
    const double slots = (node.key - least_) * per_width_;
    if (!(slots >= static_cast<double>(current_ + 1))) return near_.push(node);
    if (!(slots < static_cast<double>(kSlots))) return later_.push_back(node);
    const std::size_t slot = static_cast<std::size_t>(slots);
    if (slot >= heads_.size()) heads_.resize(std::min(kSlots, 2 * slot + 1), kNone);
    entries_.push_back({node.node, heads_[slot]});
    heads_[slot] = static_cast<std::int32_t>(entries_.size()) - 1;
    used_ = std::max(used_, slot + 1);
  }

  /// Whether nothing waits. Asked before pop() and floor().
  bool empty() {
    while (taken_ == slot_.size() && near_.empty()) {
      while (current_ < used_ && heads_[current_] == kNone) ++current_;
      if (current_ < used_) {
        open_slot();
      } else if (later_.empty()) {
        return true;
      } else {
        bring_later();
      }
    }
    return false;
  }
  /// Nothing that waits has a lesser key.
  double floor() const {
    return taken_ < slot_.size() ? least_ + static_cast<double>(current_) * width_ : near_.top().key;
  }
  std::int32_t pop() { return taken_ < slot_.size() ? slot_[taken_++] : near_.pop().node; }
  /// The node that comes after `others` more, or -1: not known yet.
  std::int32_t coming(std::size_t others) const {
    return taken_ + others < slot_.size() ? slot_[taken_ + others] : kNone;
  }

 private:
  static constexpr std::int32_t kNone = -1;
  static constexpr std::size_t kSlots = std::size_t{1} << 16;
  struct Entry {
    std::int32_t node, next;
  };

  void lay_out(double least, double width) {
    least_ = least;
    width_ = width;
    per_width_ = 1 / width;
    current_ = used_ = 0;
    taken_ = slot_.size();
  }
  void open_slot() {
    slot_.clear();
    taken_ = 0;
    for (std::int32_t e = std::exchange(heads_[current_], kNone); e != kNone;) {
      const Entry& entry = entries_[static_cast<std::size_t>(e)];
      slot_.push_back(entry.node);
      e = entry.next;
    }
  }
  /// What lies beyond the slots, into wider ones.
  void bring_later() {
    std::vector<OpenNode> later;
    later.swap(later_);
    const auto by_key = [](const OpenNode& a, const OpenNode& b) { return a.key < b.key; };
    entries_.clear();
    lay_out(std::min_element(later.begin(), later.end(), by_key)->key, 2 * width_);
    for (const OpenNode& node : later) push(node);
  }

  OpenHeap near_;                    // pushed into the current slot
  std::vector<std::int32_t> slot_;   // nodes of the current one, in the order in which they are taken out
  std::size_t taken_ = 0;            // of these
  std::vector<std::int32_t> heads_;  // of the slots, into entries_
  std::vector<Entry> entries_;
  std::vector<OpenNode> later_;
  std::size_t current_ = 0, used_ = 0;
  double least_ = 0, width_ = 1, per_width_ = 1;
};

}  // namespace leastcost
