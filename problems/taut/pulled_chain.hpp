// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <leastcost/framework/manifold.hpp>
#include <leastcost/framework/monitor.hpp>
#include <leastcost/framework/path.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// A polyline of straight moves in a domain of any dimension, flat or smooth, which is pulled tight among walls of any
/// shape: those beside each move are held as half-spaces, linear at the place of the move where they are nearest, and
/// the least stretched chain of springs between them is the next polyline, corrected where the walls bend away from
/// their half-spaces (sequential convex programming; TrajOpt, Schulman et al. 2014). It is taken only where it is
/// shorter and, as far as Walls::along() sees, clear.
class PulledChain {
 public:
  /// `metric`: of the length, d x d, positive definite. `start`: d x m, m >= 2, on the domain, of some length. Domain,
  /// walls and monitor outlive it.
  PulledChain(const ConstraintManifold& domain, const Walls& walls, Eigen::MatrixXd metric, Points start,
              const Monitor& monitor);

  const Points& polyline() const { return x_; }
  double length() const { return length_of(x_); }
  /// Whether every move is clear, as the walls prove it.
  bool clears() const;
  void take(Points polyline);

  /// One program and its corrections. False: it is not shorter by more than rounding; it stays.
  bool pull();
  /// Until a pull gains less than that part of the length, twice.
  void pull_tight(double least);
  /// Leaves out vertices at which it does not bend and puts two beside each at which a smoother bend could save more
  /// than that part of the length. False: there is none.
  bool refine(double least);

 private:
  using Looks = std::vector<std::vector<Wall>>;

  double length_of(const Points& x) const;
  double length_of(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  Looks look(const Points& x) const;
  std::optional<Points> between(const Points& about, const Looks& looks) const;
  Points moved(const Points& step, double share) const;
  double turn(const Points& x, Index vertex) const;

  const ConstraintManifold& domain_;
  const Walls& walls_;
  const Monitor& monitor_;
  const Eigen::MatrixXd metric_;
  Points x_;
  Points bases_;    ///< tangent, of all vertices
  Looks looks_;     ///< at x_
  double unit_;     ///< the length in coordinates that it began with
  double reach_;    ///< how far walls are looked for and vertices go
};

}  // namespace leastcost
