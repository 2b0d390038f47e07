// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// An arm of seven joints past a ball: the shortest way in its joint angles, clear at every place of it.
#include <cstdio>

#include <leastcost/leastcost.hpp>

int main() {
  using namespace leastcost;
  const auto arm = make_dh_arm({.model = arm_model::Panda{}});
  const BoxOptions limits{.lower = arm->kinematics->lower(), .upper = arm->kinematics->upper()};
  const auto joints = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 7, .box = limits});
  FreeSpace::Obstacles ball = {make_ball({.center = Eigen::Vector3d(0.55, 0, 0.45), .radius = 0.12})};
  Problem problem;
  problem.manifold = std::make_shared<FreeSpace>(joints, std::make_shared<RobotWalls>(arm, std::move(ball), 0.02));
  problem.cost = make_euclidean_cost(7);
  problem.source.u = Eigen::Vector<double, 7>(-1.2, 0.4, 0, -1.8, 0, 2.2, 0.7);
  problem.target.u = Eigen::Vector<double, 7>(1.2, 0.5, 0.1, -1.6, 0.2, 2.1, -0.5);
  const Result path = find_path(problem, {.points = 50});
  if (!path.certificate.clearance) return 1;
  std::printf("%.4f rad, %.4f m beside the margin\n", path.curve.cost, path.certificate.clearance->lower);
  return path.certificate.clearance->lower >= -1e-9 ? 0 : 1;
}
