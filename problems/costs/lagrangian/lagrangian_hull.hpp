// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <optional>
#include <span>

#include <leastcost/framework/cost/segment_derivatives.hpp>
#include <leastcost/framework/numbers/dual.hpp>
#include "problems/formula/formula.hpp"

namespace leastcost {

/// Two directions, as angles in the plane, between which F(x, .) lies above its convex hull: what costs least there is
/// a zigzag of moves in the two, and the hull is linear between them. from < to < from + pi.
struct LagrangianGap {
  double from, to;
};

/// The gap of F(x, .) that the direction `angle` lies in, if any: a hull of 128 directions, its long edges refined by
/// Newton's method to common tangents of the curve F(x, v) = 1. Gaps of less than three hundredths of a turn may be
/// missed. x: two numbers.
std::optional<LagrangianGap> gap_around(const Formula& f, const Point<double, 2>& x, double angle);

/// F and F_t of F(x, (cos t, sin t)).
template <class S>
struct AngularSlope {
  S value, slope;
};
template <class S>
AngularSlope<S> angular_slope(const Formula& f, const Point<S, 2>& x, const S& angle) {
  using std::cos, std::sin;
  using T = Dual<S, 1>;
  T t(angle, {S(1.0)});
  const std::array<T, 4> xv = {T(x[0], {}), T(x[1], {}), T(cos(t)), T(sin(t))};
  const T value = f(std::span<const T>(xv));
  return {value.value, value.d[0]};
}

/// The difference of F_v in the two directions, which vanishes where they have a tangent in common.
template <class S>
Point<S, 2> tangent_defect(const Formula& f, const Point<S, 2>& x, const S& from, const S& to) {
  using std::cos, std::sin;
  const AngularSlope<S> a = angular_slope<S>(f, x, from), b = angular_slope<S>(f, x, to);
  return {a.value * cos(from) - a.slope * sin(from) - b.value * cos(to) + b.slope * sin(to),
          a.value * sin(from) + a.slope * cos(from) - b.value * sin(to) - b.slope * cos(to)};
}

/// d(tangent_defect) / d(from, to) at a place.
Eigen::Matrix2d tangent_jacobian(const Formula& f, const Point<double, 2>& x, const LagrangianGap& gap);

/// The hull of F(x, .) at a v in the gap, with as many derivatives as S has, up to two: the least F(x, v1) + F(x, v2)
/// for v1 + v2 = v. The directions of v1 and v2 follow x to first order, by a step of Newton's method in S; the hull,
/// being a minimum in them, is then right to third order.
template <class S>
S hull_in_gap(const Formula& f, const Point<S, 2>& x, const Point<S, 2>& v, const LagrangianGap& gap) {
  using std::cos, std::sin;
  Point<double, 2> place;
  for (int i = 0; i < 2; ++i) place[i] = innermost(x[i]);
  const Eigen::Matrix2d inverse = tangent_jacobian(f, place, gap).inverse();
  const Point<S, 2> defect = tangent_defect<S>(f, x, S(gap.from), S(gap.to));
  S from(gap.from), to(gap.to);
  if (inverse.allFinite()) {
    from -= S(inverse(0, 0)) * defect[0] + S(inverse(0, 1)) * defect[1];
    to -= S(inverse(1, 0)) * defect[0] + S(inverse(1, 1)) * defect[1];
  }
  const S ax = cos(from), ay = sin(from), bx = cos(to), by = sin(to), across = ax * by - ay * bx;
  const std::array<S, 4> in_from = {x[0], x[1], ax, ay}, in_to = {x[0], x[1], bx, by};
  return ((v[0] * by - v[1] * bx) * f(std::span<const S>(in_from)) +
          (ax * v[1] - ay * v[0]) * f(std::span<const S>(in_to))) /
         across;
}

}  // namespace leastcost
