// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include <leastcost/problems/robots/rigid_body.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include "problems/obstacles/face_obstacle.hpp"

/// Scenes of OMPL.app: a rigid body among a mesh. Its files and its .cfg do not agree as they are; what makes the
/// starts and goals free is written down here (and in docs/planning.md):
///
/// * axes: the .cfg and its bounds are in (X, Z, -Y) of the meshes, which have Y downwards;
/// * origin: a pose places the mean of the robot's vertices, not the origin of its mesh (OMPL.app shifts it so), and
///   the start of the cubicles is the robot where its mesh lies;
/// * meshes: every face is there twice, once for either side, and edges have up to eight faces. There is no inside:
///   what must not meet are the surfaces.
namespace leastcost::test {

struct AppScene {
  std::string name;
  bool planar = false;
  std::vector<std::array<Eigen::Vector3d, 3>> world, body;  ///< triangles, each once; those of the body in its frame
  TriangleMesh world_mesh;
  Eigen::VectorXd start, goal;   ///< x, y, angle, or x, y, z, w, x, y, z
  Eigen::VectorXd lower, upper;  ///< of the place
};

inline Eigen::Vector3d from_app(const Eigen::Vector3d& p) { return {p.x(), p.z(), -p.y()}; }

/// "start.x = 1" as {"start.x", 1}; lines that say something else are left out.
inline std::map<std::string, double> read_app_config(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + " is not there");
  std::map<std::string, double> values;
  for (std::string line; std::getline(in, line);) {
    const auto equals = line.find(" = ");
    if (equals == std::string::npos) continue;
    char* end = nullptr;
    const double value = std::strtod(line.c_str() + equals + 3, &end);
    if (end != line.c_str() + equals + 3) values[line.substr(0, equals)] = value;
  }
  return values;
}

inline TriangleMesh turned_mesh(const std::filesystem::path& file, bool centred) {
  PolygonSoup soup = read_mesh(file);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (Eigen::Vector3d& p : soup.positions) {
    p = from_app(p);
    mean += p / static_cast<double>(soup.positions.size());
  }
  if (centred)
    for (Eigen::Vector3d& p : soup.positions) p -= mean;
  return TriangleMesh(soup, {.weld = true});
}

inline std::vector<std::array<Eigen::Vector3d, 3>> triangles_once(const TriangleMesh& mesh) {
  std::vector<std::array<Eigen::Vector3d, 3>> all;
  std::set<std::array<std::int32_t, 3>> known;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    auto v = mesh.face(f);
    const std::array<Eigen::Vector3d, 3> corners = {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
    std::sort(v.begin(), v.end());
    if (mesh.face_normal(f).norm() > 0 && known.insert(v).second) all.push_back(corners);
  }
  return all;
}

/// `folder`: of the data; `config`, `world` and `body` without their endings.
inline AppScene read_app_scene(const std::filesystem::path& folder, const std::string& config, const std::string& world,
                               const std::string& body) {
  const auto said = read_app_config(folder / (config + ".cfg"));
  AppScene scene{config, said.count("start.z") == 0, {}, {}, turned_mesh(folder / (world + ".obj"), false), {}, {}, {},
                 {}};
  scene.world = triangles_once(scene.world_mesh);
  scene.body = triangles_once(turned_mesh(folder / (body + ".obj"), true));
  const auto pose = [&](const std::string& end) -> Eigen::VectorXd {
    const auto at = [&](const char* key) { return said.at(end + key); };
    if (scene.planar) return Eigen::Vector3d(at(".x"), at(".y"), at(".theta"));
    const Eigen::Vector3d axis(at(".axis.x"), at(".axis.y"), at(".axis.z"));
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(at(".theta"), axis.normalized()));
    Eigen::VectorXd out(7);
    out << at(".x"), at(".y"), at(".z"), turn.w(), turn.x(), turn.y(), turn.z();
    return out;
  };
  scene.start = pose("start");
  scene.goal = pose("goal");
  const int space = scene.planar ? 2 : 3;
  scene.lower.resize(space);
  scene.upper.resize(space);
  const std::array<std::string, 3> axes = {"x", "y", "z"};
  for (int i = 0; i < space; ++i) {
    scene.lower[i] = said.at("volume.min." + axes[static_cast<std::size_t>(i)]);
    scene.upper[i] = said.at("volume.max." + axes[static_cast<std::size_t>(i)]);
  }
  return scene;
}

inline AppScene read_maze(const std::filesystem::path& folder) {
  return read_app_scene(folder, "Maze_planar", "Maze_planar_env", "car1_planar_robot");
}
inline AppScene read_cubicles(const std::filesystem::path& folder) {
  return read_app_scene(folder, "cubicles", "cubicles_env", "cubicles_robot");
}

/// How much thicker than its mesh a body is taken to be, length units.
inline constexpr double kPlateThickness = 0.25, kInset = 0.125;
/// The sides of the maze's walls lean by less than this, length units: so much is kept from where they stand.
inline constexpr double kLean = 0.02;

/// The walls of a scene over its poses, conservative: in space every face of the body with kPlateThickness around it
/// among the faces of the mesh, in the plane four capsules that cover the outline of the box around the car (their axes
/// kInset within it, their radius the root of 2 of that, hence at most 0.052 beyond the outline) among the floor plan.
inline std::shared_ptr<const Walls> walls_of(const AppScene& scene, double turn = 1) {
  Robot robot;
  if (!scene.planar) {
    robot.kinematics = std::make_shared<const SpatialBody>(turn);
    for (const auto& corners : scene.body) robot.plates.push_back({0, corners, kPlateThickness});
    return std::make_shared<const RobotWalls>(make_robot(std::move(robot)), make_face_obstacles(scene.world_mesh, 0),
                                              0);
  }
  robot.kinematics = std::make_shared<const PlanarBody>(turn);
  Eigen::AlignedBox2d outline;
  for (const auto& corners : scene.body)
    for (const Eigen::Vector3d& p : corners) outline.extend(Eigen::Vector2d(p.head<2>()));
  const Eigen::Vector2d low = outline.min().array() + kInset, high = outline.max().array() - kInset;
  const std::array<Eigen::Vector3d, 4> loop = {
      Eigen::Vector3d(low.x(), low.y(), 0), Eigen::Vector3d(high.x(), low.y(), 0),
      Eigen::Vector3d(high.x(), high.y(), 0), Eigen::Vector3d(low.x(), high.y(), 0)};
  for (std::size_t k = 0; k < 4; ++k)
    robot.capsules.push_back({0, loop[k], loop[(k + 1) % 4], std::sqrt(2.0) * kInset});
  RobotWalls::Obstacles floor_plan;
  for (const auto& corners : scene.world) {  // what stands on the ground
    if (std::max({std::abs(corners[0].z()), std::abs(corners[1].z()), std::abs(corners[2].z())}) > 1e-3) continue;
    Eigen::MatrixXd plan(3, 2);
    for (Eigen::Index k = 0; k < 3; ++k) plan.row(k) = corners[static_cast<std::size_t>(k)].head<2>();
    floor_plan.push_back(make_polygon({plan}));
  }
  return std::make_shared<const RobotWalls>(make_robot(std::move(robot)), std::move(floor_plan), kLean);
}

}  // namespace leastcost::test
