// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include <leastcost/framework/numbers/interval_jet.hpp>

namespace leastcost {

/// Ability of a cost that is a length under a metric tensor G(x) given by formula: c(x, x + v)^2 = v'G(x)v + o(|v|^2).
/// With enclosures of G and of its derivatives over boxes a certificate can be proved
/// (framework/proof/calibration.hpp).
class EnclosesMetric {
 public:
  static constexpr std::string_view kAbility = "metric by formula";
  virtual ~EnclosesMetric() = default;
  /// The upper triangle of G, row by row, at the ambient positions x, which are functions of two or three variables.
  /// Outside the domain of the cost, and where G may fail to be positive definite, nothing is known (Interval::all()).
  virtual void enclose_metric(std::span<const IntervalJet<2>> x, std::span<IntervalJet<2>> upper) const = 0;
  virtual void enclose_metric(std::span<const IntervalJet<3>> x, std::span<IntervalJet<3>> upper) const = 0;
};

/// Writes both from one member template of Derived: `template <class Jet> void enclose(std::span<const Jet> x,
/// std::span<Jet> upper) const`.
template <class Derived>
class EnclosesMetricBy : public EnclosesMetric {
 public:
  void enclose_metric(std::span<const IntervalJet<2>> x, std::span<IntervalJet<2>> upper) const override {
    static_cast<const Derived&>(*this).enclose(x, upper);
  }
  void enclose_metric(std::span<const IntervalJet<3>> x, std::span<IntervalJet<3>> upper) const override {
    static_cast<const Derived&>(*this).enclose(x, upper);
  }
};

}  // namespace leastcost
