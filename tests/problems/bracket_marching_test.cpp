// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "problems/bracket/search/fast_marching.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using namespace bracket;

/// Of so many nodes, and infinite for others.
std::vector<double> rough(std::size_t count, Random& random) {
  std::vector<double> out(count + 1, kInfinity);
  for (std::size_t k = 0; k < count; ++k) out[k] = std::exp(random.uniform(-1, 1));
  return out;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (a[k] != b[k]) largest = std::max(largest, std::abs(a[k] - b[k]) / b[k]);
  return largest;
}

}  // namespace

/// However little two densities have to do with each other.
TEMPLATE_TEST_CASE("bracket: a march that follows the order of another one comes to the same", "", AllNodes, NodeSet) {
  Random random;
  const std::function<bool()> never;
  const StopLook look(never);
  FastMarching marching(look);
  for (int k = 0; k < 15; ++k) {
    bracket::Place<TestType::kDimension> cells;
    for (int& count : cells) count = random.integer(3, TestType::kDimension == 2 ? 60 : 16);
    const TestType nodes(cells);
    const std::vector<double> first = rough(nodes.size(), random), second = rough(nodes.size(), random);
    const std::vector<int> seeds = {random.integer(0, nodes.none() - 1)};
    std::vector<double> start(nodes.size() + 1, kInfinity);
    start[static_cast<std::size_t>(seeds[0])] = 0;
    std::vector<int> order, other_order;
    std::vector<double> u = start, followed = start;
    marching.run(nodes, 1, first, seeds, u, order);
    u = start;
    marching.run(nodes, 1, second, seeds, u, other_order);
    marching.follow(nodes, 1, second, order, followed);
    CHECK(largest_difference(followed, u) < 1e-9);
  }
}

}  // namespace leastcost::test
