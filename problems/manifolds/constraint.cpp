// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/constraint.hpp>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/has_blocks.hpp>
#include <leastcost/framework/domain/has_images.hpp>
#include <leastcost/framework/domain/has_sample_box.hpp>
#include "problems/formula/coordinate_names.hpp"
#include "problems/level_set/formula_constraint.hpp"
#include "problems/level_set/named_surfaces.hpp"

namespace leastcost {
namespace {

/// Unit quaternions.
class RotationSet final : public LevelSet, public HasImages, public HasBlocks, public HasSampleBox {
 public:
  explicit RotationSet(bool nearest_image) : LevelSet(make_sphere_function(4, 1)), nearest_image_(nearest_image) {}
  std::vector<PointImage> images(const Eigen::VectorXd& q, const Eigen::VectorXd&, std::size_t most) const override {
    if (most == 0) return {};
    return {{-q, "-q"}};
  }
  bool states_way(const Eigen::VectorXd&, const Eigen::VectorXd&) const override { return !nearest_image_; }
  /// A chord is half the angle.
  std::vector<CoordinateBlock> blocks() const override { return {{0, 4, 2}}; }
  SampleBox sample_box(const Eigen::VectorXd&, const Eigen::VectorXd&) const override {
    return {Eigen::Vector4d::Constant(-1), Eigen::Vector4d::Constant(1)};
  }

 private:
  bool nearest_image_;
};

using LevelSetPtr = std::shared_ptr<const LevelSet>;

LevelSetPtr from_equations(const ConstraintManifoldOptions& o) {
  if (!o.dimension) throw OptionError("dimension", "give the dimension n of the space of the equations");
  const int n = *o.dimension;
  if (n < 2 || n > kMaxDimension)
    throw OptionError("dimension", "must be between 2 and " + std::to_string(kMaxDimension));
  if (static_cast<int>(o.equations.size()) >= n)
    throw OptionError("equations", std::to_string(o.equations.size()) + " equations in R^" + std::to_string(n) +
                                       " leave only isolated points: give fewer");
  return std::make_shared<LevelSet>(
      make_formula_constraint(formulas_of_option("equations", o.equations, numbered_names("x", n), o.parameters)));
}

LevelSetPtr named(const constraint::Rotations& rotations, std::optional<int> dimension) {
  if (dimension.value_or(4) != 4) throw OptionError("dimension", "must be 4 for quaternions");
  return std::make_shared<RotationSet>(rotations.nearest_image);
}

LevelSetPtr named(const constraint::Sphere& sphere, std::optional<int> dimension) {
  const int n = dimension.value_or(0);
  if (n < 2 || n > kMaxDimension)
    throw OptionError("dimension",
                      "give the dimension of the space of the sphere, 2 to " + std::to_string(kMaxDimension));
  try {
    return std::make_shared<LevelSet>(make_sphere_function(n, sphere.radius));
  } catch (const OptionError& error) {
    throw error.under("set");
  }
}

}  // namespace

namespace constraint {

void Sphere::fields(FieldVisitor& visit) {
  visit.field("radius", radius, {.help = "Radius.", .unit = "length", .minimum = 0, .exclusive_minimum = true});
}
void Rotations::fields(FieldVisitor& visit) {
  visit.field("nearest_image", nearest_image,
              {.help = "Of the two quaternions of the target, take the one with the cheaper path."});
}

}  // namespace constraint

void ConstraintManifoldOptions::fields(FieldVisitor& visit) {
  visit.field("dimension", dimension, {.help = "Dimension n of the space.", .minimum = 2, .maximum = kMaxDimension});
  visit.field("equations", equations,
              {.help = "Formulas in x0 .. x{n-1} that are zero on the set, fewer than n of them."});
  visit.field("parameters", parameters, {.help = "Constants that the equations use, by name."});
  visit.variant("set", set, {.help = "A named set, instead of equations."});
}

std::shared_ptr<const LevelSet> make_constraint_manifold(const ConstraintManifoldOptions& o) {
  if (o.equations.empty() && !o.set)
    throw OptionError("equations", "missing: give equations, like [\"x^2 + y^2 - 1\"], or a set");
  if (!o.equations.empty() && o.set) throw OptionError("equations", "give either equations or a set, not both");
  if (!o.set) return from_equations(o);
  if (!o.parameters.empty())
    throw OptionError("parameters", "parameters are for equations, but the set has none: remove them");
  return std::visit([&](const auto& set) { return named(set, o.dimension); }, *o.set);
}

}  // namespace leastcost
