// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// Where a link is: its own coordinates in those of the workspace.
struct Frame {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< of the link in space
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();        ///< place of the link's origin

  /// Place of a point of the link.
  Eigen::Vector3d at(const Eigen::Vector3d& local) const { return rotation * local + origin; }
};

/// Of a point during the straight move a + t (b - a) between two configurations, 0 <= t <= 1.
struct MotionBound {
  double speed = 0;         ///< length units per t, nowhere exceeded; infinite where nothing is known
  double acceleration = 0;  ///< length units per t^2
  double jerk = 0;          ///< length units per t^3
};

/// Of a point at one t of such a move, in the workspace.
struct PointMotion {
  Eigen::Vector3d velocity, acceleration;  ///< first and second derivative along the move
};

/// Where the links of a robot are in a configuration, an ambient column of the domain. In the plane z is 0. Immutable,
/// and shared by threads.
class Kinematics {
 public:
  using Vector = Eigen::VectorXd;

  virtual ~Kinematics() = default;
  /// Rows of a configuration.
  virtual Eigen::Index dimension() const = 0;
  /// 2 or 3: of the workspace.
  virtual int space() const = 0;
  virtual int link_count() const = 0;  ///< number of links
  /// For messages: "link 5".
  virtual std::string link_name(int link) const = 0;
  /// One frame for each link.
  virtual void place(const Vector& configuration, std::vector<Frame>& links) const = 0;
  /// The derivative of a point (workspace) that is fixed to a link, 3 x dimension(); `links` as place() made them.
  virtual void jacobian(const Vector& configuration, const std::vector<Frame>& links, int link,
                        const Eigen::Vector3d& point, Eigen::Matrix3Xd& derivative) const = 0;
  /// For each coordinate how far it moves a point of a link (its coordinates), per unit, in any configuration, at most.
  virtual Vector reach(int link, const Eigen::Vector3d& local) const = 0;
  /// The same as seen from another link, for steepest() and motion() as seen from there. Of a chain the reaches are the
  /// same: what lies before the other link is left out there.
  virtual Vector reach_from(int /*seen_from*/, int link, const Eigen::Vector3d& local) const {
    return reach(link, local);
  }
  /// Whether all that moves a link moves another one with it: whether it lies on the way from the base to that one. Of
  /// a chain every link before it.
  virtual bool carries(int link, int other) const { return link <= other; }
  /// How far a point with these reaches moves at most as the configuration moves by 1, as seen from another link.
  virtual double steepest(const Vector& reach, int seen_from) const = 0;
  /// During the move from a to b, of any point with at most these reaches, as seen from another link.
  virtual MotionBound motion(const Vector& a, const Vector& b, const Vector& reach, int seen_from) const = 0;
  /// Of a point (workspace) of a link at x on a move with b - a = way, as seen from another link, which stands still.
  virtual PointMotion moving(const Vector& x, const std::vector<Frame>& links, const Vector& way, int link,
                             const Eigen::Vector3d& point, int seen_from) const = 0;
  /// Limits of the coordinates, possibly infinite.
  virtual Vector lower() const = 0;
  virtual Vector upper() const = 0;  ///< greatest coordinates; inf: none
};

}  // namespace leastcost
