// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <leastcost/framework/numbers/interval_jet.hpp>

namespace leastcost {

/// c0 + c1 s + c2 s^2 + c3 s^3.
struct Cubic {
  std::array<double, 4> c = {};

  /// With values a, b and slopes da, db at 0 and 1.
  static Cubic hermite(double a, double b, double da, double db) {
    return {{a, da, 3 * (b - a) - 2 * da - db, 2 * (a - b) + da + db}};
  }
  static Cubic line(double a, double b) { return {{a, b - a, 0, 0}}; }
  /// The same, around another origin.
  Cubic around(double t) const {
    return {
        {c[0] + t * (c[1] + t * (c[2] + t * c[3])), c[1] + t * (2 * c[2] + t * 3 * c[3]), c[2] + 3 * t * c[3], c[3]}};
  }
  Cubic derivative() const { return {{c[1], 2 * c[2], 3 * c[3], 0}}; }
  template <class S>
  S operator()(const S& s) const {
    return S(c[0]) + s * (S(c[1]) + s * (S(c[2]) + s * S(c[3])));
  }
  double at(double s) const { return (*this)(s); }
  /// As a function of variable 0, which is in `range`.
  template <int N>
  IntervalJet<N> jet(const Interval& range) const {
    const Cubic first = derivative(), second = first.derivative();
    return IntervalJet<N>::along(0, range, [&](const Interval& s) -> typename IntervalJet<N>::Derivatives {
      return {(*this)(s), first(s), second(s), second.c[1]};
    });
  }
};

/// One segment of a tube of N coordinates (t, z) in a space of D dimensions: the curve, its frame, and the matrix of
/// the potential, as functions of t in [0, 1]. For D = N + 1 the tube is the part of a level set that is a graph over
/// it: what lies within `reach` along `normal`, a unit vector.
template <int N, int D>
struct TubeSegment {
  static constexpr int kAcross = N - 1, kNormals = D - N;
  std::array<Cubic, D> curve;
  std::array<std::array<Cubic, kAcross>, D> frame;
  std::array<std::array<Cubic, kNormals>, D> normal;
  double reach = 0;
  std::array<std::array<Cubic, kAcross>, kAcross> w;
  std::array<std::array<std::array<Cubic, kAcross>, kAcross>, kAcross> third;

  TubeSegment around(double t) const {
    TubeSegment moved = *this;
    for (Cubic& c : moved.curve) c = c.around(t);
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
