// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace leastcost {

/// A wall beside a point, taken to be straight: a step clears it where slope . step >= missing.
struct WallToClear {
  Eigen::VectorXd slope = {};
  double missing = 0;    ///< below 0: by so much the step may approach it
  bool exactly = false;  ///< the step has to end on it
};

/// The least step that clears all of some walls at once, by an active set (Nocedal and Wright 2006, Ch. 16.5). Walls at
/// a sharp angle, or face to face, pass a point to and fro for long where it is pushed out of one after the other.
/// Nothing where no set of walls is found that holds it.
std::optional<Eigen::VectorXd> least_push(const std::vector<WallToClear>& walls);

}  // namespace leastcost
