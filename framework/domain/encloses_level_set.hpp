// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <leastcost/framework/numbers/dual.hpp>
#include <leastcost/framework/numbers/interval_jet.hpp>

namespace leastcost {

/// F: R^3 -> R in intervals. Where F is not defined nothing is known (IntervalJet::unknown()).
class LevelSetEnclosure {
 public:
  using Sloped = Dual<IntervalJet<2>, 3>;

  virtual ~LevelSetEnclosure() = default;
  /// F at x, which depends on three variables.
  virtual IntervalJet<3> enclose(std::span<const IntervalJet<3>, 3> x) const = 0;
  /// F and its gradient at x, which depends on two variables.
  virtual Sloped enclose(std::span<const Sloped, 3> x) const = 0;
};

/// Ability of a surface F(x) = 0 in space: F can be enclosed in intervals, because it is a formula. What the
/// certificate's proof needs of it.
class EnclosesLevelSet {
 public:
  virtual ~EnclosesLevelSet() = default;
  /// Null where this one is no such surface. Lives as long as this object.
  virtual const LevelSetEnclosure* level_set_enclosure() const = 0;
  bool present() const { return level_set_enclosure() != nullptr; }
};

}  // namespace leastcost
