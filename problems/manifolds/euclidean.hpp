// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/manifolds/box.hpp>
#include <leastcost/problems/post_processors/choose_global_proof.hpp>

namespace leastcost {

struct EuclideanManifoldOptions {
  int dimension = 2;
  BoxOptions box = {};  ///< where points may be
  /// Of the dimension that a box has; without a side, the plane.
  static EuclideanManifoldOptions of(BoxOptions box);
  void fields(FieldVisitor& visit);
};

/// R^d, or a box in it.
class EuclideanManifold final : public ConstraintManifold,
                                public HasBounds,
                                public HasBox,
                                public KnowsGlobalProofs,
                                public DrawsItself {
 public:
  /// Throws OptionError when the box does not fit the dimension or is empty.
  explicit EuclideanManifold(const EuclideanManifoldOptions& options);

  Dimensions dimensions() const override { return {dimension_, dimension_, dimension_}; }
  Shape shape() const override { return Shape::flat; }
  Projection project(CoordinatePath& path) const override;
  void tangent_bases(const CoordinatePath& path, Points& bases) const override;
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  double residual(const CoordinatePath& path) const override;
  int active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const override;
  const Eigen::VectorXd& box_lower() const override { return box_.lower(); }
  const Eigen::VectorXd& box_upper() const override { return box_.upper(); }
  /// Its box, where it has one.
  void draw(const DrawnPaths& paths, Drawing& out) const override;

 private:
  int dimension_;
  Box box_;
};

}  // namespace leastcost
