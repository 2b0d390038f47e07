// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>

#include <leastcost/framework/cost/encloses_metric.hpp>
#include <leastcost/framework/numbers/interval_jet.hpp>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// Ability of a cost whose metric is a multiple of a constant one, n(x)^2 B, by formula: c(x, x + v) = n(x) sqrt(v'Bv)
/// + o(|v|). Costs with the same B add up to such a cost, which a sum of lengths under other metrics is not. B is the
/// identity where a length counts alike in all directions (a refractive index n).
class HasConformalMetric {
 public:
  virtual ~HasConformalMetric() = default;
  virtual Eigen::MatrixXd base() const = 0;  ///< B
  /// n^2 at the ambient positions x, which are functions of two or three variables; Interval::all() outside the domain
  /// of the cost, and where n may not be positive.
  virtual IntervalJet<2> enclose_squared_index(std::span<const IntervalJet<2>> x) const = 0;
  virtual IntervalJet<3> enclose_squared_index(std::span<const IntervalJet<3>> x) const = 0;
};

/// Writes both, and the metric, from `template <class Jet> Jet squared_index(std::span<const Jet> x) const` of Derived.
template <class Derived>
class ConformalMetricBy : public HasConformalMetric, public EnclosesMetricBy<ConformalMetricBy<Derived>> {
 public:
  IntervalJet<2> enclose_squared_index(std::span<const IntervalJet<2>> x) const override { return known(x); }
  IntervalJet<3> enclose_squared_index(std::span<const IntervalJet<3>> x) const override { return known(x); }

  /// Encloses the metric at x: the squared index on the diagonal.
  template <class Jet>
  void enclose(std::span<const Jet> x, std::span<Jet> upper) const {
    const Eigen::MatrixXd b = base();
    const Jet squared = known(x);
    std::size_t k = 0;
    for (Eigen::Index i = 0; i < b.rows(); ++i)
      for (Eigen::Index j = i; j < b.cols(); ++j)
        upper[k++] = b(i, j) == 1 ? squared : squared.scaled(Interval(b(i, j)));
  }

 private:
  template <class Jet>
  Jet known(std::span<const Jet> x) const {
    const Jet squared = static_cast<const Derived&>(*this).squared_index(x);
    return squared > Jet(0.0) ? squared : Jet::unknown();
  }
};

}  // namespace leastcost
