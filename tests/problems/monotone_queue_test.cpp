// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/graph/monotone_queue.hpp"

#include <functional>
#include <limits>
#include <queue>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {

TEST_CASE("monotone queue: costs come out in the order of a binary heap") {
  Random random(3);
  for (const double widest : {0.0, 1e-3, 1.0, 1e6}) {
    CAPTURE(widest);
    MonotoneQueue<int> queue;
    std::priority_queue<double, std::vector<double>, std::greater<>> heap;
    double least = 0;
    for (int k = 0; k < 20000; ++k) {
      const bool push = heap.empty() || random.uniform(0, 1) < (k < 10000 ? 0.7 : 0.3);
      if (push) {
        const double step = k % 7 == 0 ? 0 : random.uniform(0, widest);  // equal ones too
        queue.push(least + step, k);
        heap.push(least + step);
        continue;
      }
      const double cost = queue.pop().first;
      REQUIRE(cost == heap.top());
      heap.pop();
      least = cost;
    }
    while (!heap.empty()) {
      REQUIRE_FALSE(queue.empty());
      REQUIRE(queue.pop().first == heap.top());
      heap.pop();
    }
    CHECK(queue.empty());
  }
}

TEST_CASE("monotone queue: items stay with their costs, and what cannot be reached comes last") {
  MonotoneQueue<int> queue;
  for (int k = 0; k < 100; ++k) queue.push(k * 37 % 100, k);
  queue.push(std::numeric_limits<double>::infinity(), -1);
  for (int cost = 0; cost < 100; ++cost) {
    const auto [least, item] = queue.pop();
    REQUIRE(least == cost);
    REQUIRE(item * 37 % 100 == cost);
  }
  CHECK(queue.pop().second == -1);
}

TEST_CASE("monotone queue: a cost below what has been taken out comes next, and as it is") {
  MonotoneQueue<int> queue;
  for (int k = 0; k < 100; ++k) queue.push(1 + 0.01 * k, k);
  for (int k = 0; k < 50; ++k) queue.pop();
  queue.push(0.5, -1);
  CHECK(queue.pop() == std::pair(0.5, -1));
  CHECK(queue.pop().second == 50);
}

}  // namespace leastcost::test
