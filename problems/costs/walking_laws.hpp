// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <leastcost/framework/numbers/dual.hpp>

/// \file
/// What it takes to walk a unit of map distance at a slope s = rise / map distance, as far as it is walked straight.

namespace leastcost {

/// Tobler 1993: exp(3.5 |s + 0.05|) of the time that the fastest slope takes. The kink at z = s + 0.05 = 0 is rounded
/// over |z| < delta: delta (3/8 + 3 t^2 / 4 - t^4 / 8), t = z / delta, in place of |z|, is convex, has two continuous
/// derivatives, and is never below it.
struct ToblerPace {
  static constexpr double kSteepness = 3.5, kFastest = -0.05;
  static constexpr double kSteepest = 1;  ///< beyond the critical slopes, 2/7 and -2/7
  double delta;

  template <class S>
  S operator()(const S& s) const {
    using std::exp;
    const S z = s - kFastest;
    if (innermost(z) >= delta) return exp(kSteepness * z);
    if (innermost(z) <= -delta) return exp(-kSteepness * z);
    const S t = z / delta, t2 = t * t;
    return exp(kSteepness * delta * (0.375 + 0.75 * t2 - 0.125 * t2 * t2));
  }

  /// delta times the derivative of the pace in delta. The pace is convex in s and delta together, so that on a plane
  /// the least cost for delta = 0 is below the present one by at most this, along the path (docs/numerics.md Sec. 7.2).
  double rounding(double s) const {
    const double t = (s - kFastest) / delta;
    if (!(std::abs(t) < 1)) return 0;
    const double u = 1 - t * t;
    return (*this)(s)*kSteepness * delta * 0.375 * u * u;
  }
};

/// Minetti et al. 2002: the metabolic energy of walking, J per kg and metre of path, at gradients between -0.45 and
/// 0.45, where it was measured.
struct MinettiPace {
  static constexpr double kSteepest = 0.45;

  template <class S>
  S operator()(const S& s) const {
    using std::sqrt;
    const S per_metre_of_path = ((((280.5 * s - 58.7) * s - 76.8) * s + 51.9) * s + 19.6) * s + 2.5;
    return per_metre_of_path * sqrt(1.0 + s * s);
  }
  static double rounding(double) { return 0; }
};

/// One side of the convex hull of a pace, of the steepness x = s or x = -s, at least 0. Beyond the critical slope it is
/// cheaper to gain height in switchbacks of that slope: the hull goes on along the tangent through the origin, `rise`
/// per unit of x, and the cost of a climb no longer depends on the way. To have two continuous derivatives and one
/// cheapest way, the pace goes over into a tangent from `from` to `to`, by the cubic whose second derivative falls from
/// that of the pace to 0; the tangent leaves `base` at slope 0. It is never above the hull.
struct HullSide {
  double from = 0, to = 0;
  double value = 0, slope = 0, bend = 0;  ///< of the pace, in x, at `from`
  double base = 0, rise = 0;

  template <class S>
  S going_over(const S& x) const {
    const S t = x - from;
    const double width = to - from;
    return value + t * (slope + t * bend * (0.5 - t / (6 * width)));
  }
};

/// The side that goes over from `from` to `from + width`.
template <class Pace>
HullSide hull_side_from(const Pace& pace, double sign, double from, double width) {
  using Slope = Dual<Dual<double, 1>, 1>;
  Slope x(sign * from);
  x.value.d[0] = sign;
  x.d[0].value = sign;
  const Slope f = pace(x);
  HullSide side{from, from + width, f.value.value, f.d[0].value, f.d[0].d[0]};
  side.rise = side.slope + side.bend * width / 2;
  side.base = side.value + side.slope * width + side.bend * width * width / 3 - side.to * side.rise;
  return side;
}

/// The side whose tangent leaves `tilt` of the pace at slope 0; with no width and no tilt the hull itself. For a pace
/// that is convex up to there.
template <class Pace>
HullSide hull_side(const Pace& pace, double sign, double width, double tilt) {
  double gentle = 0, steep = Pace::kSteepest;
  for (;;) {
    const double middle = (gentle + steep) / 2;
    if (middle <= gentle || middle >= steep) return hull_side_from(pace, sign, gentle, width);
    const HullSide side = hull_side_from(pace, sign, middle, width);
    (side.base > tilt * side.value ? gentle : steep) = middle;
  }
}

}  // namespace leastcost
