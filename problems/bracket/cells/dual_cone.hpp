// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include <leastcost/problems/bracket/cost_dual.hpp>

namespace leastcost::bracket {

/// A bound of the cost from an end e, proved for all paths in a box, for costs that depend on the direction:
///
///     cost(e, e + d) >= min(factor m(d), most),   m(d) = F(d) of the dual norm at + d / 2 . (dx, dy).
///
/// m is exact to first order in the variation of the cost; `factor` is 1 less what the second order and the enclosures
/// add to H(x, grad m) around the end, as far as m <= most / factor.
struct DualCone {
  DualNorm<double> at, dx, dy;  ///< entries at the end, and their slopes
  double factor = 1, most = 0;

  /// The norm in the middle of the move z + z.
  template <class S>
  DualNorm<S> norm(const S& zx, const S& zy) const {
    const auto entry = [&](double f, double fx, double fy) { return S(f) + S(fx) * zx + S(fy) * zy; };
    return {entry(at.xx, dx.xx, dy.xx), entry(at.xy, dx.xy, dy.xy), entry(at.yy, dx.yy, dy.yy),
            entry(at.wx, dx.wx, dy.wx), entry(at.wy, dx.wy, dy.wy)};
  }
  /// factor m(d).
  template <class S>
  S value(const S& x, const S& y) const {
    return S(factor) * norm<S>(S(0.5) * x, S(0.5) * y).cost(x, y);
  }
};

/// For places up to `reach` away from the end, and so far as they cost no more. `reversed`: of the cost to the end, for
/// places seen from it. Nothing where there is no such cone: too much wind, too little known.
std::optional<DualCone> dual_cone(const CostDual& dual, const Eigen::AlignedBox2d& box, const Eigen::Vector2d& end,
                                  double reach, bool reversed);

}  // namespace leastcost::bracket
