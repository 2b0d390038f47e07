// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// What turned boxes, the same boxes as meshes, cylinders and cones cost an arm: moves of a Panda among ten of them, in
// clearances of moves (proved) and in decisions whether a move is clear. Ratios to boxes along the axes of the same
// sizes at the same places.
#include <time.h>

#include <Eigen/Geometry>
#include <cstdio>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include <leastcost/problems/obstacles/mesh_obstacle.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include <leastcost/problems/shapes/box.hpp>
#include <leastcost/problems/shapes/capsule_obstacle.hpp>
#include <leastcost/problems/shapes/cone.hpp>
#include <leastcost/problems/shapes/cylinder.hpp>

namespace {

using namespace leastcost;
using Eigen::Vector3d;
using Vector = Eigen::VectorXd;
using Obstacles = RobotWalls::Obstacles;

constexpr int kShapes = 10, kMoves = 4000;
constexpr double kLongest = 0.4;  ///< rad: of a move, in each joint

struct Random {
  std::mt19937 engine{7};
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
};

struct Place {
  Vector3d size, position, turn;
};

PolygonSoup box_mesh(const Place& place) {
  const Eigen::Isometry3d pose = pose_of({.position = place.position, .rpy = place.turn}, 3);
  PolygonSoup soup;
  for (int i = 0; i < 8; ++i)
    soup.positions.push_back(pose * Vector3d(((i & 1) != 0 ? 0.5 : -0.5) * place.size[0],
                                             ((i & 2) != 0 ? 0.5 : -0.5) * place.size[1],
                                             ((i & 4) != 0 ? 0.5 : -0.5) * place.size[2]));
  const int corners[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                              {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  soup.polygon_begin.push_back(0);
  for (const auto& face : corners) {
    for (const int corner : face) soup.corners.push_back(corner);
    soup.polygon_begin.push_back(static_cast<std::int32_t>(soup.corners.size()));
  }
  soup.source = "box";
  return soup;
}

double seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double mean_microseconds(const std::function<void(int)>& work) {
  const double start = seconds();
  for (int k = 0; k < kMoves; ++k) work(k);
  return 1e6 * (seconds() - start) / kMoves;
}

}  // namespace

int main() {
  Random random;
  std::vector<Place> places;
  for (int i = 0; i < kShapes; ++i) {
    Place place;
    for (Eigen::Index k = 0; k < 3; ++k) place.size[k] = random.number(0.08, 0.24);
    const double angle = random.number(-3, 3), off = random.number(0.45, 0.8);
    place.position << off * std::cos(angle), off * std::sin(angle), random.number(0.1, 0.9);
    for (Eigen::Index k = 0; k < 3; ++k) place.turn[k] = random.number(-1.5, 1.5);
    places.push_back(place);
  }
  std::vector<std::pair<Vector, Vector>> moves;
  for (int k = 0; k < kMoves; ++k) {
    Vector a(7), b(7);
    a << random.number(-2.8, 2.8), random.number(-1.7, 1.7), random.number(-2.8, 2.8), random.number(-3, -0.1),
        random.number(-2.8, 2.8), random.number(0, 3.7), random.number(-2.8, 2.8);
    for (Eigen::Index i = 0; i < 7; ++i) b[i] = a[i] + random.number(-kLongest, kLongest);
    moves.emplace_back(a, b);
  }
  const auto of_all = [&](const std::function<std::shared_ptr<const Obstacle>(const Place&)>& make) {
    Obstacles all;
    for (const Place& place : places) all.push_back(make(place));
    return all;
  };
  const auto pose = [](const Place& place) { return ShapePose{.position = place.position, .rpy = place.turn}; };
  const std::vector<std::pair<const char*, Obstacles>> kinds = {
      {"boxes along the axes",
       of_all([](const Place& p) { return make_box({.size = p.size, .pose = {.position = p.position}}); })},
      {"turned boxes", of_all([&](const Place& p) { return make_box({.size = p.size, .pose = pose(p)}); })},
      {"turned boxes as meshes",
       of_all([](const Place& p) { return make_mesh_obstacle(TriangleMesh(box_mesh(p)), MeshInside::solid, 0); })},
      {"cylinders", of_all([&](const Place& p) {
         return make_cylinder({p.size[0] / 2, p.size[2], pose(p)});
       })},
      {"cones", of_all([&](const Place& p) {
         return make_cone({p.size[0] / 2, p.size[2], 0, pose(p)});
       })},
      {"capsules", of_all([&](const Place& p) {
         const Vector3d half = pose_of(pose(p), 3).linear() * Vector3d(0, 0, p.size[2] / 2);
         return make_capsule({p.position - half, p.position + half, p.size[0] / 2});
       })}};
  std::printf("%-24s %14s %7s %14s %7s %9s\n", "ten of", "clearance, us", "ratio", "decision, us", "ratio", "clear");
  double first_clearance = 0, first_decision = 0;
  for (const auto& [name, obstacles] : kinds) {
    const RobotWalls walls(make_dh_arm({}), obstacles, 0.02);
    int clear = 0;
    const double clearance = mean_microseconds([&](int k) {
      const auto& [a, b] = moves[static_cast<std::size_t>(k)];
      clear += walls.clearance(a, b).lower >= 0 ? 1 : 0;
    });
    const double decision = mean_microseconds([&](int k) {
      const auto& [a, b] = moves[static_cast<std::size_t>(k)];
      walls.clears(a, b);
    });
    if (first_clearance == 0) first_clearance = clearance, first_decision = decision;
    std::printf("%-24s %14.1f %7.2f %14.1f %7.2f %8.1f%%\n", name, clearance, clearance / first_clearance, decision,
                decision / first_decision, 100.0 * clear / kMoves);
  }
}
