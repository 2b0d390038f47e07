// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace leastcost {

/// What is open, by its place in the order, in slots of one width: no order within a slot, last in first out, so that a
/// step costs the same however many wait. No proof rests on the order. A place is no greater than the key, a lower
/// bound of what may come of an entry; `floor()` is a lower bound of all open places. A place below the slot in hand
/// counts as in it: what comes from an entry of that slot cannot be less. Keeps its memory.
class WindowQueue {
 public:
  struct Entry {
    double place, key;
    std::int32_t id;
  };

  /// Empties it. Places are expected from `origin` on; `width` > 0 of the first slots.
  void begin(double origin, double width);
  void push(double place, double key, std::int32_t id) {
    const double slot = (place - origin_) * per_width_;
    if (!(slot < kSlots)) {
      later_.push_back({place, key, id});
      return;
    }
    std::size_t i = slot > 0 ? static_cast<std::size_t>(slot) : 0;
    if (i < current_) i = current_;
    if (i > highest_) highest_ = i;
    if (slots_[i].capacity() == 0 && !spare_.empty()) take_spare(slots_[i]);
    slots_[i].push_back({place, key, id});
    ++open_;
  }
  /// Goes to the next slot that holds anything; false when nothing is left. floor() is right from then on.
  bool settle() {
    while (slots_[current_].empty())
      if (!advance()) return false;
    return true;
  }
  /// After settle().
  Entry pop() {
    const Entry entry = slots_[current_].back();
    slots_[current_].pop_back();
    --open_;
    return entry;
  }
  double floor() const;
  /// Of all open entries; looks at each.
  double least_key() const;

 private:
  static constexpr std::size_t kSlots = 4096;
  bool advance();
  void take_spare(std::vector<Entry>& slot);

  std::vector<std::vector<Entry>> slots_{kSlots};
  std::vector<std::vector<Entry>> spare_;  // memory of slots that are done with, for those to come
  std::vector<Entry> later_, moved_;       // beyond the last slot
  double origin_ = 0, width_ = 1, per_width_ = 1;
  std::size_t current_ = 0, highest_ = 0, open_ = 0;
};

}  // namespace leastcost
