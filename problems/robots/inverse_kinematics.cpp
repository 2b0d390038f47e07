// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/inverse_kinematics.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/dense_solves.hpp"

namespace leastcost {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

void check_goal(const Kinematics& robot, const ToolGoal& goal) {
  if (goal.link < 0 || goal.link >= robot.link_count())
    throw OptionError("link", "must be a link of the robot, 0 to " + std::to_string(robot.link_count() - 1));
  if (!goal.tool.allFinite() || !goal.position.allFinite())
    throw OptionError("position", "must have finite coordinates, and so must the tool");
  if (!goal.rotation) return;
  const Matrix3d& turn = *goal.rotation;
  if (!turn.allFinite() || (turn.transpose() * turn - Matrix3d::Identity()).norm() > 1e-6 || turn.determinant() < 0)
    throw OptionError("rotation", "must be a rotation: orthonormal, with the determinant 1");
}

class ToolSolve {
 public:
  ToolSolve(const Kinematics& robot, const ToolGoal& goal, double tolerance) : robot_(robot), goal_(goal) {
    lower_ = robot.lower();
    upper_ = robot.upper();
    size_ = std::max(1e-300, goal.position.norm());
    const VectorXd reach = robot.reach(goal.link, goal.tool);
    if (reach.size() > 0) size_ = std::max(size_, reach.maxCoeff());
    marks_ = {goal.tool};
    if (goal.rotation) {  // places of three points not in line say how a link is turned
      const double arm = 0.1 * size_;
      marks_.emplace_back(goal.tool + arm * Vector3d::UnitX());
      marks_.emplace_back(goal.tool + arm * Vector3d::UnitY());
    }
    tolerance_ = tolerance * size_;
  }

  /// A random configuration; where a coordinate has no limit, within half a turn of `near`.
  VectorXd any(const VectorXd& near, std::mt19937_64& random) const {
    VectorXd x(near.size());
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      const double low = std::isfinite(lower_[j]) ? lower_[j] : near[j] - std::numbers::pi;
      const double high = std::isfinite(upper_[j]) ? upper_[j] : near[j] + std::numbers::pi;
      x[j] = std::uniform_real_distribution<double>(low, std::max(low, high))(random);
    }
    return x;
  }

  VectorXd within_limits(const VectorXd& x) const { return x.cwiseMax(lower_).cwiseMin(upper_); }

  /// From x to a configuration with the tool at its goal; false where that does not come about.
  bool solve(VectorXd& x) const {
    constexpr int kSteps = 100;
    double damping = 1e-3;
    VectorXd off, trial_off;
    Eigen::MatrixXd slope, trial_slope;
    evaluate(x, off, slope);
    for (int step = 0; step < kSteps; ++step) {
      if (reached(off)) return true;
      const Eigen::MatrixXd normal =
          slope.transpose() * slope + damping * size_ * size_ * Eigen::MatrixXd::Identity(x.size(), x.size());
      const VectorXd trial = within_limits(x - solve_symmetric(normal, slope.transpose() * off));
      evaluate(trial, trial_off, trial_slope);
      if (trial_off.squaredNorm() < off.squaredNorm()) {
        x = trial;
        off.swap(trial_off);
        slope.swap(trial_slope);
        damping = std::max(damping / 10, 1e-15);
      } else {
        damping *= 10;
        if (damping > 1e8) return false;
      }
    }
    return reached(off);
  }

  /// Along the configurations that keep the tool at its goal, as near to `near` as half steps lead.
  void approach(const VectorXd& near, VectorXd& x) const {
    constexpr int kSteps = 40;
    double part = 1;
    for (int step = 0; step < kSteps && part > 1e-3; ++step) {
      VectorXd off;
      Eigen::MatrixXd slope;
      evaluate(x, off, slope);
      const VectorXd wish = near - x;
      const VectorXd free = wish - least_squares(slope, slope * wish);
      if (free.norm() < 1e-6 * (1 + wish.norm())) return;
      VectorXd trial = within_limits(x + part * free);
      if (solve(trial) && (trial - near).norm() < (x - near).norm())
        x = trial;
      else
        part /= 2;
    }
  }

 private:
  /// Of the marks from where they are to be, and the derivative.
  void evaluate(const VectorXd& x, VectorXd& off, Eigen::MatrixXd& slope) const {
    const auto marks = static_cast<Eigen::Index>(marks_.size());
    off.resize(3 * marks);
    slope.resize(3 * marks, x.size());
    robot_.place(x, links_);
    Eigen::Matrix3Xd derivative;
    for (Eigen::Index k = 0; k < marks; ++k) {
      const Vector3d& mark = marks_[static_cast<std::size_t>(k)];
      const Vector3d at = links_[static_cast<std::size_t>(goal_.link)].at(mark);
      const Vector3d wanted =
          k == 0 ? goal_.position : Vector3d(goal_.position + *goal_.rotation * (mark - goal_.tool));
      robot_.jacobian(x, links_, goal_.link, at, derivative);
      off.segment<3>(3 * k) = at - wanted;
      slope.middleRows(3 * k, 3) = derivative;
    }
  }

  bool reached(const VectorXd& off) const { return off.cwiseAbs().maxCoeff() <= tolerance_; }

  const Kinematics& robot_;
  const ToolGoal& goal_;
  VectorXd lower_, upper_;
  std::vector<Vector3d> marks_;
  double size_ = 1, tolerance_ = 0;
  mutable std::vector<Frame> links_;  ///< room for place()
};

}  // namespace

std::vector<VectorXd> inverse_kinematics(const Kinematics& robot, const ToolGoal& goal, const VectorXd& near,
                                         const std::function<bool(const VectorXd&)>& allowed,
                                         const InverseOptions& options) {
  check_goal(robot, goal);
  if (near.size() != robot.lower().size())
    throw InputError("a configuration of this robot has " + std::to_string(robot.lower().size()) +
                     " coordinates, but the one to be near to has " + std::to_string(near.size()));
  const ToolSolve tool(robot, goal, options.tolerance);
  std::mt19937_64 random(options.seed);
  std::vector<VectorXd> found;
  for (int start = 0; start <= options.starts; ++start) {
    VectorXd x = start == 0 ? tool.within_limits(near) : tool.any(near, random);
    if (!tool.solve(x)) continue;
    const VectorXd away = x;  // allowed perhaps, where what is nearer is not
    tool.approach(near, x);
    if (allowed(x))
      found.push_back(x);
    else if (allowed(away))
      found.push_back(away);
  }
  std::stable_sort(found.begin(), found.end(), [&](const VectorXd& a, const VectorXd& b) {
    return (a - near).squaredNorm() < (b - near).squaredNorm();
  });
  std::vector<VectorXd> distinct;
  for (const VectorXd& x : found) {
    if (static_cast<int>(distinct.size()) == options.most) break;
    const bool known = std::any_of(distinct.begin(), distinct.end(),
                                   [&](const VectorXd& other) { return (x - other).norm() < options.apart; });
    if (!known) distinct.push_back(x);
  }
  return distinct;
}

}  // namespace leastcost
