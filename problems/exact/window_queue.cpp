// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/window_queue.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace leastcost {
namespace {

constexpr double kWiden = 8;  // slots of what was beyond the last one
constexpr double kSlotRounding = 8 * std::numeric_limits<double>::epsilon();

}  // namespace

void WindowQueue::begin(double origin, double width) {
  if (open_ > 0)
    for (std::size_t i = current_; i <= highest_; ++i) slots_[i].clear();
  later_.clear();
  origin_ = origin;
  width_ = width;
  per_width_ = 1 / width;
  current_ = highest_ = open_ = 0;
}

double WindowQueue::floor() const {
  const double offset = width_ * static_cast<double>(current_);
  return origin_ + offset - kSlotRounding * (std::abs(origin_) + offset);
}

double WindowQueue::least_key() const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = current_; i <= highest_; ++i)
    for (const Entry& entry : slots_[i]) least = std::min(least, entry.key);
  for (const Entry& entry : later_) least = std::min(least, entry.key);
  return least;
}

void WindowQueue::take_spare(std::vector<Entry>& slot) {
  slot.swap(spare_.back());
  spare_.pop_back();
}

/// The slot after one that is empty, or what was beyond the last one in wider slots.
bool WindowQueue::advance() {
  if (open_ > 0) {
    while (slots_[current_].empty()) {
      if (slots_[current_].capacity() > 0) spare_.push_back(std::move(slots_[current_]));
      slots_[current_++] = {};
    }
    return true;
  }
  if (later_.empty()) return false;
  moved_.swap(later_);
  later_.clear();
  double least = moved_.front().place;
  for (const Entry& entry : moved_) least = std::min(least, entry.place);
  begin(std::max(least, floor()), width_ * kWiden);
  for (const Entry& entry : moved_) push(entry.place, entry.key, entry.id);
  moved_.clear();
  return true;
}

}  // namespace leastcost
