// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/pairs/ordered_pairs.hpp"

#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace leastcost {
namespace {

/// Results that may wait for an earlier one, per thread: a pair that takes long holds up no other thread meanwhile.
constexpr long kWindowPerThread = 256;

class Crew {
 public:
  explicit Crew(const OrderedPairs& work) : work_(work), window_(kWindowPerThread * work.threads) {}

  bool run() {
    std::vector<std::thread> others;
    try {
      for (int i = 1; i < work_.threads; ++i) others.emplace_back([this] { serve(); });
    } catch (...) {
      fail(std::current_exception());
    }
    serve();
    for (std::thread& thread : others) thread.join();
    if (error_) std::rethrow_exception(error_);
    return !stopped_;
  }

 private:
  bool stop_requested() const { return work_.stop_requested && work_.stop_requested(); }

  void serve() {
    try {
      while (const std::optional<PairRow> row = take()) {
        PairResult result = work_.solve(*row);
        // What was solved after the request may have been cut short by it.
        if (stop_requested()) return stop();
        deliver(row->number, std::move(result));
      }
    } catch (...) {
      fail(std::current_exception());
    }
  }

  std::optional<PairRow> take() {
    std::unique_lock lock(mutex_);
    moved_.wait(lock, [this] { return ended_ || in_hand_ < window_; });
    if (!ended_ && stop_requested()) stopped_ = ended_ = true;
    std::optional<PairRow> row;
    if (!ended_) row = work_.next();
    if (!row) {
      ended_ = true;
      moved_.notify_all();
      return std::nullopt;
    }
    if (first_) next_ = row->number;
    first_ = false;
    ++in_hand_;
    return row;
  }

  void deliver(long number, PairResult result) {
    const std::lock_guard lock(mutex_);
    waiting_.emplace(number, std::move(result));
    for (auto at = waiting_.begin(); at != waiting_.end() && at->first == next_; at = waiting_.begin()) {
      work_.done(std::move(at->second));
      waiting_.erase(at);
      ++next_;
      --in_hand_;
    }
    moved_.notify_all();
  }

  void stop() {
    const std::lock_guard lock(mutex_);
    stopped_ = ended_ = true;
    moved_.notify_all();
  }

  void fail(std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::move(error);
    ended_ = true;
    moved_.notify_all();
  }

  const OrderedPairs& work_;
  const long window_;
  std::mutex mutex_;
  std::condition_variable moved_;
  std::map<long, PairResult> waiting_;  // for an earlier one
  long next_ = 0;                       // to be delivered
  long in_hand_ = 0;                    // taken, and not delivered
  bool first_ = true, ended_ = false, stopped_ = false;
  std::exception_ptr error_;
};

}  // namespace

bool solve_in_order(const OrderedPairs& work) { return Crew(work).run(); }

}  // namespace leastcost
