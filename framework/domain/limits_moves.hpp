// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

namespace leastcost {

/// Ability of a domain among obstacles that knows how long moves may be before its points have to keep away from thin
/// ones, so that no move passes over them.
class LimitsMoves {
 public:
  virtual ~LimitsMoves() = default;
  bool present() const { return limits_moves(); }
  /// Length units of the domain, above 0.
  virtual double longest_move() const = 0;

 private:
  virtual bool limits_moves() const = 0;
};

}  // namespace leastcost
