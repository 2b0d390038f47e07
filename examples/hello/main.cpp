// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The fastest slide from (0, 0) to (pi, -2) under gravity 1: a cycloid, which takes pi seconds.
#include <cstdio>
#include <numbers>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/solvers/lbfgs.hpp>

int main() {
  using namespace leastcost;
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
  problem.source.u = Eigen::Vector2d(0, 0);
  problem.target.u = Eigen::Vector2d(std::numbers::pi, -2);
  problem.cost = make_travel_time_cost({.gravity = 1}, 2, problem.source.u);
  problem.kernel = make_kernel<Expm1Square>();

  const Result result = find_path(problem, StraightInitializer(), Lbfgs(), {.points = 40});
  std::printf("%s: %.4f s through %d points\n", result.certificate.certified() ? "certified" : "uncertified",
              result.certificate.estimate.value, static_cast<int>(result.path.u.cols()));
  return result.certificate.certified() ? 0 : 1;
}
