// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string_view>

#include <leastcost/eigen_alignment.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/numbers/interval.hpp>

namespace leastcost {

/// What is known of a cost density n over a cell with the centre c, with d = x - c: n(x) is within `slack` of
/// value + (dx, dy).d + d'H d / 2 for numbers of these intervals, H = (xx xy; xy yy). Rounding is included. Where
/// nothing is known they are not finite.
struct DensityEnclosure {
  Interval value, dx, dy;             ///< at the centre
  Interval xx, xy, yy;                ///< over the whole cell
  double slack = 0;                   ///< what kinks add; 0 where n is twice differentiable
  static DensityEnclosure unknown();  ///< of a cost of which nothing is known here
  bool is_finite() const;             ///< whether anything is known
};

/// A cost in the plane that is the same in all directions: a path costs the integral of n(x) along its length. n is the
/// refractive index of optics, the slowness of seismics. Ability of costs; those whose metric is n^2 times the unit
/// matrix by formula need not have it (density_of).
class CostDensity {
 public:
  static constexpr std::string_view kAbility = "cost density in cells";
  virtual ~CostDensity() = default;
  /// n(x), as computed; not finite outside its domain.
  virtual double density(const Eigen::Vector2d& x) const = 0;
  /// Proved bounds over a cell, sides of which may have no length.
  virtual DensityEnclosure enclose_density(const Eigen::AlignedBox2d& cell) const = 0;
};

/// The density of a cost: itself where it has that ability, or sqrt(G_11) where it has a metric G by formula
/// (EnclosesMetric) in the plane. Bounds are of sqrt(G_11) and of sqrt(G_22) alike, so that they hold whatever G is,
/// and are narrow where G is n^2 times the unit matrix; where G_12 is not visibly zero nothing is known. Null for other
/// costs.
std::shared_ptr<const CostDensity> density_of(const std::shared_ptr<const SegmentCost>& cost);

/// The cost of the straight move from a to b is at most this: by the middle and a bound of the second derivative along
/// the move. Infinite where nothing is known.
double move_cost_above(const CostDensity& density, const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/// The same of all moves of a polyline, 2 x m: a proved upper bound of the least cost between its ends.
double polyline_cost_above(const CostDensity& density, const Eigen::Ref<const Eigen::Matrix2Xd>& x);

}  // namespace leastcost
