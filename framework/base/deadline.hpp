// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {

/// When work is given up: at a time, once a stop is requested, or never. A time alone converts; Monitor::limit() makes
/// one that hears a stop request too. Holds on to the function that it asks, and remembers when it has asked: it is for
/// one thread.
class Deadline {
 public:
  using Clock = std::chrono::steady_clock;

  /// Never.
  Deadline() = default;
  Deadline(Clock::time_point time) : time_(time) {}  // NOLINT(google-explicit-constructor)
  /// At that time, if there is one, or once `stop_requested` says so. The function must outlive it; an empty one is
  /// not asked.
  Deadline(const std::optional<Clock::time_point>& time, const std::function<bool()>& stop_requested)
      : time_(time), stop_requested_(stop_requested ? &stop_requested : nullptr) {
    if (stop_requested_ != nullptr) next_question_ = Clock::now() + kBetweenQuestions;
  }
  Deadline(const std::optional<Clock::time_point>&, std::function<bool()>&&) = delete;

  /// When the time budget ends; nothing: never.
  const std::optional<Clock::time_point>& time() const { return time_; }
  /// The same, where there is such a time.
  const Clock::time_point& operator*() const { return *time_; }
  /// Whether there is anything that may end the work.
  explicit operator bool() const { return time_.has_value() || stop_requested_ != nullptr; }
  /// Whether the time is over.
  bool is_over(Clock::time_point now) const { return time_ && now >= *time_; }
  /// Whether a stop is requested. The function is asked a millisecond after the last question, or after this was made:
  /// it may be dear (that of Python has to wait for other threads), and whoever begins a pass asks before it.
  bool is_stopped(Clock::time_point now) const {
    if (stop_requested_ == nullptr || now < next_question_) return false;
    next_question_ = now + kBetweenQuestions;
    return (*stop_requested_)();
  }
  /// Whether to give up by now, for what must not throw.
  bool has_ended() const {
    if (!*this) return false;
    const Clock::time_point now = Clock::now();
    return is_over(now) || is_stopped(now);
  }
  /// This one with the time of another, where it has none of its own.
  Deadline or_time_of(const Deadline& other) const {
    Deadline both = *this;
    if (!both.time_) both.time_ = other.time_;
    return both;
  }

 private:
  static constexpr std::chrono::milliseconds kBetweenQuestions{1};

  std::optional<Clock::time_point> time_;
  const std::function<bool()>* stop_requested_ = nullptr;
  mutable Clock::time_point next_question_;
};

/// Throws Interrupted once the deadline has passed, or a stop is requested. For the midst of long passes, whose work is
/// then thrown away.
inline void look_at_clock(const Deadline& deadline) {
  if (!deadline) return;
  const Deadline::Clock::time_point now = Deadline::Clock::now();
  if (deadline.is_over(now)) throw Interrupted("the time budget is used up");
  if (deadline.is_stopped(now)) throw Interrupted("a stop was requested");
}

/// The same at every 1024th step of a loop whose steps take a microsecond or less.
inline void look_at_clock(const Deadline& deadline, std::int64_t step) {
  constexpr std::int64_t kSteps = 1024;
  if (step % kSteps == 0) look_at_clock(deadline);
}

}  // namespace leastcost
