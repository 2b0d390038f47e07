// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/urdf/urdf_robot.hpp>

#include <tinyxml2.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>

#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/robots/tree_kinematics.hpp>
#include "problems/robots/always_touching.hpp"
#include "urdf/joint_choice.hpp"
#include "urdf/link_shapes.hpp"
#include "urdf/srdf_model.hpp"
#include "urdf/urdf_model.hpp"

namespace leastcost {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;

Affine3d turned(const Vector3d& rpy) {
  return Affine3d(Eigen::AngleAxisd(rpy.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vector3d::UnitY()) *
                  Eigen::AngleAxisd(rpy.x(), Vector3d::UnitX()));
}

Frame frame_of(const Affine3d& place) { return {place.linear(), place.translation()}; }

/// Builds the robot of a model: which joints move, which links stand still against each other, and their shapes.
class RobotBuilder {
 public:
  RobotBuilder(const UrdfRobotOptions& options, const std::filesystem::path& folder)
      : options_(options), folder_(folder), urdf_(read_urdf(folder / options.file)) {
    if (!options.srdf.empty()) srdf_ = read_srdf(folder / options.srdf, urdf_);
  }

  /// Of its files.
  std::vector<std::string> notes() const {
    std::vector<std::string> all = urdf_.notes;
    if (srdf_) all.insert(all.end(), srdf_->notes.begin(), srdf_->notes.end());
    return all;
  }

  std::shared_ptr<const Robot> build() {
    choice_ = choose_joints(options_, urdf_, srdf_ ? &*srdf_ : nullptr);
    tree_.lower = choice_.lower;
    tree_.upper = choice_.upper;
    join_links();
    add_shapes();
    add_pairs();
    name_states();
    name_frames();
    limit_velocities();
    robot_.kinematics = std::make_shared<const TreeKinematics>(tree_);
    leave_out_what_always_touches(robot_, 0);
    return make_robot(std::move(robot_));
  }

 private:
  /// Links of the tree are what moves as one; each link of the file has its place in one of them.
  void join_links() {
    tree_.base = frame_of(Eigen::Translation3d(options_.position.head<3>()) * turned(options_.rpy));
    tree_.links = {urdf_.links[static_cast<std::size_t>(urdf_.root)].name};
    bodies_.assign(urdf_.links.size(), 0);
    places_.assign(urdf_.links.size(), Affine3d::Identity());
    for (std::size_t i = 0; i < urdf_.joints.size(); ++i) {
      const UrdfJoint& one = urdf_.joints[i];
      const auto parent = static_cast<std::size_t>(one.parent), child = static_cast<std::size_t>(one.child);
      const Affine3d origin = places_[parent] * one.origin;
      const int coordinate = choice_.coordinates[one.mimic ? static_cast<std::size_t>(one.mimic->joint) : i];
      const double factor = one.mimic ? one.mimic->factor : 1;
      if (one.moves() && coordinate >= 0 && factor != 0) {
        bodies_[child] = static_cast<int>(tree_.links.size());
        tree_.links.push_back(urdf_.links[child].name);
        tree_.joints.push_back({bodies_[parent], frame_of(origin), one.axis, one.kind == UrdfJoint::Kind::slides,
                                coordinate, factor, one.mimic ? one.mimic->offset : 0});
        continue;
      }
      bodies_[child] = bodies_[parent];
      places_[child] = origin;
      if (one.kind == UrdfJoint::Kind::turns) places_[child] = origin * Eigen::AngleAxisd(choice_.values[i], one.axis);
      if (one.kind == UrdfJoint::Kind::slides)
        places_[child] = origin * Eigen::Translation3d(choice_.values[i] * one.axis);
    }
  }

  /// Capsules ascend by the link of the tree: what is near is looked for link by link.
  void add_shapes() {
    const MeshFinder meshes((folder_ / options_.file).parent_path(),
                            options_.packages.empty() ? std::filesystem::path() : folder_ / options_.packages);
    struct Shape {
      Capsule capsule;
      int link;
    };
    std::vector<Shape> shapes;
    double adds = 0;
    std::string where;
    for (std::size_t link = 0; link < urdf_.links.size(); ++link) {
      for (const UrdfCollision& collision : urdf_.links[link].collisions) {
        const Covering covering = cover(collision, meshes);
        if (covering.adds > adds) where = urdf_.links[link].name;
        adds = std::max(adds, covering.adds);
        for (const Capsule& one : covering.capsules)
          shapes.push_back(
              {{bodies_[link], places_[link] * one.from, places_[link] * one.to, one.radius}, static_cast<int>(link)});
      }
    }
    if (shapes.empty()) throw OptionError("file", "no link has a collision shape");
    if (std::all_of(shapes.begin(), shapes.end(), [](const Shape& shape) { return shape.capsule.link == 0; }))
      throw OptionError("file",
                        "no moving link has a collision shape, so the robot can never collide: give the links "
                        "<collision> shapes");
    std::stable_sort(shapes.begin(), shapes.end(),
                     [](const Shape& a, const Shape& b) { return a.capsule.link < b.capsule.link; });
    for (const Shape& shape : shapes) {
      robot_.capsules.push_back(shape.capsule);
      links_.push_back(shape.link);
      robot_.owners.push_back(urdf_.links[static_cast<std::size_t>(shape.link)].name);
    }
    const std::string file = std::filesystem::path(options_.file).filename().string();
    robot_.whose = "the collision shapes of " + file;
    robot_.unit = "m";
    if (adds > 0) {
      constexpr double kMillimetres = 1000;
      robot_.whose = "capsules that cover the collision shapes of " + file + " and exceed them by at most " +
                     std::to_string(static_cast<long>(std::ceil(kMillimetres * adds))) + " mm (" + where + ")";
    }
  }

  /// Whether two links of the tree are neighbours: nothing that has a shape lies between them.
  bool adjacent(int link, int other) const {
    std::set<int> shaped;
    for (const Capsule& capsule : robot_.capsules) shaped.insert(capsule.link);
    const auto above = [&](int at) {
      do at = at == 0 ? -1 : tree_.joints[static_cast<std::size_t>(at - 1)].parent;
      while (at >= 0 && shaped.count(at) == 0);
      return at;
    };
    return above(link) == other || above(other) == link;
  }

  void add_pairs() {
    std::map<std::pair<int, int>, bool> wanted;  // of links of the file
    const int count = static_cast<int>(robot_.capsules.size());
    for (int i = 0; i < count; ++i) {
      for (int j = i + 1; j < count; ++j) {
        const int body = robot_.capsules[static_cast<std::size_t>(i)].link,
                  other = robot_.capsules[static_cast<std::size_t>(j)].link;
        if (body == other) continue;
        const int first = links_[static_cast<std::size_t>(i)], second = links_[static_cast<std::size_t>(j)];
        auto known = wanted.find({first, second});
        if (known == wanted.end()) {
          const bool keep = srdf_ ? srdf_->checks(urdf_.links[static_cast<std::size_t>(first)].name,
                                                  urdf_.links[static_cast<std::size_t>(second)].name)
                                  : !adjacent(body, other);
          known = wanted.emplace(std::pair{first, second}, keep).first;
        }
        if (known->second) robot_.self.emplace_back(i, j);
      }
    }
  }

  /// Those that give a value to every joint that moves; of two of one name that of the chosen group.
  void name_states() {
    if (!srdf_) return;
    for (const SrdfState& state : srdf_->states) {
      Eigen::VectorXd values(static_cast<Eigen::Index>(choice_.names.size()));
      bool all = true;
      for (std::size_t c = 0; c < choice_.names.size(); ++c) {
        const auto value = state.joints.find(choice_.names[c]);
        all = all && value != state.joints.end();
        if (all) values[static_cast<Eigen::Index>(c)] = value->second;
      }
      if (!all) continue;
      if (state.group == options_.group)
        robot_.states[state.name] = values;
      else
        robot_.states.emplace(state.name, values);
    }
  }

  void name_frames() {
    for (std::size_t link = 0; link < urdf_.links.size(); ++link)
      robot_.frames[urdf_.links[link].name] = {bodies_[link], frame_of(places_[link])};
  }

  /// Of those that mimic a joint, too.
  void limit_velocities() {
    robot_.joints = choice_.names;
    robot_.velocity = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(choice_.names.size()),
                                                std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < urdf_.joints.size(); ++i) {
      const UrdfJoint& one = urdf_.joints[i];
      const int coordinate = choice_.coordinates[one.mimic ? static_cast<std::size_t>(one.mimic->joint) : i];
      const double factor = one.mimic ? std::abs(one.mimic->factor) : 1;
      if (!one.moves() || coordinate < 0 || !(factor > 0)) continue;
      robot_.velocity[coordinate] = std::min(robot_.velocity[coordinate], one.velocity / factor);
    }
  }

  const UrdfRobotOptions& options_;
  std::filesystem::path folder_;
  UrdfModel urdf_;
  std::optional<SrdfModel> srdf_;
  JointChoice choice_;
  std::vector<int> bodies_, links_;  ///< of links of the file: those of the tree; of capsules: links of the file
  std::vector<Affine3d> places_;     ///< of the links of the file, in the frames of those of the tree
  JointTree tree_;
  Robot robot_;
};

}  // namespace

std::string tinyxml2_version() {
  return std::to_string(TINYXML2_MAJOR_VERSION) + "." + std::to_string(TINYXML2_MINOR_VERSION) + "." +
         std::to_string(TINYXML2_PATCH_VERSION);
}

std::shared_ptr<const Robot> make_urdf_robot(const UrdfRobotOptions& options, const std::filesystem::path& folder,
                                             const std::function<void(std::string)>& note) {
  for (const auto& [key, value] : {std::pair{"base.position", &options.position}, {"base.rpy", &options.rpy}})
    if (value->size() != 3 || !value->allFinite()) throw OptionError(key, "must be three finite numbers");
  RobotBuilder builder(options, folder);
  if (note)
    for (const std::string& text : builder.notes()) note(text);
  return builder.build();
}

}  // namespace leastcost
