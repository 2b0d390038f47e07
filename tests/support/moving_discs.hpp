// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>

/// A world of discs that changes, and a check of paths in it that shares nothing with the library's.
namespace leastcost::test {

struct Disc {
  double x, y, r;
};
using Discs = std::vector<Disc>;

/// Ten discs at rest and one that goes around among them, once in 400 steps.
inline Discs eleven_discs(int step) {
  Discs discs{{2, 3.9, .8}, {2.2, 6.4, .7}, {4, 5.2, .6}, {6, 3.8, .9}, {6.3, 6.6, .8},
              {8, 5.1, .5}, {4.2, 2.2, .8}, {4.4, 8, .8}, {8, 2.5, .7}, {8, 7.5, .7}};
  const double turn = 2 * std::numbers::pi * step / 400;
  discs.push_back({5.5 + 1.2 * std::cos(turn), 5.5 + 1.5 * std::sin(turn), .4});
  return discs;
}

/// All of them in motion, each on a small circle of its own.
inline Discs all_moving(int step) {
  Discs discs = eleven_discs(step);
  for (std::size_t i = 0; i + 1 < discs.size(); ++i) {
    const double turn = 2 * std::numbers::pi * step / (300.0 + 37.0 * static_cast<double>(i)) + static_cast<double>(i);
    discs[i].x += 0.3 * std::cos(turn);
    discs[i].y += 0.3 * std::sin(turn);
  }
  return discs;
}

/// Small ones all over a square of side 10, which leave the ends free.
inline Discs many_discs(int count, double radius, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> along(0, 10);
  Discs discs;
  while (static_cast<int>(discs.size()) < count) {
    const Disc disc{along(random), along(random), radius};
    if (std::hypot(disc.x - 0.5, disc.y - 5) > 2 * radius && std::hypot(disc.x - 9.5, disc.y - 5) > 2 * radius)
      discs.push_back(disc);
  }
  return discs;
}

inline std::shared_ptr<const ConstraintManifold> world_of(const Discs& discs, double clearance) {
  FreeSpace::Obstacles obstacles;
  for (const Disc& disc : discs)
    obstacles.push_back(make_ball({.center = Eigen::Vector2d(disc.x, disc.y), .radius = disc.r}));
  return std::make_shared<FreeSpace>(std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2}),
                                     std::move(obstacles), clearance);
}

/// The shortest way from left to right.
inline Problem across(std::shared_ptr<const ConstraintManifold> world) {
  Problem problem;
  problem.manifold = std::move(world);
  problem.cost = make_euclidean_cost(2);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = Eigen::Vector2d(0.5, 5);
  problem.target.u = Eigen::Vector2d(9.5, 5);
  return problem;
}

/// The least distance of the moves of a polyline from the discs: negative where one is entered.
inline double clearance_of(const Points& x, const Discs& discs) {
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i + 1 < x.cols(); ++i) {
    const double ax = x(0, i), ay = x(1, i), bx = x(0, i + 1) - ax, by = x(1, i + 1) - ay, length = bx * bx + by * by;
    for (const Disc& disc : discs) {
      const double along = (disc.x - ax) * bx + (disc.y - ay) * by;
      const double t = length > 0 ? std::min(1.0, std::max(0.0, along / length)) : 0;
      least = std::min(least, std::hypot(ax + t * bx - disc.x, ay + t * by - disc.y) - disc.r);
    }
  }
  return least;
}

}  // namespace leastcost::test
