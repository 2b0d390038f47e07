// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/path/path.hpp>
#include <leastcost/problems/obstacles/walls.hpp>
#include "framework/newton/chain_program.hpp"

namespace leastcost {

/// A polyline of straight moves in a flat domain of any dimension, which is pulled tight among walls of any shape. The
/// walls beside a move are taken as half-spaces for its two ends, linear at the place of the move where they are
/// nearest; the least stretched chain of springs between them, within a radius of each vertex, is the next polyline
/// (sequential convex programming with trust regions: TrajOpt, Schulman et al. 2014), corrected where walls bend away
/// from their half-spaces. Vertices whose moves are not clear then, as far as Walls::along() sees, go less far. So no
/// polyline is longer than the one before it.
class PulledChain {
 public:
  /// `metric`: of the length, d x d, positive definite. `start`: d x m, m >= 2, of some length. `kept`:
  /// of the length, from walls. Domain, walls and monitor outlive it. Throws InputError for shapes that do not fit.
  PulledChain(const ConstraintManifold& domain, const Walls& walls, Eigen::MatrixXd metric, Points start, double kept,
              const Monitor& monitor);

  const Points& polyline() const { return x_; }
  double length() const { return length_of(x_); }

  /// One program and its corrections. False: the polyline stays, and its vertices will go less far. Throws Interrupted.
  bool pull();
  /// Until two pulls in a row gain less than that part of the length. Throws Interrupted.
  void pull_tight(double least);
  /// Leaves out vertices at which it does not bend and puts new ones on both sides of those at which a smoother bend
  /// could save more than that part of the length. False: there is none.
  bool refine(double least);

 private:
  /// What is beside a move from a to b, as far as was looked.
  struct Look {
    Eigen::VectorXd a, b;
    double reach = 0;
    std::vector<Wall> walls = {};
  };
  using Looks = std::vector<Look>;

  double length_of(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  double length_of(const Points& x) const;
  void take(Points polyline);
  void look(const Points& x, Index move, Look& look) const;
  void look_around();
  std::vector<Index> not_clear(const Points& x, const std::vector<Index>& moves, Looks& looks) const;
  void add_springs(ChainSystem& springs, Eigen::VectorXd& force) const;
  void add_walls(const Looks& looks, bool corrects, ChainHalfSpaces& rows) const;
  void add_bounds(ChainHalfSpaces& rows) const;
  std::optional<Points> step_between(const Looks& looks, bool corrects) const;
  Points held_back(Points step, std::vector<Index> bad, Looks& looks, std::vector<char>& held) const;

  double saved_by_bending(const Eigen::VectorXd& before, const Eigen::VectorXd& x, const Eigen::VectorXd& after) const;

  const ConstraintManifold& domain_;
  const Walls& walls_;
  const Monitor& monitor_;
  const Eigen::MatrixXd metric_;
  Points x_;
  Looks looks_;            ///< at x_; empty: none yet
  Eigen::VectorXd radii_;  ///< how far vertices go in one pull, and walls are looked for
  double unit_;            ///< the length in coordinates that it began with
  double kept_;            ///< of that
};

}  // namespace leastcost
