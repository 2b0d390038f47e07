// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <random>
#include <vector>

#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/robots/robot.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include "tests/support/catch.hpp"

namespace leastcost::test {

/// What RobotWalls relies on, at random configurations: frames are rotations and follow their derivatives, points stay
/// within their reach, and a clearance holds at every place of a move.
inline void check_robot(const std::shared_ptr<const Robot>& robot) {
  using Configuration = Eigen::VectorXd;
  const Kinematics& kinematics = *robot->kinematics;
  const Eigen::Index d = kinematics.dimension();
  REQUIRE((kinematics.space() == 2 || kinematics.space() == 3));
  REQUIRE(kinematics.lower().size() == d);
  REQUIRE(kinematics.upper().size() == d);
  CHECK((kinematics.lower().array() <= kinematics.upper().array()).all());
  REQUIRE_FALSE(robot->capsules.empty());

  std::mt19937 engine(20261202);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto random_configuration = [&]() -> Configuration {
    Configuration x = Configuration::NullaryExpr(d, [&] { return place(engine); });
    return x.cwiseMax(kinematics.lower()).cwiseMin(kinematics.upper());
  };
  std::vector<Frame> links, moved;
  Eigen::Matrix3Xd derivative;
  const Configuration center = Configuration::Constant(kinematics.space(), 0.7);
  const RobotWalls walls(robot, {make_ball({center, 0.2})}, 0.01);
  constexpr int kMoves = 50, kPlaces = 50;
  for (int k = 0; k < kMoves; ++k) {
    const Configuration a = random_configuration(), b = random_configuration();
    kinematics.place(a, links);
    REQUIRE(static_cast<int>(links.size()) == kinematics.link_count());
    for (const Frame& link : links) {
      CHECK((link.rotation * link.rotation.transpose()).isIdentity(1e-13));
      CHECK(link.rotation.determinant() > 0);
    }
    constexpr double kStep = 1e-7;
    const Configuration way = (b - a).normalized();
    kinematics.place(a + kStep * way, moved);
    for (const Capsule& capsule : robot->capsules) {
      const auto link = static_cast<std::size_t>(capsule.link);
      const Eigen::Vector3d here = links[link].at(capsule.to), there = moved[link].at(capsule.to);
      kinematics.jacobian(a, links, capsule.link, here, derivative);
      REQUIRE(derivative.cols() == d);
      CHECK((there - here - kStep * derivative * way).norm() < 1e-12);
      CHECK_FALSE(kinematics.link_name(capsule.link).empty());
    }
    const MoveClearance found = walls.clearance(a, b);
    CHECK(found.proved);
    for (int i = 0; i <= kPlaces; ++i) {
      const Configuration x = a + (b - a) * i / kPlaces;
      CHECK(walls.clearance(x, x).upper >= found.lower);
    }
  }
}

}  // namespace leastcost::test
