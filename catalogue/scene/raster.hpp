// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace leastcost {

/// A function of the plane, sampled on a regular grid over a rectangle, the corners included.
struct Raster {
  int columns = 0, rows = 0;
  Eigen::Vector2d lower = Eigen::Vector2d::Zero(), upper = Eigen::Vector2d::Zero();
  std::vector<double> values;  ///< x runs fastest, from below; +infinity where the cost is
};

}  // namespace leastcost
