// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <leastcost/framework/domain/encloses_level_set.hpp>
#include <leastcost/framework/domain/has_curvature.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/level_set/constraint_function.hpp>
#include <leastcost/problems/level_set/has_level_set.hpp>
#include <leastcost/problems/section/is_surface.hpp>

namespace leastcost {

/// The zeros of F: R^n -> R^k as a domain. Projection: Gauss-Newton steps x -= J^+ F(x) (VFCS Eq. 15 for k = 1), damped
/// so that |F| falls, until rounding; tangent spaces: the null space of the Jacobian J. No heap in either for k = 1 and
/// n = 2, 3, 4.
///
/// The point that is found differs from the nearest one by O(d^2) at distance d, so that the retraction of a tangent
/// step h does by O(h^4).
class LevelSet : public EmbeddedManifold,
                 public ExplainsProjection,
                 public HasLevelSet,
                 public HasCurvature,
                 public EnclosesLevelSet,
                 public IsSurface,
                 public DrawsItself {
 public:
  /// Throws InputError for k >= n or n beyond the largest dimension of a cost.
  explicit LevelSet(std::shared_ptr<const ConstraintFunction> function);

  std::string why_not_projected(const Eigen::VectorXd& x) const override;
  const ConstraintFunction& function() const override { return *function_; }
  /// -sum_j lambda_j Hess F_j with the multipliers of least |gradient - sum_j lambda_j grad F_j|.
  bool bend(const CoordinatePath& path, Index column, const Eigen::VectorXd& gradient, Points& bend) const override;
  const LevelSetEnclosure* level_set_enclosure() const override { return function_->enclosure(); }
  bool is_surface() const override { return dimensions().ambient == 3 && dimensions().tangent == 2; }
  /// Of one function: a surface in space, curves in the plane.
  void draw(const DrawnPaths& paths, Drawing& out) const override;

 protected:
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override;
  void tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const override;
  /// Moves x to a zero of `function` by the steps above; false where that fails (x is then left alone).
  static bool solve(const ConstraintFunction& function, Eigen::Ref<Eigen::VectorXd> x);

 private:
  bool knows_curvature() const override { return function_->knows_curvature(); }

  std::shared_ptr<const ConstraintFunction> function_;
};

}  // namespace leastcost
