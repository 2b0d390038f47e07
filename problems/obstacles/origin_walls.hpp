// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// The walls of the plane or of space as those of poses (HasOrigin): they keep out the origin of a body, however it is
/// turned.
class OriginWalls final : public Walls {
 public:
  /// `walls` of the first coordinates of places with `dimension` of them.
  OriginWalls(Eigen::Index dimension, std::shared_ptr<const Walls> walls);

  Eigen::Index dimension() const override { return dimension_; }
  double size() const override { return walls_->size(); }
  void near(const Vector& x, double reach, std::vector<Wall>& found) const override;
  MoveClearance clearance(const Vector& a, const Vector& b) const override;
  void along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const override;
  double room(const Vector& a, const Vector& b, double reach) const override;
  std::string obstacle_name(int obstacle) const override;
  /// Outlines in the plane, at height 0; and a note, for they stand in no picture of space.
  void draw(const DrawnPaths& paths, Drawing& out) const override;

 private:
  void extend_slopes(std::vector<Wall>& found) const;
  Vector origin(const Vector& x) const { return x.head(walls_->dimension()); }

  Eigen::Index dimension_;
  std::shared_ptr<const Walls> walls_;
};

}  // namespace leastcost
