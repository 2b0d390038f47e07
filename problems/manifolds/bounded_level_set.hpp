// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>

#include <leastcost/framework/cost/segment_derivatives.hpp>
#include <leastcost/framework/domain/goes_beyond_bounds.hpp>
#include <leastcost/problems/manifolds/box.hpp>
#include <leastcost/problems/manifolds/level_set.hpp>

namespace leastcost {

/// The part of a level set that lies in a box of its space. The nearest point of it is found by an active set: Newton
/// steps on F with the coordinates held whose bounds are active, until no bound is violated and none pulls. A point
/// that lies on a bound stays on it where it moves along it, so that its retraction is that of the curve in which the
/// bound cuts the level set.
class BoundedLevelSet final : public LevelSet, public GoesBeyondBounds {
 public:
  /// Throws InputError as LevelSet does.
  BoundedLevelSet(std::shared_ptr<const ConstraintFunction> function, Box box);

  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  void retract_beyond(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  /// The outward normals of the box, projected into the tangent space.
  int active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const override;
  std::string why_not_projected(const Eigen::VectorXd& x) const override;

 protected:
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override;

 private:
  /// Where a bound holds a point, its retraction bends as that of a curve; which bounds hold it depends on the step.
  bool knows_curvature() const override { return false; }

  /// Per coordinate the bound that holds it: -1 lower, 1 upper, 0 none.
  using Held = std::array<signed char, kMaxDimension>;

  template <class Holds>
  Held held_by(const Eigen::VectorXd& x, Holds holds) const;
  bool solve_held(Eigen::Ref<Eigen::VectorXd> x, const Held& held) const;
  bool settle(Eigen::Ref<Eigen::VectorXd> x, const Held& kept) const;
  int most_violated(const Eigen::VectorXd& x) const;
  int most_pulling(const Eigen::VectorXd& outside, const Eigen::VectorXd& x, const Held& held, const Held& kept) const;

  Box box_;
};

}  // namespace leastcost
