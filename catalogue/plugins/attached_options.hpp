// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/problems/robots/attached.hpp>
#include <leastcost/problems/shapes/shape_pose.hpp>
#include "catalogue/plugins/run_visitor.hpp"

namespace leastcost {

/// What a robot carries, as a configuration says it: a shape, which capsules cover, on a link.
struct AttachedOptions {
  enum class Shape { box, ball, cylinder, capsule, mesh };
  std::string id = {};    ///< for messages; empty: its shape
  std::string link = {};  ///< empty: the last one
  Shape type = Shape::box;
  std::optional<Eigen::VectorXd> size = {};           ///< of a box: its edges
  std::optional<double> radius = {}, height = {};     ///< of a ball, a cylinder, a capsule
  std::optional<Eigen::VectorXd> from = {}, to = {};  ///< of a capsule: the ends of its axis
  std::string file = {};                              ///< of a mesh
  ShapePose pose = {};                                ///< of the object in the frame of the link
  std::vector<std::string> touches = {};
  void fields(FieldVisitor& visit);
};
Words<AttachedOptions::Shape> words(AttachedOptions::Shape);

/// A robot's own options, and what it carries.
template <class Options>
struct WithAttached {
  Options robot = {};
  std::vector<AttachedOptions> attached = {};
  void fields(RunVisitor& visit) {
    robot.fields(visit);
    visit.blocks("attached", blocks_of(attached), {.help = "Objects that it carries: shapes on its links."});
  }
};

/// Files are relative to `folder`. Throws OptionError("attached.<number>..."), InputError.
std::shared_ptr<const Robot> attach(std::shared_ptr<const Robot> robot, const std::vector<AttachedOptions>& attached,
                                    const std::filesystem::path& folder);

/// Whether files have to be read for it.
bool has_files(const std::vector<AttachedOptions>& attached);

}  // namespace leastcost
