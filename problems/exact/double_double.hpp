// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

namespace leastcost {

/// A number as the unevaluated sum of two doubles, about 104 bits (Dekker 1971; Hida, Li and Bailey 2001). Needs IEEE
/// doubles that are rounded to nearest and no contraction of its sums. Used where double runs out, not for speed.
struct DoubleDouble {
  double high = 0, low = 0;

  DoubleDouble() = default;
  DoubleDouble(double x) : high(x) {}  // NOLINT(google-explicit-constructor): it is a number
  explicit operator double() const { return high; }

  /// a + b without error; |a| >= |b| or a == 0.
  static DoubleDouble quick_sum(double a, double b) {
    DoubleDouble r;
    r.high = a + b;
    r.low = b - (r.high - a);
    return r;
  }
  static DoubleDouble sum(double a, double b) {
    DoubleDouble r;
    r.high = a + b;
    const double other = r.high - a;
    r.low = (a - (r.high - other)) + (b - other);
    return r;
  }
  static DoubleDouble product(double a, double b) {
    DoubleDouble r;
    r.high = a * b;
    r.low = std::fma(a, b, -r.high);
    return r;
  }

  DoubleDouble operator-() const {
    DoubleDouble r;
    r.high = -high;
    r.low = -low;
    return r;
  }
  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    DoubleDouble s = sum(a.high, b.high);
    const DoubleDouble t = sum(a.low, b.low);
    s = quick_sum(s.high, s.low + t.high);
    return quick_sum(s.high, s.low + t.low);
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble p = product(a.high, b.high);
    return quick_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
  }
  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double q1 = a.high / b.high;
    if (!std::isfinite(q1)) return DoubleDouble(q1);
    DoubleDouble rest = a - b * DoubleDouble(q1);
    const double q2 = rest.high / b.high;
    rest = rest - b * DoubleDouble(q2);
    return quick_sum(q1, q2) + DoubleDouble(rest.high / b.high);
  }
  friend bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
  }
  friend bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
};

inline DoubleDouble sqrt(const DoubleDouble& a) {
  if (!(a.high > 0)) return DoubleDouble(0.0);
  const DoubleDouble x(std::sqrt(a.high));
  return x + (a - x * x) / DoubleDouble(2 * x.high);
}

/// What one operation loses at most, relative.
template <class Real>
constexpr double kRoundingOf = std::numeric_limits<double>::epsilon();
template <>
inline constexpr double kRoundingOf<DoubleDouble> = 0x1p-98;

}  // namespace leastcost
