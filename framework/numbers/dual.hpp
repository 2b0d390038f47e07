// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// Forward-mode dual number with N derivatives: value + sum_k d[k] e_k, e_j e_k = 0. Nested, Dual<Dual<double, N>, N>,
/// it carries Hessians. Comparison looks at the value only, so branches of a cost work as they stand. What an author of
/// a cost has to know about them: docs/extend.md.
template <class S, int N>
struct Dual {
  S value{};             ///< the number itself
  std::array<S, N> d{};  ///< its derivatives

  Dual() = default;
  Dual(double constant) : value(constant) {}  // NOLINT: numbers convert, as everywhere
  Dual(const S& v, const std::array<S, N>& derivatives) : value(v), d(derivatives) {}

  Dual& operator+=(const Dual& o) {
    value += o.value;
    for (int k = 0; k < N; ++k) d[k] += o.d[k];
    return *this;
  }
  Dual& operator-=(const Dual& o) {
    value -= o.value;
    for (int k = 0; k < N; ++k) d[k] -= o.d[k];
    return *this;
  }
  Dual& operator*=(const Dual& o) {
    for (int k = 0; k < N; ++k) d[k] = d[k] * o.value + value * o.d[k];
    value *= o.value;
    return *this;
  }
  Dual& operator/=(const Dual& o) {
    value /= o.value;
    for (int k = 0; k < N; ++k) d[k] = (d[k] - value * o.d[k]) / o.value;
    return *this;
  }
  Dual& operator*=(double constant) {
    value *= constant;
    for (int k = 0; k < N; ++k) d[k] *= constant;
    return *this;
  }
  Dual operator-() const {
    Dual r;
    r.value = -value;
    for (int k = 0; k < N; ++k) r.d[k] = -d[k];
    return r;
  }

  friend Dual operator+(Dual a, const Dual& b) { return a += b; }
  friend Dual operator-(Dual a, const Dual& b) { return a -= b; }
  friend Dual operator*(Dual a, const Dual& b) { return a *= b; }
  friend Dual operator/(Dual a, const Dual& b) { return a /= b; }
  // Constants are most factors of a formula, and have no derivatives.
  friend Dual operator+(Dual a, double b) { return a.value += b, a; }
  friend Dual operator+(double a, Dual b) { return b.value += a, b; }
  friend Dual operator-(Dual a, double b) { return a.value -= b, a; }
  friend Dual operator*(Dual a, double b) { return a *= b; }
  friend Dual operator*(double a, Dual b) { return b *= a; }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return b < a; }
  friend bool operator<=(const Dual& a, const Dual& b) { return !(b < a); }
  friend bool operator>=(const Dual& a, const Dual& b) { return !(a < b); }
  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend bool operator!=(const Dual& a, const Dual& b) { return !(a == b); }
};

inline double innermost(double x) { return x; }
template <class S, int N>
double innermost(const Dual<S, N>& x) {
  return innermost(x.value);
}

/// Whether it has no derivatives.
inline bool is_constant(double) { return true; }
template <class S, int N>
bool is_constant(const Dual<S, N>& x) {
  for (const S& dk : x.d)
    if (innermost(dk) != 0 || !is_constant(dk)) return false;
  return is_constant(x.value);
}

/// f(x) from f and f' at x.value. A function of a constant is a constant, also where f' is infinite: the root of 0, the
/// logarithm of 0, the arc cosine of 1. (0 times infinity would make its derivatives NaN: a bead at rest at a fixed
/// end.)
template <class S, int N>
Dual<S, N> compose(const Dual<S, N>& x, const S& f, const S& df) {
  Dual<S, N> r;
  r.value = f;
  if (!std::isfinite(innermost(df)) && is_constant(x)) return r;
  for (int k = 0; k < N; ++k) r.d[k] = df * x.d[k];
  return r;
}

template <class S, int N>
Dual<S, N> sqrt(const Dual<S, N>& x) {
  using std::sqrt;
  const S root = sqrt(x.value);
  return compose(x, root, S(0.5) / root);
}
template <class S, int N>
Dual<S, N> exp(const Dual<S, N>& x) {
  using std::exp;
  const S e = exp(x.value);
  return compose(x, e, e);
}
template <class S, int N>
Dual<S, N> expm1(const Dual<S, N>& x) {
  using std::exp, std::expm1;
  return compose(x, S(expm1(x.value)), S(exp(x.value)));
}
template <class S, int N>
Dual<S, N> log(const Dual<S, N>& x) {
  using std::log;
  return compose(x, S(log(x.value)), S(1.0) / x.value);
}
template <class S, int N>
Dual<S, N> sin(const Dual<S, N>& x) {
  using std::cos, std::sin;
  return compose(x, S(sin(x.value)), S(cos(x.value)));
}
template <class S, int N>
Dual<S, N> cos(const Dual<S, N>& x) {
  using std::cos, std::sin;
  return compose(x, S(cos(x.value)), S(-sin(x.value)));
}
template <class S, int N>
Dual<S, N> sinh(const Dual<S, N>& x) {
  using std::cosh, std::sinh;
  return compose(x, S(sinh(x.value)), S(cosh(x.value)));
}
template <class S, int N>
Dual<S, N> cosh(const Dual<S, N>& x) {
  using std::cosh, std::sinh;
  return compose(x, S(cosh(x.value)), S(sinh(x.value)));
}
template <class S, int N>
Dual<S, N> tanh(const Dual<S, N>& x) {
  using std::tanh;
  const S t = tanh(x.value);
  return compose(x, t, S(1.0) - t * t);
}
template <class S, int N>
Dual<S, N> atan(const Dual<S, N>& x) {
  using std::atan;
  return compose(x, S(atan(x.value)), S(1.0) / (S(1.0) + x.value * x.value));
}
template <class S, int N>
Dual<S, N> tan(const Dual<S, N>& x) {
  using std::tan;
  const S t = tan(x.value);
  return compose(x, t, S(1.0) + t * t);
}
template <class S, int N>
Dual<S, N> asin(const Dual<S, N>& x) {
  using std::asin, std::sqrt;
  return compose(x, S(asin(x.value)), S(1.0) / S(sqrt((S(1.0) - x.value) * (S(1.0) + x.value))));
}
template <class S, int N>
Dual<S, N> acos(const Dual<S, N>& x) {
  using std::acos, std::sqrt;
  return compose(x, S(acos(x.value)), S(-1.0) / S(sqrt((S(1.0) - x.value) * (S(1.0) + x.value))));
}

/// f(x, y) from f and its partial derivatives at the values. Constant arguments as in one variable.
template <class S, int N>
Dual<S, N> compose(const Dual<S, N>& x, const Dual<S, N>& y, const S& f, const S& fx, const S& fy) {
  Dual<S, N> r;
  r.value = f;
  if (!std::isfinite(innermost(fx)) && is_constant(x)) return compose(y, f, fy);
  if (!std::isfinite(innermost(fy)) && is_constant(y)) return compose(x, f, fx);
  for (int k = 0; k < N; ++k) r.d[k] = fx * x.d[k] + fy * y.d[k];
  return r;
}

template <class S, int N>
Dual<S, N> atan2(const Dual<S, N>& y, const Dual<S, N>& x) {
  using std::atan2;
  const S r2 = x.value * x.value + y.value * y.value;
  return compose(y, x, S(atan2(y.value, x.value)), S(x.value / r2), S(-y.value / r2));
}
template <class S, int N>
Dual<S, N> hypot(const Dual<S, N>& x, const Dual<S, N>& y) {
  using std::hypot;
  const S h = hypot(x.value, y.value);
  return compose(x, y, h, S(x.value / h), S(y.value / h));
}
template <class S, int N>
Dual<S, N> pow(const Dual<S, N>& x, double p) {
  using std::pow;
  return compose(x, S(pow(x.value, p)), p == 0 ? S(0.0) : S(S(p) * S(pow(x.value, p - 1))));
}
/// A constant exponent, also one that only happens to be a dual, leaves x free to be negative.
template <class S, int N>
Dual<S, N> pow(const Dual<S, N>& x, const Dual<S, N>& p) {
  using std::log, std::pow;
  if (is_constant(p)) return pow(x, innermost(p));
  const S power = pow(x.value, p.value);
  const S by_exponent = innermost(power) == 0 ? S(0.0) : S(power * log(x.value));  // x^p log x -> 0 with x, p > 0
  return compose(x, p, power, S(p.value * pow(x.value, S(p.value - S(1.0)))), by_exponent);
}
template <class S, int N>
Dual<S, N> pow(double x, const Dual<S, N>& p) {
  using std::log, std::pow;
  const S power = pow(x, p.value);
  return compose(p, power, innermost(power) == 0 ? S(0.0) : S(power * S(std::log(x))));
}
template <class S, int N>
Dual<S, N> abs(const Dual<S, N>& x) {
  return innermost(x) < 0 ? -x : x;
}
template <class S, int N>
bool isfinite(const Dual<S, N>& x) {
  return std::isfinite(innermost(x));
}

}  // namespace leastcost

namespace Eigen {

template <class S, int N>
struct NumTraits<leastcost::Dual<S, N>> : NumTraits<double> {
  using Real = leastcost::Dual<S, N>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = double;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = N,
    AddCost = N,
    MulCost = 2 * N
  };
};

template <class S, int N, class Op>
struct ScalarBinaryOpTraits<leastcost::Dual<S, N>, double, Op> {
  using ReturnType = leastcost::Dual<S, N>;
};
template <class S, int N, class Op>
struct ScalarBinaryOpTraits<double, leastcost::Dual<S, N>, Op> {
  using ReturnType = leastcost::Dual<S, N>;
};

}  // namespace Eigen
