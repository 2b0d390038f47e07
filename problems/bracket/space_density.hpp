// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <string_view>

#include <leastcost/eigen_alignment.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/numbers/interval.hpp>

namespace leastcost {

/// The six entries of a symmetric 3 x 3 matrix, in the order in which they are stored: row and column.
inline constexpr std::array<std::array<int, 2>, 6> kSymmetricEntries = {
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

/// What is known of a cost density n over a cell in space with the centre c, with d = x - c. Both of
///
///     n(x) = value + slope.d + d'H d / 2 for numbers of these intervals, H that over the whole cell;
///     |n(x) - (value + slope.d + d'H d / 2)| <= cubic, H that at the centre.
///
/// Rounding is included. Where nothing is known they are not finite.
struct SpaceDensityEnclosure {
  Interval value;                          ///< at the centre
  std::array<Interval, 3> slope;           ///< at the centre
  std::array<Interval, 6> bend;            ///< H over the whole cell (kSymmetricEntries)
  std::array<Interval, 6> bend_at_center;  ///< H at the centre
  double cubic = 0;                        ///< infinite: there are no third derivatives
  static SpaceDensityEnclosure unknown();  ///< of a cost of which nothing is known here
  bool is_finite() const;                  ///< the first of both
};

/// A cost in space that is the same in all directions: a path costs the integral of n(x) along its length. As
/// CostDensity is in the plane.
class SpaceDensity {
 public:
  static constexpr std::string_view kAbility = "cost density in cells of space";
  virtual ~SpaceDensity() = default;
  /// n(x), as computed; not finite outside its domain.
  virtual double density(const Eigen::Vector3d& x) const = 0;
  /// Proved bounds over a cell, sides of which may have no length.
  virtual SpaceDensityEnclosure enclose_density(const Eigen::AlignedBox3d& cell) const = 0;
};

/// The density of a cost in space: itself where it has that ability, or sqrt(G_11) where it has a metric G by formula
/// (EnclosesMetric). Bounds are of the roots of G_11, G_22 and G_33 alike, so that they hold whatever G is, and are
/// narrow where G is n^2 times the unit matrix; where an entry beside the diagonal is not visibly zero nothing is
/// known. Null for other costs.
std::shared_ptr<const SpaceDensity> space_density_of(const std::shared_ptr<const SegmentCost>& cost);

/// The cost of the straight move from a to b is at most this: by the middle and a bound of the second derivative along
/// the move. Infinite where nothing is known.
double move_cost_above(const SpaceDensity& density, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// The same of all moves of a polyline, 3 x m: a proved upper bound of the least cost between its ends.
double polyline_cost_above(const SpaceDensity& density, const Eigen::Ref<const Eigen::Matrix3Xd>& x);

}  // namespace leastcost
