// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <typeinfo>
#include <vector>

#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/domain/fits_segments.hpp>
#include <leastcost/framework/domain/goes_beyond_bounds.hpp>
#include <leastcost/framework/domain/has_curvature.hpp>
#include <leastcost/framework/domain/limits_moves.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/domain/measures_chains.hpp>
#include <leastcost/framework/domain/reuses_margins.hpp>
#include <leastcost/framework/domain/sees_bounds.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/drawing/draws_poses.hpp>
#include <leastcost/problems/obstacles/has_walls.hpp>
#include <leastcost/problems/obstacles/obstacle_walls.hpp>
#include <leastcost/problems/obstacles/wall_margins.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// The part of a domain that keeps out of walls; contact is allowed. They are bounds on which points come to rest and
/// along which they move.
///
/// Points outside do not keep the moves between them outside. So a wall has a margin, which points keep in addition:
/// the least with which no move touches it, found by solving, looking and solving again (FitsSegments). Along a smooth
/// wall of radius r the margin of moves of length L is about L^2 / (8 r): a cost of second order. It is never so small
/// that a move could pass over the core of an obstacle, and a chain that is clear of the cores stays so from one
/// iterate to the next, as far as the walls can tell (Walls::room): it is not drawn through to another side. Points at
/// rest on a wall come with it when its margin is fitted anew.
/// docs/numerics.md Sec. 4.1.
class FreeSpace final : public ConstraintManifold,
                        public GoesBeyondBounds,
                        public HasCurvature,
                        public SeesBounds,
                        public ChecksMoves,
                        public DecidesMoves,
                        public MeasuresChains,
                        public FitsSegments,
                        public ReusesMargins,
                        public LimitsMoves,
                        public HasWalls,
                        public DrawsItself,
                        public DrawsPoses {
 public:
  using Obstacles = ObstacleWalls::Obstacles;

  /// Throws InputError for a domain made of flat pieces or from data, and for walls of another dimension.
  FreeSpace(std::shared_ptr<const ConstraintManifold> domain, std::shared_ptr<const Walls> walls);
  /// Among obstacles: as ObstacleWalls. In a domain of poses (HasOrigin) they keep out the origin of the body.
  FreeSpace(const std::shared_ptr<const ConstraintManifold>& domain, Obstacles obstacles, double clearance);

  Dimensions dimensions() const override { return domain_->dimensions(); }
  Shape shape() const override { return Shape::smooth; }
  Projection project(CoordinatePath& path) const override;
  void tangent_bases(const CoordinatePath& path, Points& bases) const override;
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  void retract_beyond(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  /// Off the domain or into a wall, whatever it is fitted to.
  double residual(const CoordinatePath& path) const override;
  int active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const override;

  void bounds_within(const CoordinatePath& path, Index column, double reach,
                     std::vector<NearBound>& found) const override;
  void retract_onto(const CoordinatePath& from, const Points& step, const BoundsOfPoints& bounds,
                    CoordinatePath& to) const override;

  /// Walls bend; a flat domain does not.
  bool bend(const CoordinatePath& path, Index column, const Eigen::VectorXd& gradient, Points& bend) const override;

  MoveClearance clearance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const override;
  /// Known in the plane, where the walls are made of discs.
  std::optional<bool> same_class(const Points& a, const Points& b) const override;
  std::string obstacle_name(int obstacle) const override;
  std::string depth_text(int obstacle, double missing) const override;
  /// Known in a flat domain whose walls know it.
  bool clears(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const override;

  /// Known in a flat domain whose walls know it.
  std::optional<ChainClearance> chain_clearance(const Points& x) const override;

  std::shared_ptr<const ConstraintManifold> unfitted(const CoordinatePath& path,
                                                     double agreement = kCloseFit) const override;
  SegmentFit fitted(const CoordinatePath& path) const override;
  KeptMargins kept_margins(const CoordinatePath& path, const std::map<int, double>& gaps) const override;
  std::shared_ptr<const ConstraintManifold> unfitted_with(const KeptMargins& kept, const CoordinatePath& path,
                                                          double agreement) const override;
  void carry_along(const KeptMargins& kept, CoordinatePath& path, const Deadline& deadline) const override;
  std::vector<MarginCost> margin_costs(const CoordinatePath& path, const Points& gradient) const override;

  /// Where walls know their thinnest core: longer moves make points keep away from it by more than it is thick.
  double longest_move() const override;

  /// The domain, and the walls.
  void draw(const DrawnPaths& paths, Drawing& out) const override;
  PoseStrip pose_strip(const Points& configurations) const override;
  const ConstraintManifold* decorated(const std::type_info& ability) const override;

  const Walls& walls() const override { return *walls_; }

 private:
  struct Point;
  bool knows_curvature() const override { return flat_; }
  bool has_poses() const override;
  bool decides_moves() const override { return flat_ && find_ability<DecidesMoves>(*walls_) != nullptr; }
  bool measures_chains() const override { return flat_ && find_ability<MeasuresChains>(*walls_) != nullptr; }
  bool limits_moves() const override;
  /// By how much a wall is beyond its margin.
  double room(const Wall& wall) const { return wall.gap - margins_.of(wall); }
  double slack(const Eigen::VectorXd& x) const;
  double thinnest() const;
  std::shared_ptr<FreeSpace> for_solve(WallMargins margins, double agreement) const;
  WallMargins::Fit closeness(const Eigen::MatrixXd& x) const;  ///< of a fit to these places
  void look(Point& point, double reach) const;
  bool anything_near(const Eigen::VectorXd& x, double reach, std::vector<Wall>& found) const;
  void push(Point& point, const Wall& wall, double by) const;
  void push_out_of_all(Point& point, const std::vector<int>& held, double by) const;
  bool settle(Point& point, const std::vector<int>& held, bool bounded, double reach) const;
  bool carry(Point& point) const;
  bool carry_onto(Point& point, const std::vector<int>& held, double gone, double reach) const;
  double look_ahead(double length) const;
  bool clear_way(const Point& start, const std::vector<int>& held, Point& end) const;
  void keep_side(const Point& start, const std::vector<int>& held, Point& end) const;
  void move_along_walls(const CoordinatePath& from, const Points& step, bool bounded, const BoundsOfPoints* onto,
                        CoordinatePath& to) const;
  void keep_class(const CoordinatePath& from, CoordinatePath& to) const;

  std::shared_ptr<const ConstraintManifold> domain_;
  std::shared_ptr<const Walls> walls_;
  const HasChart* chart_;
  bool flat_;  ///< and without a chart: places are coordinates, steps are added
  WallMargins margins_;
  double agreement_ = kCloseFit;  ///< of a path's extent: by so much a move may keep away for nothing
};

}  // namespace leastcost
