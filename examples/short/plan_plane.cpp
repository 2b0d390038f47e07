// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The shortest way in the plane around discs, proved; the planner keeps 5 cm away from them.
#include <cstdio>

#include <leastcost/leastcost.hpp>

int main() {
  using namespace leastcost;
  FreeSpace::Obstacles discs;
  for (const double x : {2.0, 4.0, 6.0})
    discs.push_back(make_ball({.center = Eigen::Vector2d(x, x == 4 ? -0.4 : 0.4), .radius = 0.8}));
  const auto plane = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
  Problem problem;
  problem.manifold = std::make_shared<FreeSpace>(plane, std::move(discs), 0.05);
  problem.cost = make_euclidean_cost(2);
  problem.source.u = Eigen::Vector2d(0, 0);
  problem.target.u = Eigen::Vector2d(8, 0);
  const Result path = find_path(problem);
  std::printf("%s: %.6f m\n", word_of(path.certificate.scope).data(), path.curve.cost);
  return path.certificate.certified() ? 0 : 1;
}
