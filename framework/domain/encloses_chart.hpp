// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <leastcost/framework/numbers/interval_jet.hpp>

namespace leastcost {

/// Ability of a domain whose points are given by two coordinates in a chart x(u): positions and derivatives can be
/// enclosed in intervals, because the chart is a formula. What the certificate's proof needs of it.
class EnclosesChart {
 public:
  virtual ~EnclosesChart() = default;
  /// The ambient position at u, which is a function of two variables, and dx/du, row by row. Where the chart is not
  /// defined nothing is known (Interval::all()).
  virtual void enclose_chart(std::span<const IntervalJet<2>, 2> u, std::span<IntervalJet<2>> x,
                             std::span<IntervalJet<2>> jacobian) const = 0;
};

}  // namespace leastcost
