// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/manifolds/level_set.hpp>

namespace leastcost {

/// The sets of ConstraintManifoldOptions that have a name.
namespace constraint {

struct Sphere {
  static constexpr std::string_view kType = "sphere";
  static constexpr std::string_view kHelp = "|x| = radius in R^n.";
  double radius = 1;
  void fields(FieldVisitor& visit);
};

struct Rotations {
  static constexpr std::string_view kType = "so3";
  static constexpr std::string_view kHelp =
      "Rotations of space as unit quaternions (w, x, y, z); length is half the angle.";
  bool nearest_image = true;  ///< of the two quaternions of the target the one to which a path is cheaper
  void fields(FieldVisitor& visit);
};

using Set = std::variant<Sphere, Rotations>;

}  // namespace constraint

/// Equations with the dimension of their space, or a set: a sphere with the dimension, or the rotations.
struct ConstraintManifoldOptions {
  std::optional<int> dimension = {};  ///< n
  std::vector<std::string> equations = {};
  std::map<std::string, double> parameters = {};
  std::optional<constraint::Set> set = {};
  void fields(FieldVisitor& visit);
};

/// The solutions of equations in x0 .. x{n-1}, or a set with a name: the sphere in R^n, or the rotations of space,
/// SO(3), as unit quaternions (w, x, y, z) with q and -q identified. Euclidean length between quaternions is half the
/// angle of rotation. Throws OptionError.
std::shared_ptr<const LevelSet> make_constraint_manifold(const ConstraintManifoldOptions& options);

}  // namespace leastcost
