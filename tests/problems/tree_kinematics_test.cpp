// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/tree_kinematics.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include "problems/robots/segment_distance.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/refused_key.hpp"

namespace leastcost {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;
using Joints = Eigen::VectorXd;

class RandomTrees {
 public:
  explicit RandomTrees(unsigned seed) : engine_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  Vector3d vector(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }

  Frame frame() {
    const Eigen::Quaterniond turn(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1));
    return {turn.normalized().toRotationMatrix(), vector(1)};
  }

  /// Of 1 to 8 joints; a third of them slides, some of them mimic another one.
  JointTree tree() {
    JointTree tree;
    tree.base = frame();
    tree.links = {"base"};
    const int count = 1 + below(8);
    int coordinates = 0;
    for (int i = 0; i < count; ++i) {
      TreeJoint joint;
      joint.parent = below(3) == 0 ? below(i + 1) : i;
      joint.origin = frame();
      joint.axis = vector(1);
      joint.slides = below(3) == 0;
      const bool mimics = coordinates > 0 && below(5) == 0;
      joint.coordinate = mimics ? below(coordinates) : coordinates++;
      if (mimics || below(6) == 0) {
        joint.factor = below(2) == 0 ? -0.7 : 1.3;
        joint.offset = between(-0.3, 0.3);
      }
      tree.joints.push_back(joint);
      tree.links.push_back("link " + std::to_string(i + 1));
    }
    tree.lower = Joints::NullaryExpr(coordinates, [&] { return between(-2, 0); });
    tree.upper = Joints::NullaryExpr(coordinates, [&] { return between(0.1, 2); });
    return tree;
  }

  Joints configuration(const JointTree& tree) {
    Joints q = tree.lower;
    for (Eigen::Index i = 0; i < q.size(); ++i) q[i] = between(tree.lower[i], tree.upper[i]);
    return q;
  }

 private:
  std::mt19937 engine_;
};

Affine3d affine(const Frame& frame) {
  Affine3d out = Affine3d::Identity();
  out.linear() = frame.rotation;
  out.translation() = frame.origin;
  return out;
}

/// A product of Eigen's transformations along the parents.
Affine3d product(const JointTree& tree, const Joints& q, int link) {
  if (link == 0) return affine(tree.base);
  const TreeJoint& joint = tree.joints[static_cast<std::size_t>(link - 1)];
  const double value = joint.factor * q[joint.coordinate] + joint.offset;
  const Vector3d axis = joint.axis.normalized();
  const Affine3d moved =
      joint.slides ? Affine3d(Eigen::Translation3d(value * axis)) : Affine3d(Eigen::AngleAxisd(value, axis));
  return product(tree, q, joint.parent) * affine(joint.origin) * moved;
}

/// A point of a link in the frame of another one.
Vector3d seen(const JointTree& tree, const Joints& q, int from, int link, const Vector3d& local) {
  return product(tree, q, from).inverse() * (product(tree, q, link) * local);
}

}  // namespace

TEST_CASE("tree kinematics: links are where a product of transformations has them") {
  RandomTrees random(20261127);
  for (int trial = 0; trial < 200; ++trial) {
    const JointTree tree = random.tree();
    const TreeKinematics kinematics(tree);
    const Joints q = random.configuration(tree);
    std::vector<Frame> links;
    kinematics.place(q, links);
    REQUIRE(static_cast<int>(links.size()) == kinematics.link_count());
    for (int link = 0; link < kinematics.link_count(); ++link)
      CHECK((affine(links[static_cast<std::size_t>(link)]).matrix() - product(tree, q, link).matrix()).norm() < 1e-12);
  }
}

TEST_CASE("tree kinematics: derivatives are those of differences") {
  RandomTrees random(7);
  constexpr double kStep = 1e-4;
  for (int trial = 0; trial < 100; ++trial) {
    const JointTree tree = random.tree();
    const TreeKinematics kinematics(tree);
    const Joints q = random.configuration(tree), way = random.configuration(tree) - q;
    std::vector<Frame> links;
    kinematics.place(q, links);
    Eigen::Matrix3Xd derivative;
    for (int link = 0; link < kinematics.link_count(); ++link) {
      const Vector3d local = random.vector(0.5), point = links[static_cast<std::size_t>(link)].at(local);
      kinematics.jacobian(q, links, link, point, derivative);
      const Vector3d ahead = product(tree, q + kStep * way, link) * local,
                     behind = product(tree, q - kStep * way, link) * local;
      CHECK(((ahead - behind) / (2 * kStep) - derivative * way).norm() < 1e-5);
      for (int from = 0; from < kinematics.link_count(); ++from) {
        const PointMotion motion = kinematics.moving(q, links, way, link, point, from);
        const Affine3d home = product(tree, q, from);
        const Vector3d here = seen(tree, q, from, link, local), next = seen(tree, q + kStep * way, from, link, local),
                       last = seen(tree, q - kStep * way, from, link, local);
        CHECK((home.linear() * (next - last) / (2 * kStep) - motion.velocity).norm() < 1e-4);
        CHECK((home.linear() * (next - 2 * here + last) / (kStep * kStep) - motion.acceleration).norm() < 1e-4);
      }
    }
  }
}

TEST_CASE("tree kinematics: reaches and the bounds of motions hold wherever they are sampled") {
  RandomTrees random(11);
  constexpr double kStep = 1e-3, kRounding = 1e-6;
  long places = 0;
  double tightest = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const JointTree tree = random.tree();
    const TreeKinematics kinematics(tree);
    for (int k = 0; k < 6; ++k) {
      const int link = random.below(kinematics.link_count()), from = random.below(kinematics.link_count());
      const Vector3d local = random.vector(0.5);
      const Joints reach = kinematics.reach_from(from, link, local);
      const Joints a = random.configuration(tree), b = random.configuration(tree), way = b - a;
      const MotionBound bound = kinematics.motion(a, b, reach, from);
      CHECK(bound.speed <= kinematics.steepest(reach, from) * way.norm() * (1 + 1e-12));
      for (int i = 0; i < 12; ++i, ++places) {
        const double t = random.between(0, 1);
        const auto at = [&](double s) { return seen(tree, a + s * way, from, link, local); };
        const Vector3d p = at(t - 2 * kStep), q = at(t - kStep), r = at(t), s = at(t + kStep), u = at(t + 2 * kStep);
        const double speed = ((s - q) / (2 * kStep)).norm();
        CHECK(speed <= bound.speed * (1 + 1e-3) + kRounding);
        CHECK(((q - 2 * r + s) / (kStep * kStep)).norm() <= bound.acceleration * (1 + 1e-3) + kRounding);
        CHECK(((u - 2 * s + 2 * q - p) / (2 * std::pow(kStep, 3))).norm() <= bound.jerk * (1 + 1e-2) + 1e-4);
        if (bound.speed > 0) tightest = std::max(tightest, speed / bound.speed);
        const Joints x = random.configuration(tree);
        for (Eigen::Index c = 0; c < x.size(); ++c) {
          const Joints unit = Joints::Unit(x.size(), c);
          const Vector3d moved =
              seen(tree, x + kStep * unit, from, link, local) - seen(tree, x - kStep * unit, from, link, local);
          CHECK(moved.norm() / (2 * kStep) <= reach[c] * (1 + 1e-6) + 1e-9);
        }
      }
    }
  }
  CHECK(places > 4000);
  CHECK(tightest > 0.9);  // and are not far too large
}

TEST_CASE("tree kinematics: what slides along an axis on which all turn about it adds nothing to the reach") {
  JointTree scara;  // two arms of 0.4 and 0.3, a quill that slides through the end of the second and turns
  scara.links = {"base", "inner", "outer", "quill", "tool"};
  const auto at = [](double x) { return Frame{Eigen::Matrix3d::Identity(), Vector3d(x, 0, 0)}; };
  scara.joints = {{.parent = 0, .coordinate = 0},
                  {.parent = 1, .origin = at(0.4), .coordinate = 1},
                  {.parent = 2, .origin = at(0.3), .slides = true, .coordinate = 2},
                  {.parent = 3, .coordinate = 3}};
  scara.lower = Eigen::Vector4d(-2, -2, -0.2, -3);
  scara.upper = Eigen::Vector4d(2, 2, 0, 3);
  const TreeKinematics kinematics(scara);
  const Joints reach = kinematics.reach(4, Vector3d(0.05, 0, 0.1));
  CHECK(reach.isApprox(Eigen::Vector4d(0.75, 0.35, 1, 0.05), 1e-14));
  scara.joints[2].axis = Vector3d::UnitX();  // a telescope: it is as far out as its range lets it
  CHECK(TreeKinematics(scara).reach(3, Vector3d::Zero()).isApprox(Eigen::Vector4d(0.7, 0.3, 1, 0), 1e-14));
  CHECK(kinematics.carries(0, 4));
  CHECK(kinematics.carries(2, 3));
  CHECK_FALSE(kinematics.carries(3, 2));
}

TEST_CASE("tree kinematics: the clearance between two branches holds at every place") {
  JointTree tree;  // two arms of two joints on one turning column, side by side
  tree.links = {"base", "column", "left upper", "left lower", "right upper", "right lower"};
  const auto at = [](double x, double y) { return Frame{Eigen::Matrix3d::Identity(), Vector3d(x, y, 0)}; };
  tree.joints = {{.parent = 0, .coordinate = 0},
                 {.parent = 1, .origin = at(0, 0.3), .coordinate = 1},
                 {.parent = 2, .origin = at(0.5, 0), .axis = Vector3d(0.1, 0.2, 1), .coordinate = 2},
                 {.parent = 1, .origin = at(0, -0.3), .coordinate = 3},
                 {.parent = 4, .origin = at(0.5, 0), .coordinate = 4}};
  tree.lower = Joints::Constant(5, -1.2);
  tree.upper = Joints::Constant(5, 1.2);
  Robot robot;
  robot.kinematics = std::make_shared<const TreeKinematics>(tree);
  for (int link = 2; link <= 5; ++link) robot.capsules.push_back({link, Vector3d::Zero(), Vector3d(0.5, 0, 0), 0.05});
  robot.self = {{0, 3}, {1, 2}, {1, 3}, {0, 2}};
  const RobotWalls walls(make_robot(robot), {}, 0);
  RandomTrees random(5);
  int clear = 0, hit = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Joints a = random.configuration(tree), b = random.configuration(tree);
    const MoveClearance found = walls.clearance(a, b);
    CHECK(found.proved);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 300; ++i) {
      const Joints q = a + (b - a) * i / 300;
      const auto axis = [&](int capsule) {
        return Segment3{product(tree, q, capsule + 2) * Vector3d(0, 0, 0),
                        product(tree, q, capsule + 2) * Vector3d(0.5, 0, 0)};
      };
      double s = 0, t = 0;
      for (const auto& [i_part, j_part] : robot.self)
        least = std::min(least, distance_of_segments(axis(i_part), axis(j_part), s, t) - 0.1);
    }
    CHECK(found.lower <= least + 1e-12);
    CHECK(found.upper <= std::max(0.0, least) + 0.02);
    CHECK(walls.clears(a, b) == (found.upper >= 0));
    ++(least > 0 ? clear : hit);
  }
  CHECK(clear > 10);
  CHECK(hit > 10);
}

TEST_CASE("tree kinematics: trees that are none are refused") {
  JointTree tree;
  tree.links = {"base", "arm"};
  tree.joints = {TreeJoint{}};
  tree.lower = tree.upper = Joints::Zero(1);
  CHECK_NOTHROW(TreeKinematics(tree));
  const auto key = [&](const auto& change) {
    JointTree wrong = tree;
    change(wrong);
    return test::refused_key([&] { TreeKinematics{wrong}; });
  };
  CHECK(key([](JointTree& t) { t.joints.clear(); }) == "joints");
  CHECK(key([](JointTree& t) { t.joints[0].parent = 1; }) == "joints");
  CHECK(key([](JointTree& t) { t.joints[0].axis.setZero(); }) == "joints");
  CHECK(key([](JointTree& t) { t.joints[0].coordinate = 1; }) == "joints");
  CHECK(key([](JointTree& t) { t.joints[0].origin.rotation *= 2; }) == "joints");
  CHECK(key([](JointTree& t) { t.joints[0].factor = 0; }) == "joints");
  CHECK(key([](JointTree& t) { t.links.pop_back(); }) == "links");
  CHECK(key([](JointTree& t) { t.lower[0] = 1; }) == "upper");
  CHECK(key([](JointTree& t) { t.lower[0] = std::nan(""); }) == "lower");
  CHECK(key([](JointTree& t) { t.base.origin[0] = std::nan(""); }) == "base");
}

}  // namespace leastcost
