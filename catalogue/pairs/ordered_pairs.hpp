// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include <leastcost/catalogue/pairs/pair_result.hpp>
#include "catalogue/pairs/pair_reader.hpp"

namespace leastcost {

/// Solves pairs in threads. At any time no more than a window of results is held, however many pairs there are.
struct OrderedPairs {
  std::function<std::optional<PairRow>()> next;     ///< called by one thread at a time; nothing: the end
  std::function<PairResult(const PairRow&)> solve;  ///< called by all threads
  std::function<void(PairResult)> done;             ///< called in the order of the pairs, by one thread at a time
  std::function<bool()> stop_requested;             ///< then no pair is begun, and results are given up; may be empty
  int threads = 1;
};

/// False when it was stopped before the end of the pairs. What any of the functions throws ends all of it and is thrown
/// again.
bool solve_in_order(const OrderedPairs& work);

}  // namespace leastcost
