// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/framework/domain/measures_chains.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/drawing/draws_poses.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/robots/pair_walls.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

struct RobotPose;
class BroadPhase;
class MoveSieve;

/// What keeps a robot out of a configuration: the obstacles of its workspace, each of which is a wall for each of its
/// parts (capsules, plates), and its own parts. A part that nothing moves meets no obstacle: the base may stand on one.
///
/// Places are configurations, moves are straight there. Clearances are lengths in the workspace. The gaps of walls are
/// such lengths divided by the length that the part goes, at most, as the configuration moves by 1: like distances
/// in the space of configurations, they change by no more than the place does.
class RobotWalls final : public PairWalls,
                         public Remembers,
                         public DecidesMoves,
                         public MeasuresChains,
                         public HasThinnestCore,
                         public NumbersWalls,
                         public DrawsItself,
                         public DrawsPoses,
                         public std::enable_shared_from_this<RobotWalls> {
 public:
  using Obstacles = std::vector<std::shared_ptr<const Obstacle>>;

  /// The clearance is from obstacles; parts of the robot may touch each other. Throws OptionError("clearance") for a
  /// negative one, OptionError("<number of the obstacle>") for an obstacle of another dimension than the workspace, and
  /// for one that does not say how far triangles are from it (MeetsTriangles) where the robot has plates.
  RobotWalls(std::shared_ptr<const Robot> robot, Obstacles obstacles, double clearance);

  Eigen::Index dimension() const override { return robot_->kinematics->dimension(); }
  /// Of the robot alone: what is in its way may be as large, and what is not as far off, as it likes.
  double size() const override { return size_; }
  double computed_from() const override { return std::max(size_, scene_); }
  void near(const Vector& x, double reach, std::vector<Wall>& found) const override;
  MoveClearance clearance(const Vector& a, const Vector& b) const override;
  bool clears(const Vector& a, const Vector& b) const override;
  std::optional<ChainClearance> chain_clearance(const Points& x) const override;
  void along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const override;
  double room(const Vector& a, const Vector& b, double reach) const override;
  std::string obstacle_name(int obstacle) const override;
  std::string depth_text(int obstacle, double missing) const override;
  double thinnest() const override { return thinnest_; }
  int wall_count() const override { return static_cast<int>(bodies_.size() * obstacles_.size() + self_.size()); }
  void draw(const DrawnPaths& paths, Drawing& out) const override;
  PoseStrip pose_strip(const Points& configurations) const override;
  /// Null for walls that no shared pointer owns.
  std::shared_ptr<const Walls> remembering() const override;
  void gaps_within(const Vector& x, double reach, std::vector<PairGap>& found) const override;
  void near_among(const std::vector<Pair>& pairs, const Vector& x, double reach,
                  std::vector<Wall>& found) const override;
  void along_among(const std::vector<Pair>& pairs, const Vector& a, const Vector& b, double reach,
                   std::vector<Wall>& found) const override;
  double room_among(const std::vector<PairGap>& pairs, const Vector& a, const Vector& b, double reach) const override;

 private:
  bool has_poses() const override { return true; }
  struct Body {
    Vector reach;  ///< of any corner of the part
    double radius = 0, steepest = 0;
    bool ball = false;  ///< its core is a point
  };
  struct CoreBox {
    Eigen::Vector3d lower, upper;  ///< in the plane z is 0
  };
  /// Of the cores of a pair, and where they are nearest.
  struct Between {
    double distance = 0;
    Eigen::Vector3d point = Eigen::Vector3d::Zero(), foot = Eigen::Vector3d::Zero();  ///< foot: of a pair of axes alone
  };
  /// Between a part and what it may touch.
  struct Plane {
    Eigen::Vector3d point, foot, normal;
  };
  class OnMove;
  class ChainLook;

  MoveClearance least_gap(OnMove& move, double widest, double rounding) const;
  void add_obstacles(Obstacles obstacles, double clearance);
  void add_self_pairs();
  double farthest_place() const;
  double find_thinnest() const;
  void add_near(const RobotPose& pose, const std::vector<Pair>& pairs, double reach, std::vector<Wall>& found) const;
  bool clears_closely(const Vector& a, const Vector& b) const;
  void add_along(OnMove& move, const std::vector<Pair>& pairs, double reach, std::vector<Wall>& found) const;
  double room(OnMove& move, const std::vector<PairGap>& pairs, double reach) const;
  void beside(const CoreBox& box, double farthest, std::vector<int>& found) const;
  template <class Margin>
  void pairs_within(const RobotPose& pose, const Margin& margin, std::vector<Pair>& found) const;
  CoreBox box(const RobotPose& pose, std::size_t part) const;
  Between between(const RobotPose& pose, const Pair& pair) const;
  Plane plane(const Pair& pair, const Between& nearest) const;
  Vector slope(const RobotPose& pose, const Pair& pair, const Between& nearest) const;
  int seen_from(const Pair& pair) const;
  const Vector& reach(const Pair& pair) const;
  bool convex(const Pair& pair) const;
  double rounding(const Vector& a, const Vector& b) const;

  std::shared_ptr<const Robot> robot_;
  double clearance_;
  Obstacles obstacles_;
  std::vector<const MeetsTriangles*> for_plates_;  ///< the same obstacles, where there are plates
  std::vector<CoreBox> boxes_;                     ///< of the cores
  std::vector<std::optional<OrientedBox>> cores_;  ///< where they are boxes, which may be turned
  std::vector<double> required_;                   ///< of the obstacles: radius and clearance
  std::vector<Body> bodies_;
  std::vector<Pair> self_;
  std::vector<Vector> self_reach_;  ///< of their parts, as seen from the others
  double size_ = 0, farthest_ = 0, most_required_ = 0;
  double scene_ = 0;  ///< the largest coordinate or radius of what the robot may come to
  double thinnest_ =
      0;  ///< what is required of pairs, by how far the part moves at most as the configuration moves by 1
  std::shared_ptr<const BroadPhase> tree_;  ///< of the cores, where there are many
  std::shared_ptr<const MoveSieve> sieve_;  ///< null where there are plates
};

}  // namespace leastcost
