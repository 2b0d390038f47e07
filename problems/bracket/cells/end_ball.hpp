// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <leastcost/problems/bracket/space_density.hpp>
#include "problems/bracket/cells/nodes.hpp"

namespace leastcost::bracket {

/// The surroundings of an end e of the path in space: the set S of the cells whose middles are at most k + 1/2 cells
/// from that of the end's cell, with a bound of the cost from e that is proved for all paths in the box, whether they
/// stay in S or not:
///
///     cost(e, x) >= min(v(x), most), v(x) = n0 r + r (g.d) / 2 - c r^3, for x in S, with d = x - e, r = |d|.
///
/// The conditions are those of EndRegion, with a ball around e in place of S2: of grad v only its part along d and its
/// length across count, in any number of dimensions. Whoever leaves that ball has paid `most`.
struct EndBall {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Place<3> middle = {0, 0, 0};
  int k = 0;
  bool valid = false;
  static constexpr bool reversed = false;  ///< there and back cost the same
  double n0 = 0, c = 0, most = 0;
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();  ///< g

  bool holds(const Place<3>& p) const {
    const int x = p[0] - middle[0], y = p[1] - middle[1], z = p[2] - middle[2];
    return x * x + y * y + z * z <= k * k + k;
  }
  bool touches(const EndBall& o) const {
    const int apart = k + o.k + 1;
    return std::abs(middle[0] - o.middle[0]) <= apart && std::abs(middle[1] - o.middle[1]) <= apart &&
           std::abs(middle[2] - o.middle[2]) <= apart;
  }
  template <class S>
  S cone(const std::array<S, 3>& d) const {
    using std::sqrt;
    const S squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2], r = sqrt(squared);
    return r * (S(n0) + S(0.5) * (S(slope[0]) * d[0] + S(slope[1]) * d[1] + S(slope[2]) * d[2]) - S(c) * squared);
  }
};

/// The largest such set with at most this k, at least 1, in which `most` cuts off little, or the smallest one; not
/// valid where there is none.
EndBall end_ball(const SpaceDensity& density, const Grid<3>& grid, const Eigen::Vector3d& place, int k);

/// A lower bound of min(v, most) + sign u / ratio over the rim of S, where a cell outside it that is `searched` touches
/// it. Infinite where none does: no path leaves.
double rim_minimum(const Grid<3>& grid, const NodeSet& nodes, const EndBall& ball,
                   const std::vector<unsigned char>& searched, const std::vector<double>& u, double sign, double ratio);

}  // namespace leastcost::bracket
