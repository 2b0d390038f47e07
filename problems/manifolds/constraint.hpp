// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/options.hpp>
#include <leastcost/problems/manifolds/level_set.hpp>

namespace leastcost {

struct ConstraintManifoldOptions {
  int dimension = -1;  ///< n; negative: not given
  std::vector<std::string> equations = {};
  std::map<std::string, double> parameters = {};
  std::string set = {};  ///< "", "sphere" or "so3"
  double radius = 1;
  bool nearest_image = true;
  void fields(FieldVisitor& visit);
};

/// The solutions of equations in x0 .. x{n-1}, or a set with a name: the sphere in R^n, or the rotations of space,
/// SO(3), as unit quaternions (w, x, y, z) with q and -q identified. Euclidean length between quaternions is half the
/// angle of rotation. Throws OptionError.
std::shared_ptr<const LevelSet> make_constraint_manifold(const ConstraintManifoldOptions& options);

}  // namespace leastcost
