// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// First paths by a random tree across the torus (radii 2 and 1): target below 0.2 s. The argument: steps per distance
// of the ends, a finer tree. And the nearest of n points in space, by the tree that grows and by looking at each.
#include <benchmark/benchmark.h>

#include <random>

#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include "problems/initializers/growing_points.hpp"

namespace {

using namespace leastcost;

void across_torus(benchmark::State& state) {
  const ImplicitManifoldOptions torus{.surface = implicit::Torus{}};
  Problem problem{make_implicit_manifold(torus), make_euclidean_cost(3), make_kernel<Expm1Square>(), {}, {}, false};
  problem.source.u = Eigen::Vector3d(3, 0, 0);
  problem.target.u = Eigen::Vector3d(-3, 0, 0);
  RrtOptions options;
  options.step = 6.0 / static_cast<double>(state.range(0));
  options.max_nodes = 1000000;
  int seed = 0;
  for (auto _ : state) {
    options.seed = seed++;  // the mean over trees, not one of them
    benchmark::DoNotOptimize(RrtInitializer(options).first_path(problem, {}).path.u.data());
  }
}
BENCHMARK(across_torus)->Arg(16)->Arg(64)->Arg(256)->Unit(benchmark::kMillisecond);

std::vector<Eigen::VectorXd> random_points(int count) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform;
  std::vector<Eigen::VectorXd> points(static_cast<std::size_t>(count));
  for (Eigen::VectorXd& p : points) p = Eigen::Vector3d(uniform(engine), uniform(engine), uniform(engine));
  return points;
}

void nearest_in_tree(benchmark::State& state) {
  const std::vector<Eigen::VectorXd> points = random_points(static_cast<int>(state.range(0))),
                                     queries = random_points(1024);
  GrowingPoints tree(3);
  for (const Eigen::VectorXd& p : points) tree.add(p);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(tree.nearest(queries[i++ % queries.size()]));
}
BENCHMARK(nearest_in_tree)->Arg(100)->Arg(1000)->Arg(10000)->Arg(100000);

void nearest_of_all(benchmark::State& state) {
  const std::vector<Eigen::VectorXd> points = random_points(static_cast<int>(state.range(0))),
                                     queries = random_points(1024);
  Points all(3, state.range(0));
  for (Eigen::Index i = 0; i < all.cols(); ++i) all.col(i) = points[static_cast<std::size_t>(i)];
  std::size_t i = 0;
  for (auto _ : state) {
    Eigen::Index at = 0;
    const Eigen::Vector3d q = queries[i++ % queries.size()];
    (all.colwise() - q).colwise().squaredNorm().minCoeff(&at);
    benchmark::DoNotOptimize(at);
  }
}
BENCHMARK(nearest_of_all)->Arg(100)->Arg(1000)->Arg(10000)->Arg(100000);

}  // namespace
