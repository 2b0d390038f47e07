// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/robots/kinematics.hpp>

namespace leastcost {

/// What the four numbers of a joint mean. standard (Denavit and Hartenberg 1955): Rz(theta) Tz(d) Tx(a) Rx(alpha), and
/// joint i turns about z of frame i - 1. modified (Craig 1986): Rx(alpha) Tx(a) Rz(theta) Tz(d), and joint i turns
/// about z of frame i.
enum class DhConvention { standard, modified };
Words<DhConvention> words(DhConvention);

/// A chain of joints that turn.
struct DhTable {
  DhConvention convention = DhConvention::standard;  ///< which frame a row moves to
  Eigen::MatrixXd rows = {};   ///< joints x 4: a (length), alpha (rad), d (length), offset of theta (rad)
  Eigen::VectorXd lower = {};  ///< rad, possibly infinite
  Eigen::VectorXd upper = {};  ///< rad
  Eigen::Vector3d base = Eigen::Vector3d::Zero();  ///< where the base stands
};

/// An arm of joints that turn, from a Denavit-Hartenberg table. A configuration has an angle (rad) for each joint; link
/// 0 is the base, which does not move, link i what joint i moves, with the frame of row i.
class DhArm final : public Kinematics {
 public:
  /// Throws OptionError("rows"), ("lower"), ("upper") for a table that is none.
  explicit DhArm(DhTable table);
  const DhTable& table() const { return table_; }  ///< the rows that it was made of

  Eigen::Index dimension() const override { return table_.rows.rows(); }
  int space() const override { return 3; }
  int link_count() const override { return static_cast<int>(dimension()) + 1; }
  std::string link_name(int link) const override;
  void place(const Vector& configuration, std::vector<Frame>& links) const override;
  void jacobian(const Vector& configuration, const std::vector<Frame>& links, int link, const Eigen::Vector3d& point,
                Eigen::Matrix3Xd& derivative) const override;
  Vector reach(int link, const Eigen::Vector3d& local) const override;
  double steepest(const Vector& reach, int seen_from) const override;
  MotionBound motion(const Vector& a, const Vector& b, const Vector& reach, int seen_from) const override;
  PointMotion moving(const Vector& x, const std::vector<Frame>& links, const Vector& way, int link,
                     const Eigen::Vector3d& point, int seen_from) const override;
  Vector lower() const override { return table_.lower; }
  Vector upper() const override { return table_.upper; }

 private:
  /// The frame in which a joint turns about z, for the frames of the links.
  const Frame& axis_frame(const std::vector<Frame>& links, int joint) const;

  DhTable table_;
  std::vector<Eigen::Matrix3d> tilts_;  ///< Rx(alpha)
};

}  // namespace leastcost
