// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>

namespace leastcost {

/// For graph searches: the cost of moves in R^3, multiplied near routes that were found before, so that the next route
/// takes another way. By `factor` on a route, by less beside it, by 1 from the distance `reach` on. Derivatives and the
/// line element are those of the cost itself, and so are its abilities, but for those that say what its values are.
class AwayFromRoutes final : public SegmentCost {
 public:
  /// routes: 3 x m polylines. reach: length units, > 0.
  AwayFromRoutes(std::shared_ptr<const SegmentCost> cost, std::vector<Points> routes, double factor, double reach);

  const SegmentCost* decorated(const std::type_info& ability) const override {
    const bool of_values = ability == typeid(HasConstantMetric) || ability == typeid(FollowsDomain);
    return of_values ? nullptr : cost_.get();
  }
  int dim() const override { return cost_->dim(); }
  const CostTraits& traits() const override { return traits_; }
  void squared_costs(const AmbientPath& path, std::span<double> q) const override;
  double energy_and_gradient(const AmbientPath& path, const Kernel& kernel, double s0,
                             Eigen::Ref<Points> gradient) const override;
  void chain_blocks(const AmbientPath& path, const Kernel& kernel, double s0, HessianKind kind,
                    ChainBlocks& out) const override;
  void residuals(const AmbientPath& path, Points& r, Points* jacobians) const override;
  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const override;

 private:
  double distance(const Eigen::Vector3d& x) const;

  std::shared_ptr<const SegmentCost> cost_;
  CostTraits traits_;
  std::vector<Points> routes_;
  double factor_, reach_;
};

}  // namespace leastcost
