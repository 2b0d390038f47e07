// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/arm_models.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <leastcost/problems/readers/mesh_reader.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Eigen::Affine3d;
using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kOpen = 0.04;  // of a finger of the Panda, m

/// A collision mesh of a link, and where its frame is in the frame of the link's row of the table.
struct LinkMesh {
  int link;
  std::string file;
  Affine3d place = Affine3d::Identity();
};

Affine3d moved(const Vector3d& by) { return Affine3d(Translation3d(by)); }

Affine3d turned(double angle) { return Affine3d(AngleAxisd(angle, Vector3d::UnitZ())); }

Affine3d frame(const Matrix3d& turn, const Vector3d& by) { return Translation3d(by) * Affine3d(turn); }

/// Links of panda.urdf have the frames of the modified table; its last row has the flange, 107 mm further on, at which
/// the hand is turned by 45 degrees.
std::vector<LinkMesh> panda_meshes() {
  std::vector<LinkMesh> meshes;
  for (int i = 0; i < 7; ++i) meshes.push_back({i, "panda_meshes/link" + std::to_string(i) + ".obj"});
  const Affine3d hand = turned(-kPi / 4);
  meshes.push_back({7, "panda_meshes/link7.obj", moved({0, 0, -0.107})});
  meshes.push_back({7, "panda_meshes/hand.obj", hand});
  for (const double open : {0.0, kOpen}) {
    meshes.push_back({7, "panda_meshes/finger.obj", hand * moved({0, open, 0.0584})});
    meshes.push_back({7, "panda_meshes/finger.obj", hand * moved({0, -open, 0.0584}) * turned(kPi)});
  }
  return meshes;
}

/// Frames of ur5.urdf in those of the table, whose base is turned by half a turn.
std::vector<LinkMesh> ur5_meshes() {
  Matrix3d shoulder, arm, wrist;
  shoulder << -1, 0, 0, 0, 0, 1, 0, 1, 0;
  arm << 0, 0, -1, -1, 0, 0, 0, 1, 0;
  wrist << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return {{0, "ur5_meshes/base.stl", turned(kPi)},
          {1, "ur5_meshes/shoulder.stl", frame(shoulder, {0, 0, 0})},
          {2, "ur5_meshes/upperarm.stl", frame(arm, {0.425, 0, 0.13585})},
          {3, "ur5_meshes/forearm.stl", frame(arm, {0.39225, 0, 0.01615})},
          {4, "ur5_meshes/wrist1.stl", moved({0, -0.093, 0})},
          {5, "ur5_meshes/wrist2.stl", frame(wrist, {0, 0.09465, 0})},
          {6, "ur5_meshes/wrist3.stl", frame(wrist, {0, 0, -0.0823})}};
}

/// By how much the corners of a mesh stick out of the capsule of its link that holds them best, m; negative: by how
/// much they are inside. A capsule is convex, so that it holds the whole mesh if it holds the corners.
double sticks_out(const Robot& robot, const LinkMesh& mesh, const PolygonSoup& soup) {
  double least = std::numeric_limits<double>::infinity();
  for (const Capsule& capsule : robot.capsules) {
    if (capsule.link != mesh.link) continue;
    const Vector3d along = capsule.to - capsule.from;
    double most = -std::numeric_limits<double>::infinity();
    for (const Vector3d& corner : soup.positions) {
      const Vector3d from = mesh.place * corner - capsule.from;
      const double share = std::clamp(from.dot(along) / along.squaredNorm(), 0.0, 1.0);
      most = std::max(most, (from - share * along).norm() - capsule.radius);
    }
    least = std::min(least, most);
  }
  return least;
}

void check_cover(const Robot& robot, const std::vector<LinkMesh>& meshes) {
  for (const LinkMesh& mesh : meshes) {
    const auto file = data_file("planning/mbm/" + mesh.file);
    if (!file) return;
    CAPTURE(mesh.link, mesh.file);
    const double out = sticks_out(robot, mesh, read_mesh(*file));
    CHECK(out <= 0);
    CHECK(out > -0.02);  // no larger than it has to be
  }
}

}  // namespace

TEST_CASE("arms: the Panda's capsules cover its collision meshes") {
  check_cover(*make_dh_arm({.model = arm_model::Panda{}}), panda_meshes());
}

TEST_CASE("arms: the UR5's capsules cover its collision meshes") {
  check_cover(*make_dh_arm({.model = arm_model::Ur5{}}), ur5_meshes());
}

TEST_CASE("arms: whose shapes a clearance speaks of") {
  CHECK_THAT(make_dh_arm({.model = arm_model::Panda{}})->whose, Catch::Matchers::Contains("collision meshes"));
  CHECK_THAT(make_dh_arm({.model = arm_model::Ur5{}})->whose, Catch::Matchers::Contains("without a tool"));
}

}  // namespace leastcost::test
