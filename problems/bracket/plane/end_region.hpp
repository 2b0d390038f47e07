// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "problems/bracket/plane/dual_cone.hpp"
#include "problems/bracket/plane/sampled_cone.hpp"
#include "problems/bracket/plane/spline_check.hpp"

namespace leastcost::bracket {

/// The surroundings of an end e of the path: a square S of (2 k + 1)^2 cells, with a bound of the cost from e that is
/// proved for all paths in the box, whether they stay in S or not:
///
///     cost(e, x) >= v(x) = n0 r + r (g.d) / 2 - c r^3 for x in S, with d = x - e, r = |d|.
///
/// |grad v| <= n within a larger square S2, as n >= n0 + g.d - K r^2 / 2 there and c >= K / 6 + |g|^2 / (24 A) +
/// 3 c^2 r^2 / (2 A) with A = n0 - |g| r > 0, or g = 0, c = 0 and n >= n0 there; and whoever leaves S2 has paid more
/// than v anywhere in S. Where the cost depends on the direction v is that of a DualCone or a SampledCone.
struct EndRegion {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  int ci = 0, cj = 0, k = 0;
  bool valid = false;
  double n0 = 0, gx = 0, gy = 0, c = 0;
  bool reversed = false;  ///< the cost to the end
  std::optional<DualCone> dual = {};
  std::optional<SampledCone> sampled = {};

  bool holds(int i, int j) const { return std::abs(i - ci) <= k && std::abs(j - cj) <= k; }
  bool touches(const EndRegion& o) const {
    return std::abs(ci - o.ci) <= k + o.k + 1 && std::abs(cj - o.cj) <= k + o.k + 1;
  }
  template <class S>
  S cone(const S& dx, const S& dy) const {
    using std::sqrt;
    const S squared = dx * dx + dy * dy, r = sqrt(squared);
    return r * (S(n0) + S(0.5) * (S(gx) * dx + S(gy) * dy) - S(c) * squared);
  }
};

/// The largest such region with at most `k` rings of cells, at least two; not valid where there is none.
EndRegion end_region(const CostDensity& density, const CellGrid& grid, const Eigen::Vector2d& place, int k);
EndRegion end_region(const CostDual& dual, const CellGrid& grid, const Eigen::Vector2d& place, int k, bool reversed);
EndRegion end_region(const CoordinateCost& cost, const CellGrid& grid, const Eigen::Vector2d& place, int k,
                     bool reversed);

/// A lower bound of v + sign u / ratio, v at most that of the cone, over the rim of the region, where a cell outside it
/// that is `searched` touches it; of a SampledCone the least of some places on it. Infinite where none does: no path
/// leaves.
double rim_minimum(const CellGrid& grid, const EndRegion& region, const std::vector<unsigned char>& searched,
                   const std::vector<double>& u, double sign, double ratio);

}  // namespace leastcost::bracket
