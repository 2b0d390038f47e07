// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// A path through a lens in a box, and a bound that no path in the box costs a part in a thousand less.
#include <cstdio>

#include <leastcost/leastcost.hpp>

int main() {
  using namespace leastcost;
  const BoxOptions box{.lower = Eigen::Vector2d(-3, -3), .upper = Eigen::Vector2d(3, 3)};
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2, .box = box});
  problem.cost = make_refractive_index_cost({.index = refraction::Formula{.n = "1 + 2 * exp(-x^2 - y^2)"}}, 2);
  problem.source.u = Eigen::Vector2d(-2, 0.1);
  problem.target.u = Eigen::Vector2d(2, -0.1);
  const Result path = find_path(problem, {.certificate = {.global = GlobalBudget{.tolerance = 1e-3}}});
  const GlobalBound& bound = path.certificate.global.value();
  std::printf("%s: %.5f, no path below %.5f\n", word_of(bound.outcome).data(), path.curve.cost, bound.lower_bound);
  return bound.proved ? 0 : 1;
}
