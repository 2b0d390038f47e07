// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string_view>

#include <leastcost/framework/cost/encloses_metric.hpp>
#include <leastcost/framework/cost/has_conformal_metric.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// Ability of a cost: it is the length under a constant metric tensor M of the ambient space (the identity for the
/// Euclidean cost). Straightening needs it: the polyhedron then unfolds as usual in the coordinates A x, M = A'A.
class HasConstantMetric {
 public:
  static constexpr std::string_view kAbility = "constant metric";
  virtual ~HasConstantMetric() = default;
  /// The same everywhere: symmetric, positive definite, ambient x ambient.
  virtual Eigen::MatrixXd metric() const = 0;
};

/// A cost that has it, in any dimension.
class ConstantMetricCost : public SegmentCost,
                           public HasConstantMetric,
                           public HasConformalMetric,
                           public EnclosesMetricBy<ConstantMetricCost> {
 public:
  Eigen::MatrixXd base() const override { return metric(); }
  IntervalJet<2> enclose_squared_index(std::span<const IntervalJet<2>>) const override { return 1.0; }
  IntervalJet<3> enclose_squared_index(std::span<const IntervalJet<3>>) const override { return 1.0; }
  /// Encloses the metric, which is the same everywhere.
  template <class Jet>
  void enclose(std::span<const Jet>, std::span<Jet> upper) const {
    const Eigen::MatrixXd g = metric();
    std::size_t k = 0;
    for (Eigen::Index i = 0; i < g.rows(); ++i)
      for (Eigen::Index j = i; j < g.cols(); ++j) upper[k++] = Jet(g(i, j));
  }
};

}  // namespace leastcost
