// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include <leastcost/problems/bracket/coordinate_cost.hpp>

namespace leastcost::bracket {

/// A bound of the cost from an end e, or to it, as a DualCone's, of a cost that is known by its values:
///
///     cost(e, e + d) >= min(factor m(d), most),   m(d) = F(e + d / 2, d).
///
/// `factor` and `most` are of H(x, grad m) and m at places around the end: sampled.
struct SampledCone {
  const CoordinateCost* cost = nullptr;
  Eigen::AlignedBox2d box = {};
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  bool reversed = false;
  double factor = 1, most = 0;

  double middle_cost(const Eigen::Vector2d& d) const;
  double value(const Eigen::Vector2d& d) const { return factor * middle_cost(d); }
};

/// For places up to `reach` away from the end. Nothing where there are no moves in some directions, or m is no
/// distance.
std::optional<SampledCone> sampled_cone(const CoordinateCost& cost, const Eigen::AlignedBox2d& box,
                                        const Eigen::Vector2d& end, double reach, bool reversed);

}  // namespace leastcost::bracket
