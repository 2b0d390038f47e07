// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "framework/trajectory/blended_path.hpp"

namespace leastcost {

/// How fast a path is followed: between two stations of it, s' s'' is constant.
struct SpeedProfile {
  Eigen::VectorXd s;         ///< stations along the path, from 0 to its length
  Eigen::VectorXd square;    ///< of ds/dt at each, 0 at both ends
  Eigen::VectorXd time;      ///< when it is reached
  std::vector<Index> piece;  ///< of the path, of each interval between two stations

  double duration() const { return time[time.size() - 1]; }
};

/// The quickest way along a path from rest to rest with |q_j'| <= velocity_j and |q_j''| <= acceleration_j (derivatives
/// by time, one bound > 0 for each coordinate). Backward over the stations the fastest speeds from which the limits can
/// still be kept, then forward at the greatest acceleration that stays below them (Pham and Pham, "A new approach to
/// time-optimal path parameterization based on reachability analysis", IEEE T-RO 34, 2018). On a piece of the path q'
/// is linear in s, q'' constant, and between stations so is (ds/dt)^2: the acceleration of a coordinate is linear
/// there, and within its limit because it is at both stations. The velocity is bounded by the greatest |q_j'| and ds/dt
/// of the interval. So the limits hold everywhere, not at the stations alone. `stations`: at least so many.
SpeedProfile time_optimal(const BlendedPath& path, const Eigen::VectorXd& velocity, const Eigen::VectorXd& acceleration,
                          int stations = 2000);

}  // namespace leastcost
