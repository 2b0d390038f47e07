// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// R^d, some of whose rows are quaternions of one length, four each: the sphere S^3.
class PoseDomain final : public EmbeddedManifold {
 public:
  /// `quaternions`: the first row of each, ascending.
  PoseDomain(int rows, std::vector<Index> quaternions, double length = 1);

 protected:
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override;
  void tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const override;

 private:
  std::vector<Index> quaternions_;
  double length_;
};

}  // namespace leastcost
