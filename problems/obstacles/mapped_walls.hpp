// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/drawing/draws_poses.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// Walls seen from places that name the same coordinates in another order, or more of them: among poses (HasOrigin)
/// they keep out the origin of a body, however it is turned. Gaps and clearances are the same numbers.
///
/// What speaks of places has to be mapped: nothing that is not mapped here is handed on.
class MappedWalls final : public Walls,
                          public HasSupportPlanes,
                          public GapsAreDistances,
                          public Remembers,
                          public DecidesMoves,
                          public DrawsItself,
                          public DrawsPoses {
 public:
  /// Coordinate i of `walls` is coordinate rows[i] of places, which have `dimension` of them.
  MappedWalls(Eigen::Index dimension, std::vector<Eigen::Index> rows, std::shared_ptr<const Walls> walls);

  Eigen::Index dimension() const override { return dimension_; }
  double size() const override { return walls_->size(); }
  double computed_from() const override { return walls_->computed_from(); }
  void near(const Vector& x, double reach, std::vector<Wall>& found) const override;
  MoveClearance clearance(const Vector& a, const Vector& b) const override;
  void along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const override;
  double room(const Vector& a, const Vector& b, double reach) const override;
  std::string obstacle_name(int obstacle) const override { return walls_->obstacle_name(obstacle); }
  std::string depth_text(int obstacle, double missing) const override { return walls_->depth_text(obstacle, missing); }

  /// Where no coordinate is left out.
  bool planes(const Vector& a, const Vector& b, double reach, std::vector<SupportPlane>& found) const override;
  std::shared_ptr<const Walls> remembering() const override;
  bool clears(const Vector& a, const Vector& b) const override;
  /// Where coordinates are left out: outlines in the plane, at height 0; and a note, for they stand in no picture of
  /// space.
  void draw(const DrawnPaths& paths, Drawing& out) const override;
  PoseStrip pose_strip(const Points& configurations) const override;

 private:
  bool gaps_are_distances() const override;
  bool decides_moves() const override { return find_ability<DecidesMoves>(*walls_) != nullptr; }
  bool has_poses() const override;
  bool all_rows() const { return dimension_ == walls_->dimension(); }
  Vector mapped(const Vector& x) const { return x(rows_); }
  Vector back(const Vector& y) const;
  void map_slopes_back(std::vector<Wall>& found) const;

  Eigen::Index dimension_;
  std::vector<Eigen::Index> rows_;
  std::shared_ptr<const Walls> walls_;
};

}  // namespace leastcost
