// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdlib>
#include <vector>

#include <leastcost/problems/bracket/cost_density.hpp>
#include "problems/bracket/cells/dual_cone.hpp"
#include "problems/bracket/cells/nodes.hpp"
#include "problems/bracket/cells/sampled_cone.hpp"

namespace leastcost::bracket {

/// v = n0 r + r (g.d) / 2 - c r^3, with d a place less the end, r = |d|.
struct DensityCone {
  double n0 = 0, gx = 0, gy = 0, c = 0;

  template <class S>
  S value(const S& dx, const S& dy) const {
    using std::sqrt;
    const S squared = dx * dx + dy * dy, r = sqrt(squared);
    return r * (S(n0) + S(0.5) * (S(gx) * dx + S(gy) * dy) - S(c) * squared);
  }
};

/// The surroundings of an end e of the path: a square S of (2 k + 1)^2 cells, with a bound of the cost from e that is
/// proved for all paths in the box, whether they stay in S or not. That of a density:
///
///     cost(e, x) >= v(x) for x in S, the v of a DensityCone.
///
/// |grad v| <= n within a larger square S2, as n >= n0 + g.d - K r^2 / 2 there and c >= K / 6 + |g|^2 / (24 A) +
/// 3 c^2 r^2 / (2 A) with A = n0 - |g| r > 0, or g = 0, c = 0 and n >= n0 there; and whoever leaves S2 has paid more
/// than v anywhere in S. Where the cost depends on the direction v is that of a DualCone or a SampledCone.
template <class Cone>
struct EndSquare {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  Place<2> middle = {0, 0};
  int k = 0;
  bool valid = false;
  bool reversed = false;  ///< the cost to the end
  Cone cone = {};

  bool holds(const Place<2>& p) const { return std::abs(p[0] - middle[0]) <= k && std::abs(p[1] - middle[1]) <= k; }
  bool touches(const EndSquare& o) const {
    return std::abs(middle[0] - o.middle[0]) <= k + o.k + 1 && std::abs(middle[1] - o.middle[1]) <= k + o.k + 1;
  }
};

/// The largest such square with at most `k` rings of cells, at least two where the cost depends on the direction; not
/// valid where there is none.
EndSquare<DensityCone> end_square(const CostDensity& density, const Grid<2>& grid, const Eigen::Vector2d& place, int k,
                                  bool reversed = false);
EndSquare<DualCone> end_square(const CostDual& dual, const Grid<2>& grid, const Eigen::Vector2d& place, int k,
                               bool reversed);
EndSquare<SampledCone> end_square(const CoordinateCost& cost, const Grid<2>& grid, const Eigen::Vector2d& place, int k,
                                  bool reversed);

/// A lower bound of v + sign u / ratio, v at most that of the cone, over the rim of the square, where a cell outside it
/// that is `searched` touches it; of a SampledCone the least of some places on it. Infinite where none does: no path
/// leaves.
template <class Cone>
double rim_minimum(const Grid<2>& grid, const AllNodes& nodes, const EndSquare<Cone>& square,
                   const std::vector<unsigned char>& searched, const std::vector<double>& u, double sign, double ratio);

}  // namespace leastcost::bracket
