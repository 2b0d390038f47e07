// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "app/pairs/pair_line.hpp"
#include "app/pairs/pair_reader.hpp"

namespace leastcost::app {

/// Solves pairs in threads. At any time no more than a window of lines is held, however many pairs there are.
struct OrderedPairs {
  PairReader& reader;
  std::function<PairLine(const PairRow&)> solve;  ///< called by all threads
  std::function<void(PairLine)> line;             ///< called in the order of the pairs, by one thread at a time
  std::function<bool()> stop_requested;           ///< then no pair is begun, and lines are given up
  int threads = 1;
};

/// False when it was stopped before the end of the pairs. What any of the functions throws ends all of it and is thrown
/// again.
bool solve_in_order(const OrderedPairs& work);

}  // namespace leastcost::app
