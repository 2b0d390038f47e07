// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// Ability of a domain: its coordinates stay in a box, sides of which may be infinite.
class HasBox {
 public:
  virtual ~HasBox() = default;
  virtual const Eigen::VectorXd& box_lower() const = 0;  ///< least coordinates; -inf: none
  virtual const Eigen::VectorXd& box_upper() const = 0;  ///< greatest coordinates; inf: none
};

}  // namespace leastcost
