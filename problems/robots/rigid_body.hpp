// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/robots/kinematics.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

/// A body in the plane. A configuration is (x, y, angle in rad times `turn`): beside lengths `turn` is how far a radian
/// counts as.
class PlanarBody final : public Kinematics {
 public:
  explicit PlanarBody(double turn = 1) : turn_(turn) {}
  Eigen::Index dimension() const override { return 3; }
  int space() const override { return 2; }
  int link_count() const override { return 1; }
  std::string link_name(int) const override { return "the body"; }
  void place(const Vector& configuration, std::vector<Frame>& links) const override;
  void jacobian(const Vector& configuration, const std::vector<Frame>& links, int link, const Eigen::Vector3d& point,
                Eigen::Matrix3Xd& derivative) const override;
  Vector reach(int link, const Eigen::Vector3d& local) const override;
  double steepest(const Vector& reach, int seen_from) const override;
  MotionBound motion(const Vector& a, const Vector& b, const Vector& reach, int seen_from) const override;
  PointMotion moving(const Vector& x, const std::vector<Frame>& links, const Vector& way, int link,
                     const Eigen::Vector3d& point, int seen_from) const override;
  Vector lower() const override;
  Vector upper() const override;

 private:
  double turn_;
};

/// A body in space. A configuration is (x, y, z, qw, qx, qy, qz); the quaternion is normalised on use, so that a
/// straight move between two turns the body about one axis. What is said of it holds for quaternions of length `turn`.
class SpatialBody final : public Kinematics {
 public:
  explicit SpatialBody(double turn = 1) : turn_(turn) {}
  Eigen::Index dimension() const override { return 7; }
  int space() const override { return 3; }
  int link_count() const override { return 1; }
  std::string link_name(int) const override { return "the body"; }
  void place(const Vector& configuration, std::vector<Frame>& links) const override;
  void jacobian(const Vector& configuration, const std::vector<Frame>& links, int link, const Eigen::Vector3d& point,
                Eigen::Matrix3Xd& derivative) const override;
  Vector reach(int link, const Eigen::Vector3d& local) const override;
  double steepest(const Vector& reach, int seen_from) const override;
  MotionBound motion(const Vector& a, const Vector& b, const Vector& reach, int seen_from) const override;
  PointMotion moving(const Vector& x, const std::vector<Frame>& links, const Vector& way, int link,
                     const Eigen::Vector3d& point, int seen_from) const override;
  Vector lower() const override;
  Vector upper() const override;

 private:
  double turn_;
};

/// A body of balls and capsules.
struct RigidBodyOptions {
  Eigen::MatrixXd shape = {};
  void fields(FieldVisitor& visit);
};

/// Throws OptionError("shape").
std::shared_ptr<const Robot> make_rigid_body(const RigidBodyOptions& options);

}  // namespace leastcost
