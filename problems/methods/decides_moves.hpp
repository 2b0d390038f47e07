// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace leastcost {

/// Ability of walls, and of a flat domain among them, that tell more quickly whether a straight move is clear than how
/// clear it is.
class DecidesMoves {
 public:
  virtual ~DecidesMoves() = default;
  bool present() const { return decides_moves(); }
  /// True: the whole move is proved to be clear, contact included, as far as it can be told. False: it touches, or that
  /// is not known.
  virtual bool clears(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const = 0;

 private:
  virtual bool decides_moves() const { return true; }
};

}  // namespace leastcost
