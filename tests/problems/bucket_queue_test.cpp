// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/graph/bucket_queue.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {

TEST_CASE("bucket queue: batches come in the order of their intervals and nothing is lost") {
  constexpr double kWidth = 0.25;
  Random random(5);
  for (const double widest : {0.0, 1.0, 1e3, 1e9}) {  // within the ring of buckets and far beyond it
    CAPTURE(widest);
    BucketQueue<int> queue(kWidth);
    std::vector<double> costs;
    std::vector<int> batch;
    std::vector<bool> seen;
    const auto push = [&](double least) {
      costs.push_back(least + (costs.size() % 7 == 0 ? 0 : random.uniform(0, widest)));
      queue.push(costs.back(), static_cast<int>(costs.size()) - 1);
      seen.push_back(false);
    };
    for (int k = 0; k < 100; ++k) push(0);
    double last = 0;
    while (queue.pop(batch)) {
      REQUIRE_FALSE(batch.empty());
      const double begin = std::floor(costs[static_cast<std::size_t>(batch[0])] / kWidth) * kWidth;
      REQUIRE(begin >= last);
      last = begin;
      for (const int item : batch) {
        const auto i = static_cast<std::size_t>(item);
        REQUIRE(std::floor(costs[i] / kWidth) * kWidth == begin);
        REQUIRE_FALSE(seen[i]);
        seen[i] = true;
        if (costs.size() < 20000)
          for (int k = 0; k < 2; ++k) push(costs[i] + kWidth);
      }
    }
    CHECK(costs.size() >= 20000);
    CHECK(std::count(seen.begin(), seen.end(), false) == 0);
  }
}

TEST_CASE("bucket queue: without a width items come one by one in order") {
  BucketQueue<int> queue(0);
  for (int k = 0; k < 100; ++k) queue.push(k * 37 % 100, k);
  CHECK_FALSE(queue.together(3, 3));
  std::vector<int> batch;
  for (int cost = 0; cost < 100; ++cost) {
    REQUIRE(queue.pop(batch));
    REQUIRE(batch.size() == 1);
    REQUIRE(batch[0] * 37 % 100 == cost);
  }
  CHECK_FALSE(queue.pop(batch));
}

TEST_CASE("bucket queue: a cost below what has been taken out comes next") {
  BucketQueue<int> queue(1);
  queue.push(1e7, 1);
  queue.push(1e7 + 5, 2);
  std::vector<int> batch;
  REQUIRE(queue.pop(batch));
  CHECK(batch == std::vector{1});
  queue.push(3, 3);
  queue.push(-1, 4);
  CHECK(queue.together(1e7 + 4.2, 1e7 + 4.9));
  REQUIRE(queue.pop(batch));
  CHECK(batch == std::vector{3, 4});
  REQUIRE(queue.pop(batch));
  CHECK(batch == std::vector{2});
}

}  // namespace leastcost::test
