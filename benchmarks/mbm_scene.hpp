// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#define BOOST_BIND_GLOBAL_PLACEHOLDERS  // of its parser of JSON
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include <leastcost/problems/shapes/box.hpp>
#include <leastcost/problems/shapes/capsule_obstacle.hpp>

/// The Panda problems of MotionBenchMaker as VAMP ships them: spheres of a URDF, pairs of an SRDF, scenes of a JSON
/// file.
namespace leastcost::bench {

namespace pt = boost::property_tree;
using Eigen::Vector3d;

inline Vector3d three_of(const std::string& text) {
  std::istringstream in(text);
  Vector3d x;
  in >> x[0] >> x[1] >> x[2];
  return x;
}

inline Eigen::Isometry3d origin_of(const pt::ptree& of) {
  using Eigen::AngleAxisd;
  const Vector3d turn = three_of(of.get<std::string>("origin.<xmlattr>.rpy", "0 0 0"));
  return Eigen::Translation3d(three_of(of.get<std::string>("origin.<xmlattr>.xyz", "0 0 0"))) *
         (AngleAxisd(turn[2], Vector3d::UnitZ()) * AngleAxisd(turn[1], Vector3d::UnitY()) *
          AngleAxisd(turn[0], Vector3d::UnitX()));
}

/// Spheres of one link that follow each other on a line and are as large, and no farther apart than twice their radius,
/// become one capsule, which covers them.
inline void add_spheres(const std::vector<std::pair<Vector3d, double>>& spheres, int link, std::vector<Capsule>& all) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const auto& [x, radius] = spheres[i];
    const auto straight = [&] {
      if (first == i || radius != spheres[first].second) return false;
      const Vector3d last = x - spheres[i - 1].first;
      const Vector3d all_way = x - spheres[first].first;
      return last.norm() <= 2 * radius && last.dot(all_way) > 0 && last.cross(all_way).norm() < 1e-6 * all_way.norm();
    };
    if (straight()) {
      all.back().to = x;
      continue;
    }
    first = i;
    all.push_back({link, x, x, radius});
  }
}

/// The joints of the built-in Panda with the spheres of a URDF, and its hard limits.
inline std::shared_ptr<const Robot> panda_of(const std::filesystem::path& folder) {
  DhTable table = joints_of(arm_model::Panda{});
  table.rows(6, 2) = 0;  // link 7 is before the flange
  table.lower.resize(7);
  table.upper.resize(7);
  table.lower << -2.9671, -1.8326, -2.9671, -3.1416, -2.9671, -0.0873, -2.9671;
  table.upper << 2.9671, 1.8326, 2.9671, 0.0873, 2.9671, 3.8223, 2.9671;
  pt::ptree urdf, srdf;
  pt::read_xml((folder / "panda_spherized.urdf").string(), urdf);
  pt::read_xml((folder / "panda.srdf").string(), srdf);
  std::map<std::string, std::pair<std::string, Eigen::Isometry3d>> fixed;  // the parent of a link, and where
  for (const auto& [tag, joint] : urdf.get_child("robot"))
    if (tag == "joint" && joint.get<std::string>("<xmlattr>.type") == "fixed")
      fixed[joint.get<std::string>("child.<xmlattr>.link")] = {joint.get<std::string>("parent.<xmlattr>.link"),
                                                               origin_of(joint)};
  Robot robot;
  robot.kinematics = std::make_shared<const DhArm>(table);
  std::vector<std::string> names;  // of the links of capsules
  for (const auto& [tag, link] : urdf.get_child("robot")) {
    if (tag != "link") continue;
    std::string name = link.get<std::string>("<xmlattr>.name"), base = name;
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    for (auto at = fixed.find(base); at != fixed.end(); at = fixed.find(base)) {
      place = at->second.second * place;
      base = at->second.first;
    }
    std::vector<std::pair<Vector3d, double>> spheres;
    for (const auto& [inner, collision] : link)
      if (inner == "collision")
        spheres.emplace_back(place * origin_of(collision).translation(),
                             collision.get<double>("geometry.sphere.<xmlattr>.radius"));
    add_spheres(spheres, base.back() - '0', robot.capsules);
    names.resize(robot.capsules.size(), name);
  }
  std::set<std::pair<std::string, std::string>> may_touch;
  for (const auto& [tag, pair] : srdf.get_child("robot"))
    if (tag == "disable_collisions") {
      const std::string a = pair.get<std::string>("<xmlattr>.link1"), b = pair.get<std::string>("<xmlattr>.link2");
      may_touch.insert({a, b});
      may_touch.insert({b, a});
    }
  for (int i = 0; i < static_cast<int>(names.size()); ++i)
    for (int j = 0; j < i; ++j) {
      const auto first = static_cast<std::size_t>(i), second = static_cast<std::size_t>(j);
      if (robot.capsules[first].link != robot.capsules[second].link &&
          may_touch.count({names[first], names[second]}) == 0)
        robot.self.emplace_back(i, j);
    }
  return make_robot(robot);
}

struct MbmProblem {
  std::string scenario;
  int index = 0;
  RobotWalls::Obstacles obstacles;
  /// Of each obstacle: itself moved by so much; null for what is not a box.
  std::vector<std::function<std::shared_ptr<const Obstacle>(const Vector3d&)>> movable;
  Eigen::VectorXd source, target;
};

/// Cylinders are capsules, as VAMP has them, but in `box`, where they are boxes.
inline std::shared_ptr<const Obstacle> obstacle_of(const pt::ptree& object, bool round,
                                                   const Vector3d& shift = Vector3d::Zero()) {
  std::vector<double> dim, m;
  for (const auto& [key, value] : object.get_child("dim")) dim.push_back(value.get_value<double>());
  for (const auto& [key, row] : object.get_child("M"))
    for (const auto& [inner, value] : row) m.push_back(value.get_value<double>());
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 12; ++i) place(i / 4, i % 4) = m[static_cast<std::size_t>(i)];
  place.pretranslate(shift);
  const ShapePose pose = shape_pose(place);
  if (object.get<std::string>("type") == "box")
    return make_box({.size = Vector3d(dim[0], dim[1], dim[2]), .pose = pose});
  if (!round) return make_box({.size = Vector3d(2 * dim[1], 2 * dim[1], dim[0]), .pose = pose});
  const Vector3d half(0, 0, dim[0] / 2);
  return make_capsule({.from = place * half, .to = place * Vector3d(-half), .radius = dim[1]});
}

inline Eigen::VectorXd configuration_of(const pt::ptree& joints) {
  Eigen::VectorXd q(7);
  for (int j = 0; j < 7; ++j) q[j] = joints.get<double>("panda_joint" + std::to_string(j + 1));
  return q;
}

/// Of a file of all scenarios, gzipped or not.
inline std::vector<MbmProblem> mbm_problems(const std::filesystem::path& file) {
  std::stringstream text;
  FILE* in = popen(("gzip -cdf '" + file.string() + "'").c_str(), "r");
  char buffer[1 << 16];
  for (std::size_t n = 0; in != nullptr && (n = fread(buffer, 1, sizeof buffer, in)) > 0;)
    text.write(buffer, static_cast<std::streamsize>(n));
  if (in != nullptr) pclose(in);
  pt::ptree all;
  pt::read_json(text, all);
  std::vector<MbmProblem> problems;
  for (const auto& [scenario, list] : all)
    for (const auto& [key, one] : list) {
      MbmProblem problem{scenario, one.get<int>("index"), {}, {}, {}, {}};
      const bool round = scenario != "box";
      for (const auto& [inner, object] : one.get_child("objs")) {
        problem.obstacles.push_back(obstacle_of(object, round));
        problem.movable.emplace_back();
        if (object.get<std::string>("type") == "box")
          problem.movable.back() = [object = object, round](const Vector3d& shift) {
            return obstacle_of(object, round, shift);
          };
      }
      problem.source = configuration_of(one.get_child("start"));
      problem.target = configuration_of(one.get_child("goals").front().second);
      problems.push_back(std::move(problem));
    }
  return problems;
}

}  // namespace leastcost::bench
