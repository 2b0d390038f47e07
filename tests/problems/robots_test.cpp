// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/rigid_body.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include "problems/robots/segment_distance.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/trials.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using RobotVector = Eigen::VectorXd;
using RobotPtr = std::shared_ptr<const Robot>;

constexpr double kPi = std::numbers::pi;

RobotPtr panda_arm() { return make_dh_arm({}); }
RobotPtr ur5_arm() { return make_dh_arm({.model = arm_model::Ur5{}}); }

RobotPtr planar_body() {
  Eigen::MatrixXd shape(2, 5);
  shape << -0.3, 0.1, 0.5, 0.2, 0.1,  //
      0.5, 0.2, 0.5, 0.2, 0.25;
  return make_rigid_body({shape});
}

RobotPtr spatial_body() {
  Eigen::MatrixXd shape(2, 7);
  shape << -0.3, 0.1, 0, 0.5, 0.2, 0.1, 0.1,  //
      0.2, -0.4, 0.3, 0.2, -0.4, 0.3, 0.15;
  return make_rigid_body({shape});
}

std::vector<RobotPtr> all_robots() { return {panda_arm(), ur5_arm(), planar_body(), spatial_body()}; }

/// Within the limits of joints; a body somewhere about, with any quaternion of about length one.
RobotVector random_configuration(const Kinematics& kinematics, std::mt19937& engine) {
  std::uniform_real_distribution<double> unit(0, 1);
  const RobotVector lower = kinematics.lower().cwiseMax(-1.5), upper = kinematics.upper().cwiseMin(1.5);
  RobotVector x = lower;
  for (Eigen::Index i = 0; i < x.size(); ++i)
    x[i] = kinematics.lower()[i] > -10
               ? kinematics.lower()[i] + unit(engine) * (kinematics.upper()[i] - kinematics.lower()[i])
               : lower[i] + unit(engine) * (upper[i] - lower[i]);
  if (x.size() == 7 && kinematics.link_count() == 1) x.tail<4>().normalize();
  return x;
}

/// A capsule's axis by other means than Kinematics: a product of homogeneous matrices, or Eigen's quaternions.
class OwnKinematics {
 public:
  explicit OwnKinematics(const Robot& robot) : robot_(robot) {}

  Eigen::Affine3d link(const RobotVector& q, int i) const {
    using Eigen::AngleAxisd, Eigen::Translation3d;
    if (q.size() == 3) return Translation3d(q[0], q[1], 0) * AngleAxisd(q[2], Vector3d::UnitZ());
    if (robot_.kinematics->link_count() == 1)
      return Translation3d(q[0], q[1], q[2]) * Eigen::Quaterniond(q[3], q[4], q[5], q[6]).normalized();
    Eigen::Affine3d frame = Eigen::Affine3d::Identity();
    const bool modified = q.size() == 7;
    static const double panda[7][3] = {{0, 0, 0.333},          {0, -kPi / 2, 0},           {0, kPi / 2, 0.316},
                                       {0.0825, kPi / 2, 0},   {-0.0825, -kPi / 2, 0.384}, {0, kPi / 2, 0},
                                       {0.088, kPi / 2, 0.107}};
    static const double ur5[6][3] = {{0, kPi / 2, 0.089159}, {-0.425, 0, 0},         {-0.39225, 0, 0},
                                     {0, kPi / 2, 0.10915},  {0, -kPi / 2, 0.09465}, {0, 0, 0.0823}};
    for (int j = 0; j < i; ++j) {
      const double* row = modified ? panda[j] : ur5[j];
      const Translation3d along_x(row[0], 0, 0), along_z(0, 0, row[2]);
      const AngleAxisd about_x(row[1], Vector3d::UnitX()), about_z(q[j], Vector3d::UnitZ());
      frame = modified ? frame * about_x * along_x * about_z * along_z : frame * about_z * along_z * along_x * about_x;
    }
    return frame;
  }

  Segment3 axis(const RobotVector& q, std::size_t capsule) const {
    const Capsule& c = robot_.capsules[capsule];
    const Eigen::Affine3d frame = link(q, c.link);
    return {frame * c.from, frame * c.to};
  }

 private:
  const Robot& robot_;
};

/// Of a robot from obstacles and itself in one configuration, by distances of points of the axes.
double own_gap(const Robot& robot, const RobotWalls::Obstacles& obstacles, double clearance, const RobotVector& q) {
  const OwnKinematics own(robot);
  double least = std::numeric_limits<double>::infinity();
  const int space = robot.kinematics->space();
  constexpr int kSamples = 64;
  for (std::size_t i = 0; i < robot.capsules.size(); ++i) {
    if (robot.kinematics->link_count() > 1 && robot.capsules[i].link == 0) continue;
    const Segment3 axis = own.axis(q, i);
    for (const auto& obstacle : obstacles)
      for (int k = 0; k <= kSamples; ++k) {
        RobotVector away(space);
        const RobotVector x = RobotVector(axis.at(static_cast<double>(k) / kSamples)).head(space);
        least = std::min(least, std::max(0.0, obstacle->distance(x, away)) - obstacle->radius() -
                                    robot.capsules[i].radius - clearance);
      }
  }
  for (const auto& [i, j] : robot.self) {
    double s = 0, t = 0;
    const double apart =
        distance_of_segments(own.axis(q, static_cast<std::size_t>(i)), own.axis(q, static_cast<std::size_t>(j)), s, t);
    least = std::min(least, apart - robot.capsules[static_cast<std::size_t>(i)].radius -
                                robot.capsules[static_cast<std::size_t>(j)].radius);
  }
  return least;
}

RobotWalls::Obstacles random_obstacles(int space, int count, std::mt19937& engine) {
  std::uniform_real_distribution<double> place(-1, 1), size(0.02, 0.3);
  RobotWalls::Obstacles all;
  for (int i = 0; i < count; ++i) {
    const RobotVector center = RobotVector::NullaryExpr(space, [&] { return place(engine); });
    if (i % 2 == 0) {
      all.push_back(make_ball({center, size(engine)}));
    } else {
      const RobotVector half = RobotVector::NullaryExpr(space, [&] { return size(engine); });
      all.push_back(make_box_obstacle({center - half, center + half}));
    }
  }
  return all;
}

/// A crane: one joint about the vertical axis through the origin, a beam of capsules along x at height z.
RobotPtr crane(double z, double length, double radius) {
  arm_model::Table table;
  table.rows = Eigen::MatrixXd::Zero(1, 4);
  table.shape.resize(1, 8);
  table.shape << 1, 0, 0, z, length, 0, z, radius;
  return make_dh_arm({.model = table});
}

}  // namespace

TEST_CASE("robots: arms stand where their makers' tables say") {
  std::vector<Frame> links;
  panda_arm()->kinematics->place(RobotVector::Zero(7), links);
  CHECK((links.back().origin - Vector3d(0.088, 0, 0.333 + 0.316 + 0.384 - 0.107)).norm() < 1e-15);
  CHECK((links.back().rotation.col(2) + Vector3d::UnitZ()).norm() < 1e-15);  // the flange looks down
  ur5_arm()->kinematics->place(RobotVector::Zero(6), links);
  CHECK((links.back().origin - Vector3d(-0.425 - 0.39225, -0.10915 - 0.0823, 0.089159 - 0.09465)).norm() < 1e-15);
}

TEST_CASE("robots: frames agree with products of transforms") {
  std::mt19937 engine(20261123);
  for (const RobotPtr& robot : all_robots()) {
    const OwnKinematics own(*robot);
    std::vector<Frame> links;
    for (int k = 0; k < 50; ++k) {
      const RobotVector q = random_configuration(*robot->kinematics, engine);
      robot->kinematics->place(q, links);
      REQUIRE(static_cast<int>(links.size()) == robot->kinematics->link_count());
      for (int i = 0; i < robot->kinematics->link_count(); ++i) {
        const Frame& link = links[static_cast<std::size_t>(i)];
        CHECK((link.rotation - own.link(q, i).linear()).norm() < 1e-14);
        CHECK((link.origin - own.link(q, i).translation()).norm() < 1e-14);
      }
    }
  }
}

TEST_CASE("robots: derivatives agree with differences, and no point moves faster than its bound") {
  std::mt19937 engine(20261124);
  for (const RobotPtr& robot : all_robots()) {
    const Kinematics& kinematics = *robot->kinematics;
    CAPTURE(kinematics.link_name(kinematics.link_count() - 1), kinematics.dimension());
    std::vector<Frame> links, moved;
    Eigen::Matrix3Xd derivative;
    for (int k = 0; k < 100; ++k) {
      const RobotVector q = random_configuration(kinematics, engine);
      kinematics.place(q, links);
      for (const Capsule& capsule : robot->capsules) {
        const auto link = static_cast<std::size_t>(capsule.link);
        kinematics.jacobian(q, links, capsule.link, links[link].at(capsule.to), derivative);
        const RobotVector reach = kinematics.reach(capsule.link, capsule.to);
        REQUIRE(reach.size() == q.size());
        for (Eigen::Index i = 0; i < q.size(); ++i) {
          constexpr double kStep = 1e-6;
          RobotVector there = q;
          there[i] += kStep;
          kinematics.place(there, moved);
          Vector3d difference = moved[link].at(capsule.to);
          there[i] -= 2 * kStep;
          kinematics.place(there, moved);
          difference = (difference - moved[link].at(capsule.to)) / (2 * kStep);
          CHECK((difference - derivative.col(i)).norm() < 1e-8);
          CHECK(derivative.col(i).norm() <= reach[i] + 1e-12);
        }
        CHECK(Eigen::MatrixXd(derivative).operatorNorm() <= kinematics.steepest(reach, 0) + 1e-9);
      }
    }
  }
}

TEST_CASE("robots: speeds and accelerations along moves stay below their bounds") {
  std::mt19937 engine(20261125);
  double tightest = 0;
  for (const RobotPtr& robot : all_robots()) {
    const Kinematics& kinematics = *robot->kinematics;
    std::vector<Frame> links;
    for (int k = 0; k < 200; ++k) {
      const RobotVector a = random_configuration(kinematics, engine);
      const RobotVector b = a + (k % 2 == 0 ? 0.2 : 1.0) * (random_configuration(kinematics, engine) - a);
      for (const Capsule& capsule : robot->capsules) {
        const MotionBound bound = kinematics.motion(a, b, kinematics.reach(capsule.link, capsule.from), 0);
        const auto at = [&](double t) -> Vector3d {
          kinematics.place(a + t * (b - a), links);
          return links[static_cast<std::size_t>(capsule.link)].at(capsule.from);
        };
        for (double t = 0.05; t < 1; t += 0.15) {
          constexpr double kStep = 1e-4;
          const double speed = (at(t + kStep) - at(t - kStep)).norm() / (2 * kStep);
          const double acceleration = (at(t + kStep) - 2 * at(t) + at(t - kStep)).norm() / (kStep * kStep);
          CHECK(speed <= bound.speed * (1 + 1e-6) + 1e-9);
          CHECK(acceleration <= bound.acceleration * (1 + 1e-4) + 1e-6);
          const Vector3d point = at(t);
          const PointMotion motion = kinematics.moving(a + t * (b - a), links, b - a, capsule.link, point, 0);
          CHECK((motion.velocity - (at(t + kStep) - at(t - kStep)) / (2 * kStep)).norm() <
                1e-9 + kStep * kStep * bound.jerk);
          CHECK((motion.acceleration - (at(t + kStep) - 2 * point + at(t - kStep)) / (kStep * kStep)).norm() <
                1e-6 + kStep * bound.jerk);
          constexpr double kLong = 2e-3;
          const Vector3d third = at(t + 2 * kLong) - 2 * at(t + kLong) + 2 * at(t - kLong) - at(t - 2 * kLong);
          CHECK(third.norm() / (2 * kLong * kLong * kLong) <= bound.jerk * (1 + 1e-3) + 1e-4);
          if (bound.speed > 0) tightest = std::max(tightest, speed / bound.speed);
        }
      }
    }
  }
  CHECK(tightest > 0.9);  // the bounds are not idle
}

TEST_CASE("robots: the speed seen from a link is that of the distance to points of it") {
  std::mt19937 engine(20261126);
  const RobotPtr robot = panda_arm();
  const Kinematics& kinematics = *robot->kinematics;
  std::vector<Frame> links;
  for (int k = 0; k < 100; ++k) {
    const RobotVector a = random_configuration(kinematics, engine), b = random_configuration(kinematics, engine);
    for (const auto& [i, j] : robot->self) {
      const Capsule &near = robot->capsules[static_cast<std::size_t>(i)],
                    &far = robot->capsules[static_cast<std::size_t>(j)];
      const double bound = kinematics.motion(a, b, kinematics.reach(far.link, far.to), near.link).speed;
      const auto seen = [&](double t) -> Vector3d {
        kinematics.place(a + t * (b - a), links);
        const Frame& from = links[static_cast<std::size_t>(near.link)];
        return from.rotation.transpose() * (links[static_cast<std::size_t>(far.link)].at(far.to) - from.origin);
      };
      for (double t = 0.1; t < 1; t += 0.2) {
        constexpr double kStep = 1e-5;
        CHECK((seen(t + kStep) - seen(t - kStep)).norm() / (2 * kStep) <= bound * (1 + 1e-6));
      }
    }
  }
}

TEST_CASE("robots: distances of segments are the least of those of their points") {
  std::mt19937 engine(20261127);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto point = [&]() -> Vector3d { return Vector3d::NullaryExpr([&] { return place(engine); }); };
  for (int k = 0; k < 400; ++k) {
    Segment3 first{point(), point()}, second{point(), point()};
    if (k % 5 == 1) second = {first.from + point(), first.to};
    if (k % 5 == 2) second.to = second.from + 1.3 * (first.to - first.from);  // parallel
    if (k % 5 == 3) first.to = first.from;
    if (k % 5 == 4) second.to = second.from + (first.to - first.from) + 1e-9 * point();  // nearly
    double s = 0, t = 0, sampled = 10;
    const double distance = distance_of_segments(first, second, s, t);
    constexpr int kSamples = 200;
    for (int i = 0; i <= kSamples; ++i)
      for (int j = 0; j <= kSamples; ++j)
        sampled = std::min(sampled, (first.at(double(i) / kSamples) - second.at(double(j) / kSamples)).norm());
    CHECK(distance <= sampled + 1e-12);
    CHECK(distance >= sampled - 5.0 / kSamples);
    CHECK((first.at(s) - second.at(t)).norm() == Approx(distance).margin(1e-15));
  }
}

TEST_CASE("robot walls: no place of a move is nearer than its clearance", "[slow]") {
  std::mt19937 engine(20261128);
  int touching = 0, decided = 0, count = 0;
  for (const RobotPtr& robot : all_robots()) {
    const Kinematics& kinematics = *robot->kinematics;
    for (int k = 0; k < test::trials(60); ++k) {
      const auto obstacles = random_obstacles(kinematics.space(), 1 + k % 5, engine);
      const double required = k % 3 == 0 ? 0.05 : 0;
      const RobotWalls walls(robot, obstacles, required);
      const RobotVector a = random_configuration(kinematics, engine);
      const double share = k % 4 == 0 ? 1 : k % 4 == 1 ? 0.2 : 0.03;
      const RobotVector b = a + share * (random_configuration(kinematics, engine) - a);
      const MoveClearance found = walls.clearance(a, b);
      CAPTURE(k, kinematics.dimension(), walls.obstacle_name(found.obstacle));
      double sampled = std::numeric_limits<double>::infinity();
      const int kSamples = test::trials(300);
      for (int i = 0; i <= kSamples; ++i)
        sampled = std::min(sampled, own_gap(*robot, obstacles, required, a + (b - a) * i / kSamples));
      CHECK(found.proved);
      CHECK(found.lower <= sampled + 1e-12);
      CHECK(found.lower <= found.upper);
      CHECK(found.upper >= own_gap(*robot, obstacles, required, found.place) - 0.02);  // axes are sampled there
      ++count;
      touching += found.upper < 0 ? 1 : 0;
      decided += found.lower >= 0 || found.upper < 0 ? 1 : 0;
      CHECK(found.lower >= found.upper - std::max(1e-9, 0.51 * std::abs(found.upper)));
    }
  }
  CHECK(decided == count);
  CHECK(touching > count / 10);
  CHECK(touching < 9 * count / 10);
}

TEST_CASE("robot walls: contact is decided") {
  std::mt19937 engine(20261129);
  std::uniform_real_distribution<double> place(-0.9, 0.9);
  for (const RobotPtr& robot : all_robots()) {
    const Kinematics& kinematics = *robot->kinematics;
    for (int k = 0; k < 25; ++k) {
      Robot alone = *robot;  // without its own parts, which may be in the way
      alone.self.clear();
      const auto shape = std::make_shared<const Robot>(alone);
      const RobotVector a = random_configuration(kinematics, engine);
      const RobotVector b = a + 0.1 * (random_configuration(kinematics, engine) - a);
      const RobotVector center = RobotVector::NullaryExpr(kinematics.space(), [&] { return place(engine); });
      // A small ball, then the one that the move just touches, by the attained gap followed to its place.
      constexpr double kSmall = 1e-3;
      std::vector<Wall> found;
      double radius = kSmall;
      for (int pass = 0; pass < 2; ++pass) {
        const RobotWalls walls(shape, {make_ball({center, radius})}, 0);
        walls.along(a, b, 1e3, found);
        const MoveClearance bound = walls.clearance(a, b);
        if (bound.upper < 0.02 && pass == 0) break;
        double least = std::numeric_limits<double>::infinity();
        for (const Wall& wall : found) {
          const Capsule& capsule = robot->capsules[static_cast<std::size_t>(wall.obstacle)];
          least = std::min(least, wall.gap * (radius + capsule.radius) / wall.required);
        }
        if (pass == 0) {
          CHECK(least <= bound.upper + 1e-13);
          radius += least;
          continue;
        }
        CAPTURE(k, kinematics.dimension(), bound.upper);
        CHECK(std::abs(least) < 1e-12);
        CHECK(bound.lower >= -1e-9);
        CHECK(bound.upper <= 1e-6);
      }
    }
  }
}

TEST_CASE("robot walls: a beam that slides along the top of a box, in contact all the way") {
  const RobotWalls walls(crane(0.5, 1, 0.1), {make_box_obstacle({Vector3d(-2, -2, -1), Vector3d(2, 2, 0.4)})}, 0);
  const MoveClearance found = walls.clearance(RobotVector::Constant(1, -0.05), RobotVector::Constant(1, 0.05));
  CHECK(std::abs(found.upper) < 1e-14);
  CHECK(found.lower >= -1e-9);
  const RobotWalls lower(crane(0.5 - 1e-6, 1, 0.1), {make_box_obstacle({Vector3d(-2, -2, -1), Vector3d(2, 2, 0.4)})},
                         0);
  CHECK(lower.clearance(RobotVector::Constant(1, -0.05), RobotVector::Constant(1, 0.05)).upper < -0.9e-6);
}

TEST_CASE("robot walls: a beam that turns past a ball, in closed form") {
  // The ball stands at distance p from the axis; the beam, longer than that, comes as near as p sin(angle).
  const double p = 0.8, r = 0.1, radius = 0.05;
  const RobotWalls walls(crane(0, 1, radius), {make_ball({Vector3d(p, 0, 0), r})}, 0.01);
  for (const double angle : {0.3, 0.5, 1.0, -0.4}) {
    const RobotVector here = RobotVector::Constant(1, angle), away = RobotVector::Constant(1, 2 * angle);
    const double expected = p * std::sin(std::abs(angle)) - r - radius - 0.01;
    const MoveClearance found = walls.clearance(here, away);
    CHECK(found.upper ==
          Approx(std::min(expected, p * std::abs(std::sin(2 * angle)) - r - radius - 0.01)).margin(1e-12));
    std::vector<Wall> near;
    walls.near(here, 10, near);
    REQUIRE(near.size() == 1);
    CHECK(near[0].gap == Approx(expected));  // the tip of the beam moves by 1 per radian
    CHECK(near[0].slope[0] == Approx(std::copysign(p * std::cos(angle), angle)));
    CHECK(near[0].required == Approx(r + radius + 0.01));
  }
  const MoveClearance through = walls.clearance(RobotVector::Constant(1, -1), RobotVector::Constant(1, 1));
  CHECK(through.upper < 0);
  CHECK(walls.room(RobotVector::Constant(1, -1), RobotVector::Constant(1, 1), 1) < 1e-9);
  const double room = walls.room(RobotVector::Constant(1, 0.5), RobotVector::Constant(1, 0.7), 10);
  CHECK(room <= p * std::sin(0.5));
  CHECK(room >= 0.5 * p * std::sin(0.5));
}

TEST_CASE("robot walls: gaps change by no more than the place, and by their slopes") {
  std::mt19937 engine(20261130);
  for (const RobotPtr& robot : all_robots()) {
    const Kinematics& kinematics = *robot->kinematics;
    const RobotWalls walls(robot, random_obstacles(kinematics.space(), 4, engine), 0.02);
    std::vector<Wall> here, there;
    int wrong = 0, compared = 0;
    for (int k = 0; k < 100; ++k) {
      const RobotVector x = random_configuration(kinematics, engine);
      walls.near(x, 10, here);
      CHECK(std::is_sorted(here.begin(), here.end(),
                           [](const Wall& p, const Wall& q) { return p.obstacle < q.obstacle; }));
      const RobotVector way = 1e-6 * (random_configuration(kinematics, engine) - x).normalized();
      walls.near(x + way, 10, there);
      REQUIRE(here.size() == there.size());
      for (std::size_t i = 0; i < here.size(); ++i) {
        const double change = there[i].gap - here[i].gap;
        CHECK(std::abs(change) <= way.norm() * (1 + 1e-6));
        CHECK(here[i].slope.norm() <= 1 + 1e-9);
        if (here[i].gap + here[i].required < 1e-3) continue;  // in a core there is no distance to change
        ++compared;
        wrong += std::abs(change - here[i].slope.dot(way)) > 1e-10 ? 1 : 0;
      }
    }
    CHECK(compared > 100);
    CHECK(wrong <= compared / 50);  // at kinks
  }
}

TEST_CASE("robot walls: what keeps nothing out and what cannot be") {
  const RobotWalls none(planar_body(), {}, 0);
  CHECK(none.clearance(Vector3d(0, 0, 0), Vector3d(1, 1, 1)).obstacle == -1);
  CHECK(std::isinf(none.clearance(Vector3d(0, 0, 0), Vector3d(1, 1, 1)).lower));
  const RobotWalls far(planar_body(), {make_ball({Vector2d(1e6, 0), 1})}, 0);
  CHECK(far.clearance(Vector3d(0, 0, 0), Vector3d(1, 1, 1)).upper == Approx(1e6).epsilon(1e-4));
  CHECK_THROWS_AS(RobotWalls(planar_body(), {make_ball({Vector3d(0, 0, 0), 1})}, 0), OptionError);
  CHECK_THROWS_AS(RobotWalls(planar_body(), {}, -1), OptionError);
  // Half a turn through the quaternion 0: which way it goes is not known, so nothing is.
  RobotVector a = RobotVector::Zero(7), b = a;
  a[3] = 1;
  b[3] = -1;
  const RobotWalls solid(spatial_body(), {make_ball({Vector3d(5, 0, 0), 1})}, 0);
  CHECK(solid.clearance(a, b).lower < 0);
  CHECK(solid.clearance(a, a).lower > 3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(solid.clearance(a, RobotVector::Constant(7, nan)).lower >= 0);
  // A polygon, which is not convex, and a body that turns within its notch.
  Eigen::MatrixXd notch(6, 2);
  notch << -2, -2, 2, -2, 2, 2, 0.3, 2, 0, -1, -0.3, 2;
  const RobotWalls polygon(planar_body(), {make_polygon({notch})}, 0);
  CHECK(polygon.clearance(Vector3d(0, 3, 0), Vector3d(0, 3, 6)).lower > 0);
  CHECK(polygon.clearance(Vector3d(0, 3, 0), Vector3d(0, -1, 0)).upper < 0);
}

TEST_CASE("robots: names, limits and refused options") {
  const RobotWalls walls(panda_arm(), {make_ball({Vector3d(1, 0, 0.5), 0.1})}, 0);
  CHECK(walls.obstacle_name(5) == "link 5 and the ball at (1, 0, 0.5) (number 0)");
  CHECK(walls.obstacle_name(10) == "link 5 and the base");
  const RobotWalls wide(panda_arm(), {make_ball({Vector3d(1, 0, 0.5), 0.1})}, 0.05);
  CHECK(wide.depth_text(5, 0.04).empty());
  CHECK(wide.depth_text(5, 0.07) == "is in collision: link 5 and the ball at (1, 0, 0.5) (number 0) overlap by 0.02");
  CHECK(wide.depth_text(10, 0.04) ==
        "is in collision: link 5 and the base overlap by 0.04");  // of itself: no clearance
  CHECK(panda_arm()->kinematics->upper()[3] == -0.0698);
  const auto key = [](const DhArmOptions& options) -> std::string {
    try {
      make_dh_arm(options);
    } catch (const OptionError& error) {
      return error.key();
    }
    return "";
  };
  arm_model::Table table;
  table.rows = Eigen::MatrixXd::Zero(2, 4);
  table.shape = Eigen::MatrixXd::Zero(1, 8);
  table.shape(0, 0) = 1;
  table.shape(0, 7) = 0.1;
  CHECK(key({.model = table}).empty());
  CHECK(key({.model = table, .base = Vector2d(0, 0)}) == "base");
  arm_model::Table wrong = table;
  wrong.shape(0, 7) = 0;
  CHECK(key({.model = wrong}) == "model.shape");
  wrong = table;
  wrong.shape(0, 0) = 3;
  CHECK(key({.model = wrong}) == "model.shape");
  wrong = table;
  wrong.shape(0, 0) = 0.5;
  CHECK(key({.model = wrong}) == "model.shape");
  wrong = table;
  wrong.rows = Eigen::MatrixXd::Zero(2, 3);
  CHECK(key({.model = wrong}) == "model.rows");
  wrong = table;
  wrong.lower = Vector2d(0, 1);
  wrong.upper = Vector2d(1, 0);
  CHECK(key({.model = wrong}) == "model.upper");
  wrong = table;
  wrong.self = Eigen::MatrixXd::Zero(1, 2);
  CHECK(key({.model = wrong}) == "model.self");
  wrong.self = Eigen::MatrixXd::Constant(1, 2, 7);
  CHECK(key({.model = wrong}) == "model.self");
  CHECK_THROWS_AS(make_rigid_body({Eigen::MatrixXd::Zero(1, 6)}), OptionError);
  CHECK_THROWS_AS(make_rigid_body({Eigen::MatrixXd::Zero(1, 7)}), OptionError);  // no radius
  CHECK_THROWS_AS(make_rigid_body({}), OptionError);
}

TEST_CASE("robots: the listed parts of the arms can touch, and stay apart in their usual poses") {
  for (const RobotPtr& robot : {panda_arm(), ur5_arm()}) {
    const RobotWalls walls(robot, {}, 0);
    RobotVector home = RobotVector::Zero(robot->kinematics->dimension());
    if (home.size() == 7)
      home << 0, -kPi / 4, 0, -3 * kPi / 4, 0, kPi / 2, kPi / 4;
    else
      home << 0, -kPi / 2, kPi / 2, -kPi / 2, -kPi / 2, 0;
    CHECK(walls.clearance(home, home).upper > 0.02);
    std::mt19937 engine(20261201);
    int touching = 0;
    constexpr int kTries = 300;
    for (int k = 0; k < kTries; ++k) {
      const RobotVector q = random_configuration(*robot->kinematics, engine);
      touching += walls.clearance(q, q).upper < 0 ? 1 : 0;
    }
    CAPTURE(touching);
    CHECK(touching > kTries / 50);
    CHECK(touching < kTries * 2 / 3);
  }
}

TEST_CASE("robot walls: as the configuration moves by the thinnest core no part moves farther than it is thick") {
  std::mt19937 engine(7);
  std::normal_distribution<double> normal;
  constexpr double kRadius = 0.05, kClearance = 0.01;
  for (const RobotPtr& robot : all_robots()) {
    const int space = robot->kinematics->space();
    const RobotWalls walls(robot, {make_ball({RobotVector::Constant(space, 0.7), kRadius})}, kClearance);
    const double thinnest = walls.thinnest();
    REQUIRE(thinnest > 0);
    CHECK(RobotWalls(robot, {make_ball({RobotVector::Constant(space, 0.7), 2 * kRadius})}, kClearance).thinnest() >=
          thinnest);
    std::vector<Frame> before, after;
    for (int k = 0; k < 50; ++k) {
      const RobotVector x = random_configuration(*robot->kinematics, engine);
      const RobotVector way = RobotVector::NullaryExpr(x.size(), [&] { return normal(engine); }).normalized();
      robot->kinematics->place(x, before);
      robot->kinematics->place(x + thinnest * way, after);
      for (const Capsule& part : robot->capsules) {
        const auto link = static_cast<std::size_t>(part.link);
        const double gone = (after[link].at(part.to) - before[link].at(part.to)).norm();
        const bool meets_parts = std::any_of(robot->self.begin(), robot->self.end(), [&](const auto& pair) {
          return &robot->capsules[static_cast<std::size_t>(pair.second)] == &part;
        });
        if (!meets_parts) CHECK(gone <= part.radius + kRadius + kClearance);
      }
    }
  }
}

/// A floor of 2 km, a ball far off: what no part comes near to makes no gap less certain.
TEST_CASE("robot: what is far off or huge makes clearances no less certain") {
  const RobotPtr arm = panda_arm();
  const auto near = make_ball({Vector3d(0.55, 0, 0.45), 0.12});
  const std::vector<std::shared_ptr<const Obstacle>> far = {
      make_box_obstacle({.lower = Vector3d(-1000, -1000, -1), .upper = Vector3d(1000, 1000, -0.5)}),
      make_ball({Vector3d(1000, 0, 0), 1}), make_ball({Vector3d(1e6, 0, 0), 1}),
      make_ball({Vector3d(1000, 0, 0), 990})};
  const auto plain = std::make_shared<const RobotWalls>(arm, RobotWalls::Obstacles{near}, 0.02);
  RobotVector a(7), b(7);
  a << -1.2, 0.4, 0, -1.8, 0, 2.2, 0.7;
  b << 1.2, 0.5, 0.1, -1.6, 0.2, 2.1, -0.5;
  const MoveClearance alone = plain->clearance(a, a + 0.2 * (b - a));
  for (const auto& obstacle : far) {
    INFO(obstacle->name());
    const auto walls = std::make_shared<const RobotWalls>(arm, RobotWalls::Obstacles{near, obstacle}, 0.02);
    CHECK(walls->size() == plain->size());
    CHECK(walls->computed_from() <= 1000);
    for (const RobotVector& x : {a, b}) {  // a place is measured up to rounding
      const MoveClearance here = walls->clearance(x, x);
      CHECK(here.upper - here.lower <= 1e-9);
    }
    const MoveClearance beside = walls->clearance(a, a + 0.2 * (b - a));
    CHECK(beside.upper == Approx(alone.upper).margin(1e-9));
  }
}

}  // namespace leastcost
