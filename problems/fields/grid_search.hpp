// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include "problems/graph/lattice_route.hpp"

namespace leastcost {

/// Moves of a problem: what they cost, and whether obstacles let them pass.
class MoveCheck {
 public:
  explicit MoveCheck(const Problem& problem);
  double cost(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  /// Clear of obstacles. Long moves are checked in pieces of `piece`, so that each meets few of them.
  bool clear(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double piece) const;
  bool euclidean() const { return euclidean_; }
  bool among_obstacles() const { return obstacles_ != nullptr; }
  bool below_curves() const;

 private:
  const Problem& problem_;
  const ChecksMoves* obstacles_;
  bool euclidean_;
};

/// A regular grid of cells in a box of the plane or of space, whose centres are the nodes of a lattice.
class GridSearch {
 public:
  /// Cells of side `resolution`, centred in the box.
  GridSearch(const Problem& problem, const MoveCheck& moves, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
             double resolution);

  /// The least-cost route from the source to the target; without points where there is none.
  std::vector<Eigen::VectorXd> route(const Monitor& monitor) const;
  const Lattice& lattice() const { return lattice_; }
  double resolution() const { return resolution_; }

 private:
  Eigen::VectorXd center(std::int32_t node) const;
  std::vector<RouteEnd> joined(const Eigen::VectorXd& x, bool from) const;

  const Problem& problem_;
  const MoveCheck& moves_;
  double resolution_;
  Lattice lattice_;
  Eigen::VectorXd first_;  ///< centre of node 0
};

/// The same route with what lies between two points left out where the straight move is clear and costs no more.
std::vector<Eigen::VectorXd> with_shortcuts(const std::vector<Eigen::VectorXd>& route, const MoveCheck& moves,
                                            double piece, const Monitor& monitor);

}  // namespace leastcost
