// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

class BroadPhase;

/// The walls of obstacles that stand in the space itself; moves are straight.
class ObstacleWalls final : public Walls,
                            public HasRounds,
                            public HasSupportPlanes,
                            public GapsAreDistances,
                            public NumbersWalls,
                            public DrawsItself {
 public:
  using Obstacles = std::vector<std::shared_ptr<const Obstacle>>;

  /// Throws OptionError("clearance") for a negative one and where it is 0 beside an obstacle with sharp corners,
  /// OptionError("<number of the obstacle>") for one of another dimension.
  ObstacleWalls(Eigen::Index dimension, Obstacles obstacles, double clearance);
  ~ObstacleWalls() override;

  Eigen::Index dimension() const override { return dimension_; }
  double size() const override { return size_; }
  void near(const Vector& x, double reach, std::vector<Wall>& found) const override;
  MoveClearance clearance(const Vector& a, const Vector& b) const override;
  void along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const override;
  double room(const Vector& a, const Vector& b, double reach) const override;
  std::vector<Round> rounds(const Eigen::AlignedBox2d& box) const override;
  bool planes(const Vector& a, const Vector& b, double reach, std::vector<SupportPlane>& found) const override;
  std::string obstacle_name(int obstacle) const override;
  int wall_count() const override { return static_cast<int>(obstacles_.size()); }
  std::string depth_text(int obstacle, double missing) const override;
  void draw(const DrawnPaths& paths, Drawing& out) const override;

 private:
  bool has_rounds() const override { return dimension_ == 2 && bounded_; }
  const Obstacle& obstacle(int i) const { return *obstacles_[static_cast<std::size_t>(i)]; }
  double required(int i) const { return obstacle(i).radius() + clearance_; }
  double depth(int i, const Vector& a, const Vector& b) const;

  Eigen::Index dimension_;
  Obstacles obstacles_;
  double clearance_;
  double least_required_;
  double size_ = 0;
  bool bounded_ = true;                     ///< all of them
  std::unique_ptr<const BroadPhase> tree_;  ///< of what is required
};

}  // namespace leastcost
