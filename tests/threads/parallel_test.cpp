// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
//
// What threads may share: domains, costs, walls, a mesh with its tables. Each case solves in several threads at once
// and asks for the paths of one thread; the preset `tsan` also watches who writes what.
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include <leastcost/framework/replan/replanner.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include <leastcost/solvers/newton.hpp>
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/moving_discs.hpp"

namespace leastcost::test {
namespace {

constexpr int kThreads = 4;

/// What one thread finds, found again by all of them at once.
void check_in_threads(const std::function<Points()>& find) {
  std::vector<Points> found(kThreads);
  std::vector<std::thread> threads;
  threads.reserve(kThreads);
  for (Points& mine : found) threads.emplace_back([&] { mine = find(); });
  for (std::thread& thread : threads) thread.join();
  const Points once = find();  // afterwards: nothing is made ready for the threads
  REQUIRE(once.cols() > 1);
  for (const Points& mine : found) CHECK((mine.cols() == once.cols() && mine == once));
}

Problem open_problem(std::shared_ptr<const ConstraintManifold> domain, const Eigen::VectorXd& a,
                     const Eigen::VectorXd& b) {
  Problem problem;
  problem.source = project_end(*domain, a);
  problem.target = project_end(*domain, b);
  problem.cost = make_euclidean_cost(domain->dimensions().ambient);
  problem.kernel = make_kernel<Expm1Square>();
  problem.manifold = std::move(domain);
  return problem;
}

Points solved(const Problem& problem, const Initializer& initializer, const Solver& solver, FindOptions options) {
  return find_path(problem, initializer, solver, options).curve.x;
}

}  // namespace

TEST_CASE("threads: one world of discs, solved by newton and pulled tight") {
  const Problem problem = across(world_of(many_discs(40, 0.35, 3), 0.02));
  FindOptions options{.points = 40};
  check_in_threads([&] { return solved(problem, GridInitializer(), Newton(), options); });
  check_in_threads([&] { return solved(problem, RrtInitializer(), Lbfgs(), options); });
  options.post_processors = {std::make_shared<const TautPostProcessor>()};
  check_in_threads([&] { return solved(problem, GridInitializer(), Newton(), options); });
}

TEST_CASE("threads: one world of balls and boxes in space") {
  const auto space = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = 3});
  const FreeSpace::Obstacles obstacles{
      make_ball({Eigen::Vector3d(0.5, 0, 0), 0.2}),
      make_box_obstacle({Eigen::Vector3d(0.9, -0.2, -0.3), Eigen::Vector3d(1.1, 0.3, 0.2)})};
  const Problem problem = open_problem(std::make_shared<const FreeSpace>(space, obstacles, 0.01),
                                       Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1.5, 0, 0));
  FindOptions options{.points = 30, .post_processors = {std::make_shared<const TautPostProcessor>()}};
  check_in_threads([&] { return solved(problem, RrtInitializer(), Newton(), options); });
}

TEST_CASE("threads: arms that share the walls of their robot, and planners that share a world") {
  const auto arm = make_dh_arm({});
  const auto walls = std::make_shared<const RobotWalls>(
      arm, RobotWalls::Obstacles{make_ball({Eigen::Vector3d(0.55, 0, 0.45), 0.12})}, 0.02);
  const auto joints = std::make_shared<const EuclideanManifold>(
      EuclideanManifoldOptions{.dimension = 7, .box = {arm->kinematics->lower(), arm->kinematics->upper()}});
  Eigen::VectorXd a(7), b(7);
  a << -1.2, 0.4, 0, -1.8, 0, 2.2, 0.7;
  b << 1.2, 0.5, 0.1, -1.6, 0.2, 2.1, -0.5;
  const Problem problem = open_problem(std::make_shared<const FreeSpace>(joints, walls), a, b);
  check_in_threads([&] {
    FindOptions options{.points = 12};
    options.certificate.enabled = false;
    return solved(problem, RrtInitializer(), Newton(), options);
  });
  const Problem discs = across(world_of(many_discs(40, 0.3, 5), 0.02));
  check_in_threads([&] {
    Replanner planner(std::make_shared<Newton>(), std::make_shared<GridInitializer>(), FindOptions{.points = 20});
    planner.replan(discs);
    return planner.replan(discs).result.curve.x;
  });
}

TEST_CASE("threads: one mesh, its paths straightened and proved, and one exact search with a workspace each") {
  const auto mesh = std::make_shared<const MeshManifold>(TriangleMesh(sphere(3)));
  const Problem problem = open_problem(mesh, Eigen::Vector3d(0.1, 0.2, 0.97), Eigen::Vector3d(0.9, -0.3, -0.3));
  FindOptions options{.points = 20, .post_processors = {std::make_shared<const StraightenPostProcessor>()}};
  check_in_threads([&] { return solved(problem, DijkstraInitializer(), Newton(), options); });

  const TriangleMesh& triangles = mesh->mesh();
  const ExactSearch search(triangles);
  check_in_threads([&] {
    ExactSearch::Workspace workspace(search);
    Points distances(1, triangles.vertex_count());
    const ExactDistances all = search.distances({0, Eigen::Vector3d(1, 0, 0)}, workspace);
    for (Index i = 0; i < distances.cols(); ++i) distances(0, i) = all.at_most[static_cast<std::size_t>(i)];
    return distances;
  });
}

TEST_CASE("threads: one cloud, with a coarser version that the first who asks makes") {
  FindOptions options{.points = 20};
  const auto cloud = std::make_shared<const PointCloudManifold>(PointCloud(sphere_cloud(1000), {}));
  const Problem on_cloud = open_problem(cloud, Eigen::Vector3d(0.1, 0.2, 0.97), Eigen::Vector3d(0.9, -0.3, -0.3));
  check_in_threads([&] { return solved(on_cloud, DijkstraInitializer(), Newton(), options); });
}

}  // namespace leastcost::test
