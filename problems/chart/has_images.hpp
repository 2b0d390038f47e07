// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace leastcost {

/// Ability: several points of the domain stand for the same thing (q and -q are one rotation).
class HasImages {
 public:
  virtual ~HasImages() = default;
  /// Of all points that stand for the same as x, the one nearest to `reference`.
  virtual Eigen::VectorXd nearest_image(const Eigen::VectorXd& x, const Eigen::VectorXd& reference) const = 0;
};

}  // namespace leastcost
