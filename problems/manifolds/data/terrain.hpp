// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/domain/has_box.hpp>
#include <leastcost/framework/domain/has_origin.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/problem/has_graph.hpp>
#include <leastcost/problems/chart/is_geographic.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/manifolds/box.hpp>
#include <leastcost/problems/manifolds/made_from_data.hpp>
#include <leastcost/problems/post_processors/choose_global_proof.hpp>
#include <leastcost/problems/raster/has_raster.hpp>
#include <leastcost/problems/raster/has_voids.hpp>
#include <leastcost/problems/raster/raster.hpp>

namespace leastcost {

class SplineFunction;

/// A terrain: the surface (x, y, z(x, y)) in space, z the bicubic spline through the heights of a raster, with its
/// exact first and second derivatives. Points are places (x, y) on the map. The domain ends at the outermost heights,
/// where points may come to rest, and wherever one of the 16 heights around a cell is missing; there it has no points.
/// Obstacles on it are those of the map.
class TerrainManifold final : public ConstraintManifold,
                              public HasChart,
                              public HasBounds,
                              public HasBox,
                              public KnowsGlobalProofs,
                              public HasGraph,
                              public HasOrigin,
                              public IsGeographic,
                              public ExplainsProjection,
                              public MadeFromData,
                              public HasRaster,
                              public HasVoids,
                              public DrawsItself {
 public:
  /// Throws InputError for a raster of fewer than four rows or columns, or without 16 heights side by side.
  explicit TerrainManifold(RasterGrid heights);

  Dimensions dimensions() const override { return {2, 3, 2}; }
  Shape shape() const override { return Shape::smooth; }
  Projection project(CoordinatePath& path) const override;
  void tangent_bases(const CoordinatePath& path, Points& bases) const override;
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  double residual(const CoordinatePath& path) const override;
  void embed(const CoordinatePath& path, Points& x) const override;
  void jacobians(const CoordinatePath& path, Points& j) const override;
  void curvatures(const CoordinatePath& path, const Points& weights, Points& h) const override;
  const std::vector<SeamMap>& poles() const override;
  std::vector<std::string> coordinate_names() const override { return {"east", "north"}; }
  int active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const override;
  const Eigen::VectorXd& box_lower() const override { return box_.lower(); }
  const Eigen::VectorXd& box_upper() const override { return box_.upper(); }
  int origin_size() const override { return 2; }
  Eigen::Vector2d longitude_latitude(const Eigen::VectorXd& u) const override;
  Eigen::VectorXd coordinates_of(const Eigen::Vector2d& lonlat) const override { return raster_.place_of(lonlat); }
  std::string why_not_projected(const Eigen::VectorXd& x) const override;
  /// Over the places of the heights, by moves to the eight neighbours.
  FirstPath least_cost_edges(const Problem& problem, const Monitor& monitor) const override;
  double diameter() const override;
  /// Half a cell.
  double end_tolerance() const override;
  std::vector<std::string> notes() const override;
  std::vector<DataCount> counts() const override;
  void draw(const DrawnPaths& paths, Drawing& out) const override;

  const RasterPatches& known_patches() const override;

  const RasterGrid& raster() const override { return raster_; }  ///< heights

 private:
  bool is_geographic() const override { return raster_.on_earth(); }
  Eigen::Vector3d on_surface(const Eigen::Vector2d& place) const;
  Eigen::Vector3d node(int row, int column) const;
  bool is_step(int row, int column, int rows, int columns) const;

  RasterGrid raster_;
  std::shared_ptr<const SplineFunction> heights_;
  Box box_;
};

}  // namespace leastcost
