// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>

#include <leastcost/eigen_alignment.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/numbers/interval_jet.hpp>

namespace leastcost {

/// A cost at a place of the plane by its dual norm, with A = (xx xy; xy yy) positive definite:
///
///     H(p) = sqrt(p'Ap) + w.p,     the move d costs F(d) = max { p.d : H(p) <= 1 }.
///
/// Of a metric G: A = G^-1, w = 0. Of the time of a vehicle of speed V in a wind w: A = V^2 times the unit matrix.
/// Where the wind is the faster, F is infinite against it, and H is what it is. S: double, or what is based on
/// intervals.
template <class S>
struct DualNorm {
  S xx, xy, yy, wx, wy;  ///< the matrix A and the vector w

  /// Of the moves back.
  DualNorm reversed() const { return {xx, xy, yy, -wx, -wy}; }
  /// Squared norm of a slope.
  S squared(const S& px, const S& py) const { return xx * px * px + S(2.0) * xy * px * py + yy * py * py; }
  S operator()(const S& px, const S& py) const {
    using std::sqrt;
    return sqrt(squared(px, py)) + wx * px + wy * py;
  }
  /// F(d); infinite where there is no such move, and not finite where intervals do not decide it.
  S cost(const S& dx, const S& dy) const {
    using std::sqrt;
    const S det = xx * yy - xy * xy;
    const S bx = (yy * dx - xy * dy) / det, by = (xx * dy - xy * dx) / det;  // B d, B = A^-1
    const S along = wx * bx + wy * by, squared = dx * bx + dy * by;
    const S room = S(1.0) - (yy * wx * wx - S(2.0) * xy * wx * wy + xx * wy * wy) / det;
    const S root = sqrt(along * along + room * squared);
    if (middle(along) > 0) return squared / (along + root);
    return lowest(room) > 0 ? S((root - along) / room) : S(std::numeric_limits<double>::infinity());
  }

 private:
  static double middle(double x) { return x; }
  template <class T>
  static double middle(const T& x) {
    return range_of(x).middle();
  }
  static double lowest(double x) { return x; }
  template <class T>
  static double lowest(const T& x) {
    return range_of(x).lo;
  }
};

/// Ability of a cost in the plane, whose line element is the F of a dual norm at each place.
class CostDual {
 public:
  static constexpr std::string_view kAbility = "dual norm in cells";
  using Jet = IntervalJet<2>;
  virtual ~CostDual() = default;
  /// As computed; not finite outside its domain.
  virtual DualNorm<double> dual(const Eigen::Vector2d& x) const = 0;
  /// Proved bounds at places that are functions of two variables; not finite where nothing is known, or where A may not
  /// be positive definite.
  virtual DualNorm<Jet> enclose_dual(const std::array<Jet, 2>& x) const = 0;

  /// Encloses the dual norm over a cell.
  DualNorm<Jet> enclose_cell(const Eigen::AlignedBox2d& cell) const {
    return enclose_dual(
        {Jet::variable({cell.min()[0], cell.max()[0]}, 0), Jet::variable({cell.min()[1], cell.max()[1]}, 1)});
  }
};

/// The dual norm of a cost: itself where it has that ability, or the inverse of a metric by formula (EnclosesMetric).
/// Null for other costs.
std::shared_ptr<const CostDual> dual_of(const std::shared_ptr<const SegmentCost>& cost);

/// As of a CostDensity: proved upper bounds of what straight moves cost, infinite where nothing is known.
double move_cost_above(const CostDual& dual, const Eigen::Vector2d& a, const Eigen::Vector2d& b);
double polyline_cost_above(const CostDual& dual, const Eigen::Ref<const Eigen::Matrix2Xd>& x);

}  // namespace leastcost
