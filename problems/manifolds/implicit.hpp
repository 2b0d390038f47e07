// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <variant>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/manifolds/box.hpp>
#include <leastcost/problems/manifolds/level_set.hpp>

namespace leastcost {

/// The surfaces and curves of ImplicitManifoldOptions, each with its measures in length units.
namespace implicit {

struct Sphere {
  static constexpr std::string_view kType = "sphere";
  static constexpr std::string_view kHelp = "|x| = radius.";
  double radius = 1;
  void fields(FieldVisitor& visit);
};

struct Ellipsoid {
  static constexpr std::string_view kType = "ellipsoid";
  static constexpr std::string_view kHelp = "(x/a)^2 + (y/b)^2 + (z/c)^2 = 1.";
  Eigen::VectorXd axes = {};  ///< a, b, c
  void fields(FieldVisitor& visit);
};

struct Torus {
  static constexpr std::string_view kType = "torus";
  static constexpr std::string_view kHelp = "Around the z axis.";
  double major_radius = 2, minor_radius = 1;  ///< of the centre circle, and of the tube
  void fields(FieldVisitor& visit);
};

struct Genus2 {
  static constexpr std::string_view kType = "genus2";
  static constexpr std::string_view kHelp =
      "2y(y^2 - 3x^2)(1 - z^2) + (x^2 + y^2)^2 - (9z^2 - 1)(1 - z^2) = 0, with two handles.";
};

struct Gyroid {
  static constexpr std::string_view kType = "gyroid";
  static constexpr std::string_view kHelp = "sin x cos y + sin y cos z + sin z cos x = 0, periodic in all directions.";
  double period = 2 * std::numbers::pi;  ///< length units
  void fields(FieldVisitor& visit);
};

struct PaperCurve {
  static constexpr std::string_view kType = "paper_curve";
  static constexpr std::string_view kHelp = "The curve x^4 + y^2 + 3xy + 3 sin x cos y - 1 = 0 in the plane, of VFCS.";
};

struct Formula {
  static constexpr std::string_view kType = "formula";
  static constexpr std::string_view kHelp = "f = 0 in the coordinates x, y and z.";
  std::string f = {};  ///< of x, y and z; the surface is where it is 0
  int dimension = 3;   ///< 2: a curve in x and y
  std::map<std::string, double> parameters = {};
  void fields(FieldVisitor& visit);
};

using Surface = std::variant<Sphere, Ellipsoid, Torus, Genus2, Gyroid, PaperCurve, Formula>;

}  // namespace implicit

struct ImplicitManifoldOptions {
  implicit::Surface surface = {};
  BoxOptions box = {};  ///< where points may be
  void fields(FieldVisitor& visit);
};

/// A surface f(x, y, z) = 0 in space or a curve f(x, y) = 0 in the plane, VFCS 4.4.2, or the part of it in a box.
/// Throws OptionError.
std::shared_ptr<const LevelSet> make_implicit_manifold(const ImplicitManifoldOptions& options);

}  // namespace leastcost
