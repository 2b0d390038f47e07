// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/obstacles/walls.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

struct RobotPose;

/// What keeps a robot out of a configuration: the obstacles of its workspace, each of which is a wall for each of its
/// capsules, and its own parts. A capsule that nothing moves meets no obstacle: the base may stand on one.
///
/// Places are configurations, moves are straight there. Clearances are lengths in the workspace. The gaps of walls are
/// such lengths divided by the length that the capsule goes, at most, as the configuration moves by 1: like distances
/// in the space of configurations, they change by no more than the place does.
class RobotWalls final : public Walls, public std::enable_shared_from_this<RobotWalls> {
 public:
  using Obstacles = std::vector<std::shared_ptr<const Obstacle>>;

  /// The clearance is from obstacles; parts of the robot may touch each other. Throws OptionError("clearance") for a
  /// negative one, OptionError("<number of the obstacle>") for an obstacle of another dimension than the workspace.
  RobotWalls(std::shared_ptr<const Robot> robot, Obstacles obstacles, double clearance);

  Eigen::Index dimension() const override { return robot_->kinematics->dimension(); }
  double size() const override { return size_; }
  void near(const Vector& x, double reach, std::vector<Wall>& found) const override;
  MoveClearance clearance(const Vector& a, const Vector& b) const override;
  void along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const override;
  double room(const Vector& a, const Vector& b, double reach) const override;
  std::string obstacle_name(int obstacle) const override;
  void draw(const DrawnPaths& paths, Drawing& out) const override;
  std::optional<PoseStrip> pose_strip(const Points& configurations) const override;
  /// Null for walls that no shared pointer owns.
  std::shared_ptr<const Walls> remembering() const override;

 private:
  friend class RememberingWalls;
  /// A capsule and an obstacle, or another capsule, from whose link it is seen.
  struct Pair {
    int number = 0;
    int capsule = 0;
    int other = 0;
    bool self = false;
    double required = 0;  ///< of the distance between the core of the obstacle, or the other axis, and the axis
    double steepest = 0;  ///< length units that the capsule moves at most as the configuration moves by 1
  };
  struct PairGap {
    Pair pair;
    double gap = 0;  ///< or a bound of what is asked for
  };
  struct Body {
    Vector reach;  ///< of either end of the capsule
    double radius = 0, steepest = 0;
  };
  struct CoreBox {
    Eigen::Vector3d lower, upper;  ///< in the plane z is 0
  };
  /// Between a capsule and what it may touch.
  struct Plane {
    Eigen::Vector3d point, foot, normal;
  };
  class OnMove;

  void add_obstacles(Obstacles obstacles, double clearance);
  void add_self_pairs();
  void near_among(const std::vector<Pair>& pairs, const Vector& x, double reach, std::vector<Wall>& found) const;
  void along_among(const std::vector<Pair>& pairs, const Vector& a, const Vector& b, double reach,
                   std::vector<Wall>& found) const;
  double room_among(const std::vector<PairGap>& pairs, const Vector& a, const Vector& b, double reach) const;
  void gaps_within(const Vector& x, double reach, std::vector<PairGap>& found) const;
  void add_near(const RobotPose& pose, const std::vector<Pair>& pairs, double reach, std::vector<Wall>& found) const;
  void add_along(OnMove& move, const std::vector<Pair>& pairs, double reach, std::vector<Wall>& found) const;
  double room(OnMove& move, const std::vector<PairGap>& pairs, double reach) const;
  template <class Margin>
  void pairs_within(const RobotPose& pose, const Margin& margin, std::vector<Pair>& found) const;
  double distance(const RobotPose& pose, const Pair& pair, double& on_axis, double& on_other) const;
  double distance(const RobotPose& pose, const Pair& pair) const;
  Plane plane(const RobotPose& pose, const Pair& pair) const;
  Vector slope(const RobotPose& pose, const Pair& pair) const;
  int seen_from(const Pair& pair) const;
  bool convex(const Pair& pair) const;
  double rounding(const Vector& a, const Vector& b) const;

  std::shared_ptr<const Robot> robot_;
  Obstacles obstacles_;
  std::vector<CoreBox> boxes_;    ///< of the cores
  std::vector<double> required_;  ///< of the obstacles: radius and clearance
  std::vector<Body> bodies_;
  std::vector<Pair> self_;
  double size_ = 0, farthest_ = 0;
};

}  // namespace leastcost
