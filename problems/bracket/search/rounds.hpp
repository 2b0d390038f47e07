// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "problems/bracket/grid.hpp"

namespace leastcost::bracket {

/// When lowering the density of a bisector's front has brought what it can: in the plane where some rounds brought
/// little; in space, where each costs more, where one did and the excess does not fall either, or is small by the gap.
template <int N>
class Rounds;

template <>
class Rounds<2> {
 public:
  Rounds(int most, int patience) : most_(most), patience_(patience) {}
  /// `lower`: what this one has proved; `before`: the gap before it.
  template <class B>
  bool are_enough(const B& found, double ratio, double lower, double /*before*/) {
    constexpr double kWorthWhile = 0.97;
    idle_ = round_ > 1 && found.upper - lower > kWorthWhile * (found.upper - best_) ? idle_ + 1 : 0;
    best_ = std::max(best_, lower);
    return !(ratio > 1) || round_++ == most_ || idle_ == patience_;
  }

 private:
  int most_, patience_, round_ = 0;
  int idle_ = 0;     ///< rounds that brought little
  double best_ = 0;  ///< on this grid
};

template <>
class Rounds<3> {
 public:
  Rounds(int most, int /*patience*/) : most_(most) {}
  template <class B>
  bool are_enough(const B& found, double ratio, double /*lower*/, double before) {
    constexpr double kWorthWhile = 0.97, kFallen = 0.7, kSmall = 0.02;
    const double excess = ratio - 1, gap = found.gap();
    const bool stalls = round_ > 1 && gap > kWorthWhile * before && !(excess < kFallen * excess_);
    excess_ = excess;
    return excess <= kSmall * gap || round_++ == most_ || stalls;
  }

 private:
  int most_, round_ = 0;
  double excess_ = kInfinity;
};

}  // namespace leastcost::bracket
