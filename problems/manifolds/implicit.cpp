// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/implicit.hpp>

#include <utility>

#include <leastcost/framework/errors.hpp>
#include "problems/formula/coordinate_names.hpp"
#include "problems/level_set/formula_constraint.hpp"
#include "problems/level_set/named_surfaces.hpp"
#include "problems/manifolds/bounded_level_set.hpp"

namespace leastcost {
namespace {

std::shared_ptr<const ConstraintFunction> function_of(const ImplicitManifoldOptions& o) {
  if (o.surface == "sphere") return make_sphere_function(3, o.radius);
  if (o.surface == "ellipsoid") return make_ellipsoid_function(o.axes);
  if (o.surface == "torus") return make_torus_function(o.major_radius, o.minor_radius);
  if (o.surface == "genus2") return make_genus2_function();
  if (o.surface == "gyroid") return make_gyroid_function(o.period);
  if (o.surface == "paper_curve") return make_paper_curve_function();
  if (o.surface != "formula") throw OptionError("type", "unknown surface '" + o.surface + "'");
  if (o.dimension != 2 && o.dimension != 3) throw OptionError("dimension", "must be 2 (a curve) or 3 (a surface)");
  return make_formula_constraint(formulas_of_option("f", {o.f}, coordinate_names(o.dimension), o.parameters));
}

}  // namespace

void ImplicitManifoldOptions::fields(FieldVisitor& visit) {
  const auto length = [](FieldVisitor& v, const char* key, double& value, const char* help) {
    v.field(key, value, {.help = help, .unit = "length", .minimum = 0, .exclusive_minimum = true});
  };
  visit.variant(
      "surface", surface,
      {{"sphere", "|x| = radius.", [&](FieldVisitor& v) { length(v, "radius", radius, "Radius."); }},
       {"ellipsoid", "(x/a)^2 + (y/b)^2 + (z/c)^2 = 1.",
        [&](FieldVisitor& v) {
          v.field("axes", axes,
                  {.help = "Half axes [a, b, c].",
                   .unit = "length",
                   .minimum = 0,
                   .exclusive_minimum = true,
                   .required = true});
        }},
       {"torus", "Around the z axis.",
        [&](FieldVisitor& v) {
          length(v, "major_radius", major_radius, "Radius of the circle in the middle of the tube.");
          length(v, "minor_radius", minor_radius, "Radius of the tube, smaller than major_radius.");
        }},
       {"genus2", "2y(y^2 - 3x^2)(1 - z^2) + (x^2 + y^2)^2 - (9z^2 - 1)(1 - z^2) = 0, with two handles."},
       {"gyroid", "sin x cos y + sin y cos z + sin z cos x = 0, repeated in all directions.",
        [&](FieldVisitor& v) { length(v, "period", period, "Period along each coordinate."); }},
       {"paper_curve", "The curve x^4 + y^2 + 3xy + 3 sin x cos y - 1 = 0 in the plane, of VFCS."},
       {"formula", "f = 0 in the coordinates x, y and z.",
        [&](FieldVisitor& v) {
          v.field("f", f,
                  {.help = "Formula that vanishes on the surface, with a gradient that does not.", .required = true});
          v.field("dimension", dimension,
                  {.help = "3: a surface in x, y, z. 2: a curve in x, y.", .minimum = 2, .maximum = 3});
          v.field("parameters", parameters, {.help = "Numbers by name that the formula uses."});
        }}},
      {.help = "The surface, by name or as a formula.", .required = true});
  box.fields(visit);
}

std::shared_ptr<const LevelSet> make_implicit_manifold(const ImplicitManifoldOptions& options) {
  std::shared_ptr<const ConstraintFunction> function;
  try {
    function = function_of(options);
  } catch (const OptionError& error) {
    throw OptionError("surface." + error.key(), error.what());
  }
  Box box(function->inputs(), options.box);
  if (!box.bounded()) return std::make_shared<LevelSet>(std::move(function));
  return std::make_shared<BoundedLevelSet>(std::move(function), std::move(box));
}

}  // namespace leastcost
