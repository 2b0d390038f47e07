// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <leastcost/framework/cost/segment_cost.hpp>

namespace leastcost {

/// q of the segments of a path with its derivatives over both ends of each, zero for the ends of an open path.
struct SquaredCosts {
  Eigen::VectorXd q;
  Points residuals;  ///< rows x N, |r|^2 = q
  Points jacobians;  ///< rows x 2d N
  Points gradients;  ///< 2d x N
  Points hessians;   ///< 2d x 2d N; where they were asked for

  Index count() const { return q.size(); }
  auto hessian(Index i) { return hessians.middleCols(gradients.rows() * i, gradients.rows()); }
  auto hessian(Index i) const { return hessians.middleCols(gradients.rows() * i, gradients.rows()); }
  auto jacobian(Index i) { return jacobians.middleCols(gradients.rows() * i, gradients.rows()); }
  auto jacobian(Index i) const { return jacobians.middleCols(gradients.rows() * i, gradients.rows()); }
};

/// Those of a cost.
SquaredCosts squared_costs_of(const SegmentCost& cost, const AmbientPath& path, bool with_hessians);

/// A cost made from others, segment by segment: the kernel is applied here. Its parts are asked for whole paths.
class DerivedCost : public SegmentCost, public ExplainsInfinity {
 public:
  explicit DerivedCost(CostTraits traits, int dim) : traits_(std::move(traits)), dim_(dim) {}

  int dim() const override { return dim_; }
  const CostTraits& traits() const override { return traits_; }
  double energy_and_gradient(const AmbientPath& path, const Kernel& kernel, double s0,
                             Eigen::Ref<Points> gradient) const override;
  void chain_blocks(const AmbientPath& path, const Kernel& kernel, double s0, HessianKind kind,
                    ChainBlocks& out) const override;
  void residuals(const AmbientPath& path, Points& r, Points* jacobians) const override;

 private:
  virtual SquaredCosts derive(const AmbientPath& path, bool with_hessians) const = 0;

  CostTraits traits_;
  int dim_;
};

}  // namespace leastcost
