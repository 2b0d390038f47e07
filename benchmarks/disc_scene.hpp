// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <utility>

#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include "tests/adversarial/planning/judge/scene.hpp"

/// Discs of radius 0.3 to 1 at random in a square of side 10, from one of its corners to the opposite one: as a problem
/// and for a judge.
struct DiscScene {
  judge::Scene judged;
  leastcost::Problem problem;
};

/// `grain`: what coordinates and radii are rounded to; 0: nothing.
inline DiscScene disc_scene(unsigned seed, int count, double grain = 0) {
  using Eigen::Vector2d;
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> place(0, 10), size(0.3, 1);
  const auto rounded = [grain](double x) { return grain > 0 ? std::round(x / grain) * grain : x; };
  DiscScene scene;
  scene.judged.source = {0, 0};
  scene.judged.target = {10, 10};
  leastcost::FreeSpace::Obstacles discs;
  while (static_cast<int>(discs.size()) < count) {
    const double x = rounded(place(engine)), y = rounded(place(engine)), radius = rounded(size(engine));
    const Vector2d center(x, y);
    if (std::min(center.norm(), (center - Vector2d(10, 10)).norm()) < radius + 0.1) continue;
    discs.push_back(leastcost::make_ball({.center = center, .radius = radius}));
    scene.judged.things.push_back({judge::Thing::Kind::ball, radius, {{x, y}}});
  }
  const auto plane =
      std::make_shared<const leastcost::EuclideanManifold>(leastcost::EuclideanManifoldOptions{.dimension = 2});
  scene.problem.manifold = std::make_shared<const leastcost::FreeSpace>(plane, std::move(discs), 0);
  scene.problem.cost = leastcost::make_euclidean_cost(2);
  scene.problem.kernel = leastcost::make_kernel(leastcost::Expm1Square{});
  scene.problem.source = {Vector2d(0, 0)};
  scene.problem.target = {Vector2d(10, 10)};
  return scene;
}
