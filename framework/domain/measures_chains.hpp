// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include <leastcost/framework/domain/checks_moves.hpp>

namespace leastcost {

/// The least clearance of the moves of a chain.
struct ChainClearance {
  MoveClearance least;       ///< where the chain comes closest
  Eigen::Index segment = 0;  ///< on which it is nearest
};

/// Ability of walls, and of a domain among them, that look at a chain of moves more quickly as a whole than move by
/// move.
class MeasuresChains {
 public:
  virtual ~MeasuresChains() = default;
  bool present() const { return measures_chains(); }
  /// Of the moves from each place (ambient x points, at least two) to the next, as ChecksMoves::clearance() of each.
  /// Nothing where that is not known; then the moves are asked for one by one.
  virtual std::optional<ChainClearance> chain_clearance(const Eigen::MatrixXd& x) const = 0;

 private:
  virtual bool measures_chains() const { return true; }
};

}  // namespace leastcost
