// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/initializers/away_from_routes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace leastcost {

AwayFromRoutes::AwayFromRoutes(std::shared_ptr<const SegmentCost> cost, std::vector<Points> routes, double factor,
                               double reach)
    : cost_(std::move(cost)), traits_(cost_->traits()), routes_(std::move(routes)), factor_(factor), reach_(reach) {
  traits_.below_curves =
      false;  // a straight move through the neighbourhood of a route may cost more than one around it
  traits_.additive = false;
}

double AwayFromRoutes::distance(const Eigen::Vector3d& x) const {
  double least2 = std::numeric_limits<double>::infinity();
  for (const Points& route : routes_)
    for (Index i = 0; i + 1 < route.cols(); ++i) {
      const Eigen::Vector3d a = route.col(i), d = Eigen::Vector3d(route.col(i + 1)) - a, to = x - a;
      const double t = d.squaredNorm() > 0 ? std::clamp(to.dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
      least2 = std::min(least2, (to - t * d).squaredNorm());
    }
  return std::sqrt(least2);
}

void AwayFromRoutes::squared_costs(const AmbientPath& path, std::span<double> q) const {
  cost_->squared_costs(path, q);
  for (Index i = 0; i < path.segment_count(); ++i) {
    const Eigen::Vector3d middle = (path.x.col(i) + path.x.col(i + 1)) / 2;
    const double near = std::max(0.0, 1 - distance(middle) / reach_);
    q[static_cast<std::size_t>(i)] *= std::pow(1 + (factor_ - 1) * near, 2);
  }
}

double AwayFromRoutes::energy_and_gradient(const AmbientPath& path, const Kernel& kernel, double s0,
                                           Eigen::Ref<Points> gradient) const {
  return cost_->energy_and_gradient(path, kernel, s0, gradient);
}

void AwayFromRoutes::chain_blocks(const AmbientPath& path, const Kernel& kernel, double s0, HessianKind kind,
                                  ChainBlocks& out) const {
  cost_->chain_blocks(path, kernel, s0, kind, out);
}

void AwayFromRoutes::residuals(const AmbientPath& path, Points& r, Points* jacobians) const {
  cost_->residuals(path, r, jacobians);
}

double AwayFromRoutes::line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
  return cost_->line_element(x, v);
}

}  // namespace leastcost
