// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <leastcost/problems/obstacles/obstacle.hpp>

namespace leastcost {

/// A core in the plane or in space, turned and moved. Places are taken into its frame, where it is asked for distances:
/// a turned box takes as long as one along the axes.
class PosedObstacle final : public Obstacle, public MeetsTriangles, public HasCoreBox {
 public:
  /// The largest scalar product of a direction with a point of the core, in its frame.
  using Support = std::function<double(const Eigen::Vector3d&)>;

  /// A bounded, convex core. In the plane the pose is one about the z axis. `name`: for messages.
  PosedObstacle(std::shared_ptr<const Obstacle> core, const Support& support, const Eigen::Isometry3d& pose,
                std::string name);

  std::string name() const override { return name_; }
  Box core_bounds() const override { return bounds_; }
  double radius() const override { return core_->radius(); }
  bool convex() const override { return true; }
  bool drawn() const override { return core_->drawn(); }
  Eigen::MatrixXd corners() const override;
  double distance(const Vector& x, Eigen::Ref<Vector> away) const override;
  double distance_of_segment(const Vector& a, const Vector& b, double& t) const override;
  double distance_of_triangle(const std::array<Eigen::Vector3d, 3>& corners, Eigen::Vector3d& nearest) const override;
  OrientedBox core_box() const override { return *core_box_; }

 private:
  bool has_core_box() const override { return core_box_.has_value(); }
  bool measures_triangles() const override { return triangles_ != nullptr; }
  void to_own(const Vector& x, Vector& own) const;

  std::shared_ptr<const Obstacle> core_;
  const MeetsTriangles* triangles_;  ///< the same; null in the plane
  Eigen::Matrix3d turn_;
  Eigen::Vector3d position_;
  std::string name_;
  Box bounds_;
  std::optional<OrientedBox> core_box_ = {};
};

}  // namespace leastcost
