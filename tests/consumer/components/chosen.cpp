// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What is chosen in a box and on terrain; linked with several libraries in turn, so that some methods are not there.
#include <cstdio>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/refractive_index.hpp>
#include <leastcost/problems/manifolds/data/terrain.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/recipes/recommended.hpp>

namespace {

using namespace leastcost;

void print_choice(std::shared_ptr<const ConstraintManifold> domain, std::shared_ptr<const SegmentCost> cost) try {
  Problem problem;
  problem.manifold = std::move(domain);
  problem.cost = std::move(cost);
  problem.source.u = Eigen::Vector2d(2, 2.1);
  problem.target.u = Eigen::Vector2d(5, 5.9);
  for (const auto& why : recommended(problem, {.certificate = {.global = GlobalBudget{}}}).why) std::puts(why.c_str());
} catch (const InputError& error) {
  std::puts(error.what());
}

}  // namespace

int main() {
  const BoxOptions box{.lower = Eigen::Vector2d(0, 0), .upper = Eigen::Vector2d(8, 8)};
  print_choice(std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2, .box = box}),
               make_refractive_index_cost({.index = refraction::Formula{.n = "1 + 2 * exp(-x^2 - y^2)"}}, 2));
  RasterGrid heights;
  heights.rows = heights.columns = 8;
  heights.values.resize(64);
  print_choice(std::make_shared<TerrainManifold>(heights), make_euclidean_cost(3));
}
