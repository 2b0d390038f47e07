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
  void take(Points polyline);

  /// One program and its corrections. False: it is not shorter by more than rounding; it stays.
  bool pull();
  /// Until a pull gains less than that part of the length, twice.
  void pull_tight(double least);
  /// Leaves out vertices at which it does not bend and puts two beside each at which a smoother bend could save more
  /// than that part of the length. False: there is none.
  bool refine(double least);

 private:
  /// What is beside a move from a to b, as far as was looked.
  struct Look {
    Eigen::VectorXd a, b;
    double reach = 0;
    std::vector<Wall> walls = {};
  };
  using Looks = std::vector<Look>;

  double length_of(const Points& x) const;
  double length_of(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  void look(const Points& x, Index move, Look& look) const;
  std::vector<Index> look_at(const Points& x, Looks& looks) const;
  std::optional<Points> between(const Looks& looks, bool corrects) const;
  Points moved(const Points& step) const;
  double turn(const Points& x, Index vertex) const;

  const ConstraintManifold& domain_;
  const Walls& walls_;
  const Monitor& monitor_;
  const Eigen::MatrixXd metric_;
  Points x_;
  Points bases_;    ///< tangent, of all vertices
  Looks looks_;     ///< at x_
  double unit_;     ///< the length in coordinates that it began with
  Eigen::VectorXd radii_;  ///< how far vertices go in one pull, and walls are looked for
};

}  // namespace leastcost
