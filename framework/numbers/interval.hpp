// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <leastcost/framework/numbers/dual.hpp>

namespace leastcost {

/// A closed interval of real numbers. Every operation returns an interval that contains all results for numbers of its
/// operands: bounds are rounded outward by one ulp for arithmetic, which rounds to nearest within half of one, and by
/// four for the functions of the C library, which are within one in glibc. Where a result may be undefined (a division
/// by an interval that holds zero, the root of a negative number) it is all of R: nothing is known. Moore, Kearfott,
/// Cloud, "Introduction to Interval Analysis", 2009. Works in place of double in formulas and costs that compile with
/// it, and inside Dual; comparisons hold where they hold for all numbers of both.
struct Interval {
  double lo = 0, hi = 0;  ///< least and greatest number

  Interval() = default;
  Interval(double x) : lo(x), hi(x) {}  // NOLINT: numbers convert, as everywhere
  Interval(double least, double most) : lo(least), hi(most) {}

  /// Every number.
  static Interval all() { return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}; }

  bool contains(double x) const { return lo <= x && x <= hi; }               ///< whether x is in it
  bool is_number() const { return lo == hi; }                                ///< whether it is one number
  bool is_finite() const { return std::isfinite(lo) && std::isfinite(hi); }  ///< whether both ends are finite
  double middle() const { return 0.5 * lo + 0.5 * hi; }                      ///< a number near its middle
  double width() const { return hi - lo; }                                   ///< rounded: not a bound
  /// Largest absolute value.
  double magnitude() const { return std::max(std::abs(lo), std::abs(hi)); }

  Interval& operator+=(const Interval& o);
  Interval& operator-=(const Interval& o);
  Interval& operator*=(const Interval& o);
  Interval& operator/=(const Interval& o);
  Interval operator-() const { return {-hi, -lo}; }

  friend Interval operator+(Interval a, const Interval& b) { return a += b; }
  friend Interval operator-(Interval a, const Interval& b) { return a -= b; }
  friend Interval operator*(Interval a, const Interval& b) { return a *= b; }
  friend Interval operator/(Interval a, const Interval& b) { return a /= b; }
  friend bool operator<(const Interval& a, const Interval& b) { return a.hi < b.lo; }
  friend bool operator>(const Interval& a, const Interval& b) { return b < a; }
  friend bool operator<=(const Interval& a, const Interval& b) { return a.hi <= b.lo; }
  friend bool operator>=(const Interval& a, const Interval& b) { return b <= a; }
  friend bool operator==(const Interval& a, const Interval& b) { return a.lo == b.lo && a.hi == b.hi; }
};

namespace detail {

/// Bounds of what rounding to nearest made of a sum, a quotient or a root. Zero stays zero: a sum that underflows is
/// exact. NaN (inf - inf, 0 inf) bounds nothing.
inline double rounded_down(double x) {
  const double bound = x - std::abs(x) * std::numeric_limits<double>::epsilon();
  return bound == bound ? bound : -std::numeric_limits<double>::infinity();
}
inline double rounded_up(double x) { return -rounded_down(-x); }
inline Interval outward(double lo, double hi) { return {rounded_down(lo), rounded_up(hi)}; }

/// Products with an infinite bound, and those that may underflow. kTiny is far above the subnormal numbers, which are
/// slow.
inline constexpr double kTiny = 1e-290;
Interval rare_product(const Interval& x, const Interval& y);

}  // namespace detail

inline Interval& Interval::operator+=(const Interval& o) { return *this = detail::outward(lo + o.lo, hi + o.hi); }
inline Interval& Interval::operator-=(const Interval& o) { return *this = detail::outward(lo - o.hi, hi - o.lo); }
inline Interval& Interval::operator*=(const Interval& o) {
  const double a = lo * o.lo, b = lo * o.hi, c = hi * o.lo, d = hi * o.hi;
  const double least = std::min(std::min(a, b), std::min(c, d)), most = std::max(std::max(a, b), std::max(c, d));
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  const double least_size = std::abs(least), most_size = std::abs(most), sum = (a + b) + (c + d);
  if (sum - sum == 0 && least_size >= detail::kTiny && most_size >= detail::kTiny)  // finite, and no underflow
    return *this = {least - least_size * kUlp, most + most_size * kUlp};
  return *this = detail::rare_product(*this, o);
}
inline Interval& Interval::operator/=(const Interval& o) {
  if (o.lo <= 0 && o.hi >= 0) return *this = all();
  return *this *= detail::outward(1 / o.hi, 1 / o.lo);
}

/// x^2, which is never negative, as x * x of an interval can be.
Interval square(const Interval& x);
/// The smallest interval with both.
inline Interval hull(const Interval& a, const Interval& b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }

Interval sqrt(const Interval& x);
Interval exp(const Interval& x);
Interval expm1(const Interval& x);
Interval log(const Interval& x);
Interval sin(const Interval& x);
Interval cos(const Interval& x);
Interval tan(const Interval& x);
Interval asin(const Interval& x);
Interval acos(const Interval& x);
Interval atan(const Interval& x);
Interval sinh(const Interval& x);
Interval cosh(const Interval& x);
Interval tanh(const Interval& x);
Interval abs(const Interval& x);
Interval atan2(const Interval& y, const Interval& x);
Interval hypot(const Interval& x, const Interval& y);
Interval pow(const Interval& x, double p);
Interval pow(double x, const Interval& p);
Interval pow(const Interval& x, const Interval& p);

/// What decides branches of dual numbers: a number, or NaN where an interval is not one.
inline double innermost(const Interval& x) { return x.is_number() ? x.lo : std::numeric_limits<double>::quiet_NaN(); }
/// Whether it is one number.
inline bool is_constant(const Interval& x) { return x.is_number(); }

namespace detail {

template <class S>
struct IsIntervalBased : std::is_same<S, Interval> {};
template <class S, int N>
struct IsIntervalBased<Dual<S, N>> : IsIntervalBased<S> {};

}  // namespace detail

/// The range of a function, without its derivatives.
inline const Interval& range_of(const Interval& x) { return x; }
template <class S, int N>
decltype(auto) range_of(const Dual<S, N>& x) {
  return range_of(x.value);
}

/// Interval, or what carries derivatives with it.
template <class S>
concept IntervalBased = detail::IsIntervalBased<S>::value;

/// What holds of both: value and first derivatives of either. Where a function changes from one to the other it may
/// have a kink, and no higher derivatives.
inline Interval either(const Interval& a, const Interval& b) { return hull(a, b); }
/// A slope of either.
inline Interval either_slope(const Interval& a, const Interval& b) { return hull(a, b); }
template <IntervalBased S, int N>
Dual<S, N> either(const Dual<S, N>& a, const Dual<S, N>& b) {
  Dual<S, N> to;
  to.value = either(a.value, b.value);
  for (std::size_t k = 0; k < N; ++k) to.d[k] = either_slope(a.d[k], b.d[k]);
  return to;
}

template <IntervalBased S>
S min(const S& a, const S& b) {
  const Interval &x = range_of(a), &y = range_of(b);
  return x < y ? a : y < x ? b : either(a, b);  // where they touch there is a kink
}
template <IntervalBased S>
S max(const S& a, const S& b) {
  const Interval &x = range_of(a), &y = range_of(b);
  return x < y ? b : y < x ? a : either(a, b);
}
template <IntervalBased S, int N>
Dual<S, N> abs(const Dual<S, N>& x) {
  return max(x, -x);
}

}  // namespace leastcost
