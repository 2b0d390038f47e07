// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/constraint.hpp>

#include <leastcost/framework/errors.hpp>
#include "problems/chart/has_images.hpp"
#include "problems/formula/coordinate_names.hpp"
#include "problems/level_set/formula_constraint.hpp"
#include "problems/level_set/named_surfaces.hpp"

namespace leastcost {
namespace {

/// Unit quaternions.
class Rotations final : public LevelSet, public HasImages {
 public:
  Rotations() : LevelSet(make_sphere_function(4, 1)) {}
  Eigen::VectorXd nearest_image(const Eigen::VectorXd& q, const Eigen::VectorXd& reference) const override {
    return q.dot(reference) < 0 ? Eigen::VectorXd(-q) : q;
  }
};

std::shared_ptr<const LevelSet> from_equations(const ConstraintManifoldOptions& o) {
  if (o.dimension < 0) throw OptionError("dimension", "equations need the dimension n of their space");
  if (o.dimension < 2 || o.dimension > kMaxDimension)
    throw OptionError("dimension", "must be between 2 and " + std::to_string(kMaxDimension));
  if (static_cast<int>(o.equations.size()) >= o.dimension)
    throw OptionError("equations", std::to_string(o.equations.size()) + " equations in R^" +
                                       std::to_string(o.dimension) + " leave no room to move: give fewer");
  return std::make_shared<LevelSet>(make_formula_constraint(
      formulas_of_option("equations", o.equations, numbered_names("x", o.dimension), o.parameters)));
}

}  // namespace

void ConstraintManifoldOptions::fields(FieldVisitor& visit) {
  visit.field("dimension", dimension, {.help = "Dimension n of the space.", .minimum = 2, .maximum = kMaxDimension});
  visit.field("equations", equations,
              {.help = "Formulas in x0 .. x{n-1} that vanish on the set, fewer than n of them."});
  visit.field("parameters", parameters, {.help = "Numbers by name that the equations use."});
  visit.variant("set", set,
                {{"sphere", "|x| = radius in R^n.",
                  [&](FieldVisitor& v) {
                    v.field("radius", radius,
                            {.help = "Radius.", .unit = "length", .minimum = 0, .exclusive_minimum = true});
                  }},
                 {"so3", "Rotations of space as unit quaternions (w, x, y, z); length is half the angle.",
                  [&](FieldVisitor& v) {
                    v.field("nearest_image", nearest_image,
                            {.help = "Takes, of the two quaternions of the target, the one nearer to the source."});
                  }}},
                {.help = "A set with a name, instead of equations."});
}

std::shared_ptr<const LevelSet> make_constraint_manifold(const ConstraintManifoldOptions& o) {
  if (o.equations.empty() && o.set.empty())
    throw OptionError("equations", "missing: give equations, like [\"x^2 + y^2 - 1\"], or a set");
  if (!o.equations.empty() && !o.set.empty())
    throw OptionError("equations", "give either equations or a set, not both");
  if (!o.equations.empty()) return from_equations(o);
  if (!o.parameters.empty()) throw OptionError("parameters", "parameters are for equations; the set has none");
  if (o.set == "so3") {
    if (o.dimension >= 0 && o.dimension != 4) throw OptionError("dimension", "quaternions have 4 coordinates");
    if (o.nearest_image) return std::make_shared<Rotations>();
    return std::make_shared<LevelSet>(make_sphere_function(4, 1));
  }
  if (o.set != "sphere") throw OptionError("set", "unknown set '" + o.set + "'");
  if (o.dimension < 2 || o.dimension > kMaxDimension)
    throw OptionError("dimension", "a sphere needs the dimension of its space, 2 to " + std::to_string(kMaxDimension));
  try {
    return std::make_shared<LevelSet>(make_sphere_function(o.dimension, o.radius));
  } catch (const OptionError& error) {
    throw OptionError("set." + error.key(), error.what());
  }
}

}  // namespace leastcost
