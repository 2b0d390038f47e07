// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/box.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>

/// Built-in arms among random balls and boxes, and an independent look at how far they are from them: kinematics and
/// distances are written again.
namespace leastcost::bench {

using Eigen::Vector3d;
using Vector = Eigen::VectorXd;

constexpr int kBalls = 5, kBoxes = 5;
constexpr double kArmClearance = 0.01;  ///< m
constexpr double kReach = 0.8;          ///< m: half of the cube around the shoulder in which obstacles stand
constexpr double kFromAxis = 0.3;       ///< m: from the vertical axis, where no arm could be free
constexpr double kPi = std::numbers::pi;

struct Thing {
  bool ball = true;
  Vector3d center = Vector3d::Zero(), half = Vector3d::Zero();  ///< of a ball the radius is half[0]
};

struct Arm {
  const char* name;
  std::shared_ptr<const Robot> robot;
  bool modified;
  std::vector<std::array<double, 3>> rows;  ///< a, alpha, d: written again, for the look that shares nothing
};

inline std::vector<Arm> arms() {
  return {{"Panda",
           make_dh_arm({}),
           true,
           {{0, 0, 0.333},
            {0, -kPi / 2, 0},
            {0, kPi / 2, 0.316},
            {0.0825, kPi / 2, 0},
            {-0.0825, -kPi / 2, 0.384},
            {0, kPi / 2, 0},
            {0.088, kPi / 2, 0.107}}},
          {"UR5",
           make_dh_arm({.model = arm_model::Ur5{}}),
           false,
           {{0, kPi / 2, 0.089159},
            {-0.425, 0, 0},
            {-0.39225, 0, 0},
            {0, kPi / 2, 0.10915},
            {0, -kPi / 2, 0.09465},
            {0, 0, 0.0823}}}};
}

inline Eigen::Affine3d own_link(const Arm& arm, const Vector& q, int link) {
  using Eigen::AngleAxisd, Eigen::Translation3d;
  Eigen::Affine3d frame = Eigen::Affine3d::Identity();
  for (int j = 0; j < link; ++j) {
    const auto& row = arm.rows[static_cast<std::size_t>(j)];
    const Translation3d along_x(row[0], 0, 0), along_z(0, 0, row[2]);
    const AngleAxisd about_x(row[1], Vector3d::UnitX()), about_z(q[j], Vector3d::UnitZ());
    frame =
        arm.modified ? frame * about_x * along_x * about_z * along_z : frame * about_z * along_z * along_x * about_x;
  }
  return frame;
}

/// The least of a convex function on [0, 1], by golden sections.
template <class Function>
double least_convex(const Function& f) {
  constexpr double kGolden = 0.6180339887498949;
  double from = 0, to = 1, a = 1 - kGolden, b = kGolden, fa = f(a), fb = f(b);
  for (int k = 0; k < 60; ++k) {
    if (fa < fb) {
      to = b, b = a, fb = fa, a = to - kGolden * (to - from), fa = f(a);
    } else {
      from = a, a = b, fa = fb, b = from + kGolden * (to - from), fb = f(b);
    }
  }
  return std::min({fa, fb, f(0.0), f(1.0)});
}

inline double own_distance(const Vector3d& x, const Thing& thing) {
  if (thing.ball) return (x - thing.center).norm() - thing.half[0];
  return ((x - thing.center).cwiseAbs() - thing.half).cwiseMax(0).norm();
}

/// How far an arm is from what it must not touch, less what is required.
inline double own_gap(const Arm& arm, const std::vector<Thing>& things, const Vector& q) {
  double least = 1e9;
  std::vector<std::pair<Vector3d, Vector3d>> axes;
  for (const Capsule& capsule : arm.robot->capsules) {
    const Eigen::Affine3d frame = own_link(arm, q, capsule.link);
    axes.emplace_back(frame * capsule.from, frame * capsule.to);
    if (capsule.link == 0) continue;
    const auto at = [&](double s) -> Vector3d {
      return axes.back().first + s * (axes.back().second - axes.back().first);
    };
    for (const Thing& thing : things) {
      const double middle = own_distance(at(0.5), thing), half = (axes.back().second - axes.back().first).norm() / 2;
      if (middle - half - capsule.radius - kArmClearance > 0.1) continue;
      least = std::min(
          least, least_convex([&](double s) { return own_distance(at(s), thing); }) - capsule.radius - kArmClearance);
    }
  }
  for (const auto& [i, j] : arm.robot->self) {
    const auto &first = axes[static_cast<std::size_t>(i)], &second = axes[static_cast<std::size_t>(j)];
    const double required = arm.robot->capsules[static_cast<std::size_t>(i)].radius +
                            arm.robot->capsules[static_cast<std::size_t>(j)].radius;
    const Vector3d way = second.second - second.first;
    const auto from_second = [&](double s) {
      const Vector3d x = first.first + s * (first.second - first.first);
      const double square = way.squaredNorm();
      const double t = square > 0 ? std::clamp((x - second.first).dot(way) / square, 0.0, 1.0) : 0;
      return (x - second.first - t * way).norm();
    };
    least = std::min(least, least_convex(from_second) - required);
  }
  return least;
}

struct Query {
  std::vector<Thing> things, moved;
  Vector source, target;
};

/// Obstacles that have `moved` go that far, each its own way.
inline Query query_of(const Arm& arm, unsigned seed, double moved) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> unit(0, 1), size(0.04, 0.12);
  Query query;
  for (int i = 0; i < kBalls + kBoxes; ++i) {
    Thing thing;
    thing.ball = i < kBalls;
    do thing.center = Vector3d::NullaryExpr([&] { return kReach * (2 * unit(engine) - 1); }) + Vector3d(0, 0, 0.4);
    while (thing.center.head<2>().norm() < kFromAxis);
    thing.half = Vector3d::NullaryExpr([&] { return size(engine); });
    query.things.push_back(thing);
    thing.center += moved * Vector3d::NullaryExpr([&] { return 2 * unit(engine) - 1; }).normalized();
    query.moved.push_back(thing);
  }
  const Vector lower = arm.robot->kinematics->lower().cwiseMax(-kPi),
               upper = arm.robot->kinematics->upper().cwiseMin(kPi);
  const auto free_end = [&]() -> Vector {
    for (int k = 0; k < 1000; ++k) {
      const Vector q = Vector::NullaryExpr(
          lower.size(), [&](Eigen::Index i) { return lower[i] + unit(engine) * (upper[i] - lower[i]); });
      if (std::min(own_gap(arm, query.things, q), own_gap(arm, query.moved, q)) > 0.001) return q;
    }
    return {};
  };
  query.source = free_end();
  query.target = free_end();
  return query;
}

inline Problem problem_of(const Arm& arm, const Query& query, const std::vector<Thing>* things) {
  const Kinematics& kinematics = *arm.robot->kinematics;
  Problem problem;
  const auto dimension = static_cast<int>(kinematics.dimension());
  std::shared_ptr<const ConstraintManifold> space =
      std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = dimension});
  if (things != nullptr) {
    RobotWalls::Obstacles obstacles;
    for (const Thing& thing : *things)
      obstacles.push_back(thing.ball ? make_ball({thing.center, thing.half[0]})
                                     : make_box_obstacle({thing.center - thing.half, thing.center + thing.half}));
    space = std::make_shared<const EuclideanManifold>(
        EuclideanManifoldOptions{.dimension = dimension, .box = {kinematics.lower(), kinematics.upper()}});
    space = std::make_shared<const FreeSpace>(space,
                                              std::make_shared<const RobotWalls>(arm.robot, obstacles, kArmClearance));
  }
  problem.manifold = space;
  problem.cost = make_euclidean_cost(dimension);
  problem.kernel = make_kernel(Expm1Square{});
  problem.source = {query.source};
  problem.target = {query.target};
  return problem;
}

}  // namespace leastcost::bench
