// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/implicit.hpp>

#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/formula/coordinate_names.hpp"
#include "problems/level_set/formula_constraint.hpp"
#include "problems/level_set/named_surfaces.hpp"
#include "problems/manifolds/bounded_level_set.hpp"
#include "problems/manifolds/length_field.hpp"

namespace leastcost {
namespace {

using Function = std::shared_ptr<const ConstraintFunction>;

Function function_of(const implicit::Sphere& o) { return make_sphere_function(3, o.radius); }
Function function_of(const implicit::Ellipsoid& o) { return make_ellipsoid_function(o.axes); }
Function function_of(const implicit::Torus& o) { return make_torus_function(o.major_radius, o.minor_radius); }
Function function_of(const implicit::Genus2&) { return make_genus2_function(); }
Function function_of(const implicit::Gyroid& o) { return make_gyroid_function(o.period); }
Function function_of(const implicit::PaperCurve&) { return make_paper_curve_function(); }
Function function_of(const implicit::Formula& o) {
  if (o.dimension != 2 && o.dimension != 3) throw OptionError("dimension", "must be 2 (a curve) or 3 (a surface)");
  return make_formula_constraint(formulas_of_option("f", {o.f}, coordinate_names(o.dimension), o.parameters));
}

}  // namespace

namespace implicit {

void Sphere::fields(FieldVisitor& visit) { length_field(visit, "radius", radius, "Radius."); }
void Ellipsoid::fields(FieldVisitor& visit) {
  visit.field(
      "axes", axes,
      {.help = "Semi-axes [a, b, c].", .unit = "length", .minimum = 0, .exclusive_minimum = true, .required = true});
}
void Torus::fields(FieldVisitor& visit) {
  length_field(visit, "major_radius", major_radius, "Radius of the centre line of the tube.");
  length_field(visit, "minor_radius", minor_radius, "Radius of the tube, smaller than major_radius.");
}
void Gyroid::fields(FieldVisitor& visit) { length_field(visit, "period", period, "Period along each coordinate."); }
void Formula::fields(FieldVisitor& visit) {
  visit.field("f", f,
              {.help = "Formula that is zero on the surface and has a nonzero gradient there.", .required = true});
  visit.field("dimension", dimension,
              {.help = "3: a surface in x, y, z. 2: a curve in x, y.", .minimum = 2, .maximum = 3});
  visit.field("parameters", parameters, {.help = "Constants that the formula uses, by name."});
}

}  // namespace implicit

void ImplicitManifoldOptions::fields(FieldVisitor& visit) {
  visit.variant("surface", surface, {.help = "The surface, by name or as a formula.", .required = true});
  box.fields(visit);
}

std::shared_ptr<const LevelSet> make_implicit_manifold(const ImplicitManifoldOptions& options) {
  std::shared_ptr<const ConstraintFunction> function;
  try {
    function = std::visit([](const auto& surface) { return function_of(surface); }, options.surface);
  } catch (const OptionError& error) {
    throw error.under("surface");
  }
  Box box(function->inputs(), options.box);
  if (!box.bounded()) return std::make_shared<LevelSet>(std::move(function));
  return std::make_shared<BoundedLevelSet>(std::move(function), std::move(box));
}

}  // namespace leastcost
