// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "framework/numbers/sin_cos.hpp"

/// Named surfaces as maps (u, v) -> R^3. Where a surface is round, u is the angle about the z axis.
namespace leastcost::chart {

template <class S>
using Vector3 = Eigen::Matrix<S, 3, 1>;

struct Plane {
  template <class S>
  Vector3<S> operator()(const S& u, const S& v) const {
    return {u, v, S(0.0)};
  }
};

/// u: longitude; v: latitude on the unit sphere (reduced latitude). Axes along x, y, z.
struct Ellipsoid {
  double a = 1, b = 1, c = 1;
  template <class S>
  Vector3<S> operator()(const S& u, const S& v) const {
    const auto [sin_u, cos_u] = sin_cos(u);
    const auto [up, r] = sin_cos(v);
    return {a * r * cos_u, b * r * sin_u, c * up};
  }
};

/// An ellipsoid of revolution with the equatorial radius a and the flattening f. u: geodetic latitude, v: longitude,
/// degrees. With e^2 = f (2 - f) and the radius of curvature N = a / sqrt(1 - e^2 sin^2 u) in the prime vertical.
struct Geodetic {
  double a = 1, f = 0;
  template <class S>
  Vector3<S> operator()(const S& u, const S& v) const {
    using std::sqrt;
    constexpr double kDegree = std::numbers::pi / 180;
    const double e2 = f * (2 - f);
    const auto [up, outward] = sin_cos(S(kDegree * u));
    const auto [east, north] = sin_cos(S(kDegree * v));
    const S n = a / sqrt(1.0 - e2 * up * up), r = n * outward;
    return {r * north, r * east, (1 - e2) * n * up};
  }
};

/// v: angle around the tube.
struct Torus {
  double major = 2, minor = 1;
  template <class S>
  Vector3<S> operator()(const S& u, const S& v) const {
    const auto [sin_u, cos_u] = sin_cos(u);
    const auto [sin_v, cos_v] = sin_cos(v);
    const S r = major + minor * cos_v;
    return {r * cos_u, r * sin_u, minor * sin_v};
  }
};

/// v: height.
struct Cylinder {
  double radius = 1;
  template <class S>
  Vector3<S> operator()(const S& u, const S& v) const {
    const auto [sin_u, cos_u] = sin_cos(u);
    return {radius * cos_u, radius * sin_u, v};
  }
};

/// v: distance from the apex along a ruling; half_angle: between axis and ruling, radians.
struct Cone {
  double half_angle = 0.5;
  template <class S>
  Vector3<S> operator()(const S& u, const S& v) const {
    const auto [sin_u, cos_u] = sin_cos(u);
    const S r = std::sin(half_angle) * v;
    return {r * cos_u, r * sin_u, std::cos(half_angle) * v};
  }
};

/// v: height; waist: least distance from the axis.
struct Catenoid {
  double waist = 1;
  template <class S>
  Vector3<S> operator()(const S& u, const S& v) const {
    using std::cosh;
    const auto [sin_u, cos_u] = sin_cos(u);
    const S r = waist * cosh(v / waist);
    return {r * cos_u, r * sin_u, v};
  }
};

/// z = curvature r^2 / 2; v: distance r from the axis.
struct Paraboloid {
  double curvature = 1;
  template <class S>
  Vector3<S> operator()(const S& u, const S& v) const {
    const auto [sin_u, cos_u] = sin_cos(u);
    return {v * cos_u, v * sin_u, 0.5 * curvature * v * v};
  }
};

/// One sheet, (x^2 + y^2) / waist^2 - z^2 / height^2 = 1; v: z.
struct Hyperboloid {
  double waist = 1, height = 1;
  template <class S>
  Vector3<S> operator()(const S& u, const S& v) const {
    using std::sqrt;
    const auto [sin_u, cos_u] = sin_cos(u);
    const S t = v / height, r = waist * sqrt(1.0 + t * t);
    return {r * cos_u, r * sin_u, v};
  }
};

/// VFCS Eq. (17) with the misprint in y mended. Closed for u in [0, 2 pi]; crossing that seam turns v over.
struct KleinBottle {
  double a = 2, b = 1;
  template <class S>
  Vector3<S> operator()(const S& u, const S& v) const {
    using std::sin;
    const auto [s, c] = sin_cos(S(0.5 * u));
    const auto [sin_u, cos_u] = sin_cos(u);
    const S once = sin(v), twice = sin(2.0 * v);
    const S r = a + b * (c * once - s * twice);
    return {r * cos_u, r * sin_u, b * (s * once + c * twice)};
  }
};

/// VFCS Eq. (18). Closed for u in [0, pi]; crossing that seam turns v over.
struct MoebiusStrip {
  template <class S>
  Vector3<S> operator()(const S& u, const S& v) const {
    const auto [sin_u, cos_u] = sin_cos(u);
    const auto [sin_2u, cos_2u] = sin_cos(S(2.0 * u));
    const S r = 1.0 + v * cos_u;
    return {r * cos_2u, r * sin_2u, v * sin_u};
  }
};

/// Helicoid, VFCS Eq. (19): u along the rulings, v the angle, pitch 2 pi a.
struct Spiral {
  double a = 1;
  template <class S>
  Vector3<S> operator()(const S& u, const S& v) const {
    const auto [sin_v, cos_v] = sin_cos(v);
    return {u * cos_v, u * sin_v, a * v};
  }
};

struct Enneper {
  template <class S>
  Vector3<S> operator()(const S& u, const S& v) const {
    const S uu = u * u, vv = v * v;
    return {u * (1.0 - uu / 3.0 + vv), v * (1.0 - vv / 3.0 + uu), uu - vv};
  }
};

}  // namespace leastcost::chart
