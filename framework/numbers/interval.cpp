// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/numbers/interval.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace leastcost {
namespace {

/// Around what a function of the C library returned for the two bounds.
Interval around(double lo, double hi) {
  constexpr double kUlps = 4 * std::numeric_limits<double>::epsilon();
  const double least = lo - std::max(kUlps * std::abs(lo), detail::kTiny),
               most = hi + std::max(kUlps * std::abs(hi), detail::kTiny);
  return {std::isnan(least) ? -std::numeric_limits<double>::infinity() : least,
          std::isnan(most) ? std::numeric_limits<double>::infinity() : most};
}

/// Outward from the bounds of a product, which may underflow.
Interval product_outward(double lo, double hi, bool never_negative, bool never_positive) {
  Interval x = detail::outward(lo, hi);
  if (std::abs(lo) < detail::kTiny) x.lo = never_negative ? 0 : -detail::kTiny;
  if (std::abs(hi) < detail::kTiny) x.hi = never_positive ? 0 : detail::kTiny;
  return x;
}

Interval clamped(const Interval& x, double least, double most) { return {std::max(x.lo, least), std::min(x.hi, most)}; }

/// The whole numbers k with (k + shift) pi in x; `first` > `last` where there is none.
struct Multiples {
  double first, last;
};
Multiples multiples_of_pi(const Interval& x, double shift) {
  const auto in_turns = [&](double value) { return value / std::numbers::pi - shift; };
  const auto slack = [](double turns) { return 8 * std::numeric_limits<double>::epsilon() * (std::abs(turns) + 1); };
  const double a = in_turns(x.lo), b = in_turns(x.hi);
  return {std::ceil(a - slack(a)), std::floor(b + slack(b))};
}

/// f = sin or cos, whose extrema are at (k + shift) pi, greatest for even k.
template <class F>
Interval wave(const Interval& x, double shift, F f) {
  constexpr double kFar = 1e8;  // beyond, the slack above is no longer small
  if (!(x.magnitude() < kFar)) return {-1, 1};
  const Multiples k = multiples_of_pi(x, shift);
  if (k.last > k.first) return {-1, 1};
  const double a = f(x.lo), b = f(x.hi);
  Interval range = around(std::min(a, b), std::max(a, b));
  if (k.last == k.first) (std::fmod(k.first, 2) == 0 ? range.hi : range.lo) = std::fmod(k.first, 2) == 0 ? 1 : -1;
  return clamped(range, -1, 1);
}

bool is_whole(double p) { return std::floor(p) == p && std::abs(p) < 1e9; }

}  // namespace

Interval detail::rare_product(const Interval& x, const Interval& y) {
  if ((x.lo == 0 && x.hi == 0) || (y.lo == 0 && y.hi == 0)) return {};  // also times all of R
  const double a = x.lo * y.lo, b = x.lo * y.hi, c = x.hi * y.lo, d = x.hi * y.hi;
  if (std::isnan(a + b + c + d)) return Interval::all();
  const bool same_sign = (x.lo >= 0 && y.lo >= 0) || (x.hi <= 0 && y.hi <= 0);
  const bool other_sign = (x.lo >= 0 && y.hi <= 0) || (x.hi <= 0 && y.lo >= 0);
  return product_outward(std::min(std::min(a, b), std::min(c, d)), std::max(std::max(a, b), std::max(c, d)), same_sign,
                         other_sign);
}

Interval square(const Interval& x) {
  const double a = x.lo * x.lo, b = x.hi * x.hi;
  return product_outward(x.contains(0) ? 0 : std::min(a, b), std::max(a, b), true, x.lo == 0 && x.hi == 0);
}

Interval sqrt(const Interval& x) {
  if (!(x.lo >= 0)) return Interval::all();
  Interval range = detail::outward(std::sqrt(x.lo), std::sqrt(x.hi));
  range.lo = std::max(range.lo, 0.0);
  return range;
}
Interval exp(const Interval& x) {
  Interval range = around(std::exp(x.lo), std::exp(x.hi));
  range.lo = std::max(range.lo, 0.0);
  return range;
}
Interval expm1(const Interval& x) { return around(std::expm1(x.lo), std::expm1(x.hi)); }
Interval log(const Interval& x) { return x.lo > 0 ? around(std::log(x.lo), std::log(x.hi)) : Interval::all(); }
Interval sin(const Interval& x) {
  return wave(x, 0.5, [](double t) { return std::sin(t); });
}
Interval cos(const Interval& x) {
  return wave(x, 0, [](double t) { return std::cos(t); });
}
Interval tan(const Interval& x) {
  const Multiples poles = multiples_of_pi(x, 0.5);
  if (!(x.magnitude() < 1e8) || poles.last >= poles.first) return Interval::all();
  return around(std::tan(x.lo), std::tan(x.hi));
}
Interval asin(const Interval& x) {
  return x.lo >= -1 && x.hi <= 1 ? around(std::asin(x.lo), std::asin(x.hi)) : Interval::all();
}
Interval acos(const Interval& x) {
  return x.lo >= -1 && x.hi <= 1 ? around(std::acos(x.hi), std::acos(x.lo)) : Interval::all();
}
Interval atan(const Interval& x) { return around(std::atan(x.lo), std::atan(x.hi)); }
Interval sinh(const Interval& x) { return around(std::sinh(x.lo), std::sinh(x.hi)); }
Interval cosh(const Interval& x) {
  const double a = std::cosh(x.lo), b = std::cosh(x.hi);
  Interval range = around(x.contains(0) ? 1 : std::min(a, b), std::max(a, b));
  range.lo = std::max(range.lo, 1.0);
  return range;
}
Interval tanh(const Interval& x) { return clamped(around(std::tanh(x.lo), std::tanh(x.hi)), -1, 1); }
Interval abs(const Interval& x) {
  if (x.lo >= 0) return x;
  if (x.hi <= 0) return -x;
  return {0, x.magnitude()};
}

Interval atan2(const Interval& y, const Interval& x) {
  // On the negative axis it jumps, at the origin it has no value.
  if (x.lo <= 0 && y.lo <= 0 && y.hi >= 0) return Interval::all();
  const double a = std::atan2(y.lo, x.lo), b = std::atan2(y.lo, x.hi), c = std::atan2(y.hi, x.lo),
               d = std::atan2(y.hi, x.hi);
  return around(std::min(std::min(a, b), std::min(c, d)), std::max(std::max(a, b), std::max(c, d)));
}
Interval hypot(const Interval& x, const Interval& y) { return sqrt(square(x) + square(y)); }

Interval pow(const Interval& x, double p) {
  if (p == 0) return Interval(1);
  if (p < 0) return Interval(1) / pow(x, -p);
  if (!is_whole(p)) {
    if (!(x.lo >= 0)) return Interval::all();
    Interval range = around(std::pow(x.lo, p), std::pow(x.hi, p));
    range.lo = std::max(range.lo, 0.0);
    return range;
  }
  const double a = std::pow(x.lo, p), b = std::pow(x.hi, p);
  if (std::fmod(p, 2) != 0) return around(a, b);
  Interval range = around(x.contains(0) ? 0 : std::min(a, b), std::max(a, b));
  range.lo = std::max(range.lo, 0.0);
  return range;
}
Interval pow(double x, const Interval& p) {
  if (!(x > 0)) return p.is_number() ? pow(Interval(x), p.lo) : Interval::all();
  const double a = std::pow(x, p.lo), b = std::pow(x, p.hi);
  return around(std::min(a, b), std::max(a, b));
}
Interval pow(const Interval& x, const Interval& p) { return p.is_number() ? pow(x, p.lo) : exp(p * log(x)); }

}  // namespace leastcost
