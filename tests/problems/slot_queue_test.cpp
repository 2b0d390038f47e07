// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/slot_queue.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {

TEST_CASE("slot queue: what waits is never below the floor, comes out once, and nearly in order") {
  Random random;
  for (const double width : {1e-7, 0.01, 1.0, 1e9}) {
    CAPTURE(width);
    SlotQueue queue;
    for (int round = 0; round < 3; ++round) {  // it is used again
      queue.begin(5, width);
      std::vector<double> keys;
      std::vector<char> waits;
      const auto push = [&](double key) {
        queue.push({key, static_cast<std::int32_t>(keys.size())});
        keys.push_back(key);
        waits.push_back(1);
      };
      for (int i = 0; i < 50; ++i) push(5 + random.uniform(0, 3));
      double highest_floor = 5;
      std::array<std::int32_t, 3> announced{-1, -1, -1};  // of the next ones, those that the queue foretold
      std::size_t taken = 0;
      while (!queue.empty()) {
        const double floor = queue.floor();
        highest_floor = std::max(highest_floor, floor);
        const std::int32_t next = queue.coming(0), later = queue.coming(2), node = queue.pop();
        CHECK((next < 0 || next == node));
        CHECK((announced[taken % 3] < 0 || announced[taken % 3] == node));
        announced[(taken++ + 2) % 3] = later;
        REQUIRE(waits[static_cast<std::size_t>(node)] == 1);
        waits[static_cast<std::size_t>(node)] = 0;
        const double key = keys[static_cast<std::size_t>(node)];
        CHECK(key >= floor);
        CHECK(key >= highest_floor - 1e-12);
        if (keys.size() < 3000)
          for (int i = random.integer(0, 3); i > 0; --i) push(key + random.uniform(0, i == 3 ? 3000 : 0.3));
      }
      CHECK(std::count(waits.begin(), waits.end(), 1) == 0);
    }
  }
}

}  // namespace leastcost::test
