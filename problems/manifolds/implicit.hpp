// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <numbers>
#include <string>

#include <leastcost/framework/options.hpp>
#include <leastcost/problems/manifolds/box.hpp>
#include <leastcost/problems/manifolds/level_set.hpp>

namespace leastcost {

struct ImplicitManifoldOptions {
  std::string surface = {};  ///< one of the types below
  double radius = 1;
  Eigen::VectorXd axes = {};
  double major_radius = 2, minor_radius = 1;
  double period = 2 * std::numbers::pi;
  std::string f = {};
  int dimension = 3;
  std::map<std::string, double> parameters = {};
  BoxOptions box = {};
  void fields(FieldVisitor& visit);
};

/// A surface f(x, y, z) = 0 in space or a curve f(x, y) = 0 in the plane, VFCS 4.4.2, or the part of it in a box.
/// Throws OptionError.
std::shared_ptr<const LevelSet> make_implicit_manifold(const ImplicitManifoldOptions& options);

}  // namespace leastcost
