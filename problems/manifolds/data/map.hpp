// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <leastcost/framework/domain/makes_on_demand.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/problem/has_graph.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/made_from_data.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include <leastcost/problems/occupancy/names_cells.hpp>
#include <leastcost/problems/occupancy/occupancy_grid.hpp>
#include <leastcost/problems/post_processors/choose_global_proof.hpp>

namespace leastcost {

/// The free cells of an occupancy grid, with their borders: a part of the plane. It is a triangle mesh at z = 0, so
/// that paths are straightened exactly around its corners (contact is allowed; two blocked cells that touch in a corner
/// leave no way between them). Sites are triangles. Its graph are the free cells: 8 neighbours, diagonally only where
/// both cells beside are free.
class MapManifold final : public ConstraintManifold,
                          public HasBounds,
                          public HasMesh,
                          public KnowsGlobalProofs,
                          public MakesOnDemand,
                          public HasGraph,
                          public NamesCells,
                          public MadeFromData,
                          public DrawsItself {
 public:
  /// Throws InputError for a grid without free cells.
  explicit MapManifold(const OccupancyGrid& grid);

  Dimensions dimensions() const override { return {2, 2, 2}; }
  Shape shape() const override { return Shape::polyhedral; }
  Projection project(CoordinatePath& path) const override;
  void tangent_bases(const CoordinatePath& path, Points& bases) const override;
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  double residual(const CoordinatePath& path) const override;
  int active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const override;

  const OccupancyGrid& grid() const { return grid_; }  ///< the cells
  const TriangleMesh& mesh() const override { return surface_.mesh(); }
  const ClosestPointTree& tree() const override { return surface_.tree(); }
  void make(const Deadline& deadline) const override { surface_.make(deadline); }
  bool is_asked_by(const CoordinatePath& path) const override;
  FirstPath least_cost_edges(const Problem& problem, const Monitor& monitor) const override;
  double diameter() const override { return surface_.diameter(); }
  /// An end in a blocked cell is an error, not to be moved.
  double end_tolerance() const override;
  std::string why_not_free(const Eigen::VectorXd& x) const override;
  std::vector<std::string> notes() const override { return {}; }
  std::vector<DataCount> counts() const override;
  /// The borders of the free space.
  void draw(const DrawnPaths& paths, Drawing& out) const override;

 private:
  struct Meshed;
  MapManifold(OccupancyGrid grid, Meshed meshed);
  /// The row and the column of the cell with a place, on a grid without end.
  Eigen::Vector2d cell_at(const Eigen::Vector2d& x) const;
  /// The free cells that a place on a triangle lies in.
  std::vector<std::int32_t> cells_of(const PathEnd& end) const;
  Eigen::Vector2d center(std::int32_t cell) const;
  Site site_of(std::int32_t cell) const;

  OccupancyGrid grid_;
  std::vector<CellBox> boxes_;
  std::vector<std::int32_t> face_begin_;  ///< of the boxes
  std::vector<std::int32_t> box_of_cell_;
  MeshManifold surface_;
};

}  // namespace leastcost
