// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/domain/goes_beyond_bounds.hpp>
#include <leastcost/framework/domain/has_blocks.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include <leastcost/framework/domain/has_images.hpp>
#include <leastcost/framework/domain/has_sample_box.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/domain/names_coordinates.hpp>

namespace leastcost {

/// The product of domains: a point has a place in each of them, their coordinates one below the other. Distances and
/// right angles are those of all coordinates together; how a turn counts against a length is a matter of the cost
/// (costs/weighted_length.hpp).
///
/// It is flat where all factors are, else smooth; has the bounds and the box of its factors, and their images: a point
/// is named anew by an image in one factor, in several or in all.
class ProductManifold : public ConstraintManifold,
                        public GoesBeyondBounds,
                        public HasBox,
                        public HasImages,
                        public HasBlocks,
                        public HasSampleBox,
                        public NamesCoordinates,
                        public ExplainsProjection {
 public:
  using Factors = std::vector<std::shared_ptr<const ConstraintManifold>>;

  /// Throws InputError, with the number of the factor, for none, a null one, one that is a chart, a mesh or another
  /// domain made of pieces or from data, or one among obstacles: these belong around the product. `names` of the
  /// coordinates, one each; default: x, y, z, or x0, x1, ...
  explicit ProductManifold(Factors factors, std::vector<std::string> names = {});

  const Factors& factors() const { return factors_; }  ///< in the order of their coordinates

  Dimensions dimensions() const override { return dimensions_; }
  Shape shape() const override { return shape_; }
  Projection project(CoordinatePath& path) const override;
  void tangent_bases(const CoordinatePath& path, Points& bases) const override;
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  void retract_beyond(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  double residual(const CoordinatePath& path) const override;
  int active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const override;
  const Eigen::VectorXd& box_lower() const override { return lower_; }
  const Eigen::VectorXd& box_upper() const override { return upper_; }
  std::vector<PointImage> images(const Eigen::VectorXd& x, const Eigen::VectorXd& reference,
                                 std::size_t most) const override;
  /// Whether the coordinates in any factor do.
  bool states_way(const Eigen::VectorXd& target, const Eigen::VectorXd& source) const override;
  /// The blocks of factors that have some, else one for each factor.
  std::vector<CoordinateBlock> blocks() const override;
  std::vector<std::string> coordinate_names() const override { return names_; }
  /// Those of factors that have one, else their boxes.
  SampleBox sample_box(const Eigen::VectorXd& source, const Eigen::VectorXd& target) const override;
  std::string why_not_projected(const Eigen::VectorXd& x) const override;

 private:
  struct Part {
    const ConstraintManifold* domain;
    Index first, size;        ///< of its coordinates
    Index tangent;            ///< its degrees of freedom
    const HasBounds* bounds;  ///< null where nothing bounds it
    bool adds;                ///< a step is an addition, nothing holds it
  };
  static CoordinatePath of(const Part& part, const CoordinatePath& path);
  template <class Move>
  void move(const CoordinatePath& from, const Points& step, CoordinatePath& to, Move move_part) const;

  Factors factors_;
  std::vector<Part> parts_;
  Dimensions dimensions_;
  Shape shape_ = Shape::flat;
  Eigen::VectorXd lower_, upper_;
  std::vector<std::string> names_;
};

}  // namespace leastcost
