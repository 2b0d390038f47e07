// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// Ability of a cost: it is the length under a constant metric tensor M of the ambient space (the identity for the
/// Euclidean cost). Straightening needs it: the polyhedron then unfolds as usual in the coordinates A x, M = A'A.
class HasConstantMetric {
 public:
  virtual ~HasConstantMetric() = default;
  virtual Eigen::MatrixXd metric() const = 0;
};

}  // namespace leastcost
