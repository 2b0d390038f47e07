// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The shortest way around what only the user's own signed distance knows: here a capsule, 0.1 away from it.
#include <algorithm>
#include <cstdio>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/checker_walls.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/solvers/newton.hpp>

using namespace leastcost;

/// Of the capsule of radius 0.5 around the segment from (0, -1) to (0, 1).
double capsule(const Eigen::VectorXd& x) { return (x - Eigen::Vector2d(0, std::clamp(x[1], -1.0, 1.0))).norm() - 0.5; }

int main() {
  // A true distance: its Lipschitz constant is 1, and 0.5 from the segment it is bent by at most 1 / 0.5.
  const DistanceChecker checker{
      .distance = capsule, .curvature = 1 / 0.5, .clearance = 0.1, .size = 4, .name = "the capsule"};
  Problem problem;
  const auto plane = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
  problem.manifold = std::make_shared<FreeSpace>(plane, make_checker_walls(2, checker));
  problem.cost = make_euclidean_cost(2);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = Eigen::Vector2d(-2, 0);
  problem.target.u = Eigen::Vector2d(2, 0.3);

  const Result result = find_path(problem, RrtInitializer(), Newton(), {.points = 100});
  std::printf("%s: length %.4f\n", result.certificate.certified() ? "certified" : "uncertified", result.curve.cost);
  if (const auto& clearance = result.certificate.clearance)
    std::printf("%.2g more than the clearance from %s\n", clearance->upper, clearance->obstacle.c_str());
  return result.certificate.certified() ? 0 : 1;
}
