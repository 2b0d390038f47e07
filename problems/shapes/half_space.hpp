// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>

namespace leastcost {

/// All points behind a plane (in the plane: a line): normal . x <= offset * |normal|. Nothing bounds it; its box is
/// infinite.
struct HalfSpaceOptions {
  Eigen::VectorXd normal = {};  ///< of any length but 0, out of the obstacle
  double offset = 0;            ///< of the plane from the origin, along the normal, length units
  void fields(FieldVisitor& visit);
};

/// `name`: for messages; empty: by its normal. Throws OptionError for a normal that is no direction.
std::shared_ptr<const Obstacle> make_half_space(const HalfSpaceOptions& options, const std::string& name = {});

}  // namespace leastcost
