// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/ompl/pose_walls.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

constexpr Index kOfQuaternion = 4;  ///< numbers

/// A permutation of coordinates keeps distances: gaps and clearances are the same numbers.
class PoseWalls final : public Walls {
 public:
  PoseWalls(std::shared_ptr<const Walls> poses, std::vector<Index> quaternions)
      : poses_(std::move(poses)), quaternions_(std::move(quaternions)) {}

  Eigen::Index dimension() const override { return poses_->dimension(); }
  double size() const override { return poses_->size(); }
  void near(const Vector& x, double reach, std::vector<Wall>& found) const override {
    poses_->near(pose(x), reach, found);
    turn_slopes(found);
  }
  MoveClearance clearance(const Vector& a, const Vector& b) const override {
    MoveClearance least = poses_->clearance(pose(a), pose(b));
    if (least.place.size() == dimension())
      for (const Index row : quaternions_) scalar_last(least.place.segment<kOfQuaternion>(row));
    return least;
  }
  bool clears(const Vector& a, const Vector& b) const override { return poses_->clears(pose(a), pose(b)); }
  void along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const override {
    poses_->along(pose(a), pose(b), reach, found);
    turn_slopes(found);
  }
  double room(const Vector& a, const Vector& b, double reach) const override {
    return poses_->room(pose(a), pose(b), reach);
  }
  std::string obstacle_name(int obstacle) const override { return poses_->obstacle_name(obstacle); }
  void draw(const DrawnPaths& paths, Drawing& out) const override { poses_->draw(paths, out); }

 private:
  void turn_slopes(std::vector<Wall>& found) const {
    for (Wall& wall : found)
      for (const Index row : quaternions_)
        if (wall.slope.size() == dimension()) scalar_last(wall.slope.segment<kOfQuaternion>(row));
  }
  static void scalar_last(Eigen::Ref<Eigen::VectorXd> q) { std::rotate(q.data(), q.data() + 1, q.data() + 4); }

  Vector pose(const Vector& x) const {
    Vector out = x;
    for (const Index row : quaternions_) {
      double* q = out.data() + row;
      std::rotate(q, q + 3, q + 4);
    }
    return out;
  }

  std::shared_ptr<const Walls> poses_;
  std::vector<Index> quaternions_;  ///< their first rows
};

}  // namespace

std::shared_ptr<const Walls> make_pose_walls(const StateColumns& states, std::shared_ptr<const Walls> poses) {
  if (poses->dimension() != states.rows())
    throw InputError("the obstacles have " + std::to_string(poses->dimension()) +
                     " dimensions, but states of the space have " + std::to_string(states.rows()) + " rows");
  if (!states.has_quaternions()) return poses;
  return std::make_shared<PoseWalls>(std::move(poses), states.quaternions());
}

}  // namespace leastcost
