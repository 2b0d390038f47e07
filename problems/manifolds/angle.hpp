// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include <leastcost/framework/domain/has_images.hpp>
#include <leastcost/framework/domain/has_sample_box.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/manifolds/box.hpp>

namespace leastcost {

/// Limits of an angle: both, one or none.
struct AngleOptions {
  std::optional<double> lower = {};  ///< radians
  std::optional<double> upper = {};  ///< radians
};

/// One angle in radians, a turn without end: u and u + 2 pi k name the same point. The coordinate lies on the universal
/// cover, so that paths keep their winding; straight moves stay in it. A target a turn or more from the source states a
/// winding. Between limits only the images within them count; a joint that turns by less than a turn has none.
class AngleManifold final : public ConstraintManifold,
                            public HasBounds,
                            public HasBox,
                            public HasImages,
                            public HasSampleBox {
 public:
  /// Throws OptionError("lower" or "upper") for limits that are no numbers or leave no room.
  explicit AngleManifold(const AngleOptions& options = {});

  Dimensions dimensions() const override { return {1, 1, 1}; }
  Shape shape() const override { return Shape::flat; }
  Projection project(CoordinatePath& path) const override;
  void tangent_bases(const CoordinatePath& path, Points& bases) const override;
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  double residual(const CoordinatePath& path) const override;
  int active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const override;
  const Eigen::VectorXd& box_lower() const override { return box_.lower(); }
  const Eigen::VectorXd& box_upper() const override { return box_.upper(); }
  /// Those up to one turn either way from the nearest.
  std::vector<PointImage> images(const Eigen::VectorXd& x, const Eigen::VectorXd& reference,
                                 std::size_t most) const override;
  bool states_way(const Eigen::VectorXd& target, const Eigen::VectorXd& source) const override;
  /// Half a turn beyond the ends, within the limits.
  SampleBox sample_box(const Eigen::VectorXd& source, const Eigen::VectorXd& target) const override;

 private:
  Box box_;
};

}  // namespace leastcost
