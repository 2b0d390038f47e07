// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <leastcost/framework/numbers/interval_jet.hpp>

namespace leastcost {

/// c0 + c1 s + c2 s^2 + ...
template <std::size_t Degree>
struct Polynomial {
  std::array<double, Degree + 1> c = {};

  /// The same, around another origin.
  Polynomial around(double t) const {
    Polynomial out = *this;  // by Horner's scheme, again and again
    for (std::size_t first = 0; first < Degree; ++first)
      for (std::size_t k = Degree; k-- > first;) out.c[k] += t * out.c[k + 1];
    return out;
  }
  Polynomial derivative() const {
    Polynomial out;
    for (std::size_t k = 1; k <= Degree; ++k) out.c[k - 1] = static_cast<double>(k) * c[k];
    return out;
  }
  template <class S>
  S operator()(const S& s) const {
    S sum(c[Degree]);
    for (std::size_t k = Degree; k-- > 0;) sum = S(c[k]) + s * sum;
    return sum;
  }
  double at(double s) const { return (*this)(s); }
  /// As a function of variable 0, which is in `range`.
  template <int N>
  IntervalJet<N> jet(const Interval& range) const {
    const Polynomial first = derivative(), second = first.derivative(), third = second.derivative();
    return IntervalJet<N>::along(0, range, [&](const Interval& s) -> typename IntervalJet<N>::Derivatives {
      return {(*this)(s), first(s), second(s), third(s)};
    });
  }
};

using Cubic = Polynomial<3>;
using Quintic = Polynomial<5>;

inline Cubic line(double a, double b) { return {{a, b - a, 0, 0}}; }
/// With values a, b and slopes da, db at 0 and 1.
inline Cubic hermite(double a, double b, double da, double db) {
  return {{a, da, 3 * (b - a) - 2 * da - db, 2 * (a - b) + da + db}};
}
/// With second derivatives as well.
inline Quintic hermite(double a, double b, double da, double db, double dda, double ddb) {
  const double r = b - a - da - dda / 2, dr = db - da - dda, ddr = ddb - dda;
  return {{a, da, dda / 2, 10 * r - 4 * dr + ddr / 2, -15 * r + 7 * dr - ddr, 6 * r - 3 * dr + ddr / 2}};
}

/// One segment of a tube of N coordinates (t, z) in a space of D dimensions: the curve, its frame, and the matrix of
/// the potential, as functions of t in [0, 1]. For D = N + 1 the tube is the part of a level set that is a graph over
/// it: what lies within `reach` along `normal`, a unit vector.
template <int N, int D>
struct TubeSegment {
  static constexpr int kAcross = N - 1, kNormals = D - N;
  std::array<Quintic, D> curve;
  std::array<std::array<Cubic, kAcross>, D> frame;
  std::array<std::array<Cubic, kNormals>, D> normal;
  double reach = 0;
  std::array<std::array<Cubic, kAcross>, kAcross> w;
  std::array<std::array<std::array<Cubic, kAcross>, kAcross>, kAcross> third;

  TubeSegment around(double t) const {
    TubeSegment moved = *this;
    for (Quintic& c : moved.curve) c = c.around(t);
    for (auto& row : moved.frame)
      for (Cubic& c : row) c = c.around(t);
    for (auto& row : moved.normal)
      for (Cubic& c : row) c = c.around(t);
    for (auto& row : moved.w)
      for (Cubic& c : row) c = c.around(t);
    for (auto& rows : moved.third)
      for (auto& row : rows)
        for (Cubic& c : row) c = c.around(t);
    return moved;
  }
};

}  // namespace leastcost
