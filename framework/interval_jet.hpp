// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <limits>

#include <leastcost/framework/interval.hpp>

namespace leastcost {

namespace detail {

/// The monomials in N variables up to a degree of three, by degree, and which of them multiply to a third.
template <int N>
struct Monomials {
  static constexpr int kDegree = 3;
  static constexpr int kCount = (N + 1) * (N + 2) * (N + 3) / 6;
  using Exponents = std::array<int, static_cast<std::size_t>(N)>;

  struct Product {
    int a, b, to;
  };
  static constexpr int kProducts = [] {
    int count = 1;  // pairs of monomials are monomials in 2N variables
    for (int i = 1; i <= kDegree; ++i) count = count * (2 * N + i) / i;
    return count;
  }();

  std::array<Exponents, static_cast<std::size_t>(kCount)> exponents = {};
  std::array<int, static_cast<std::size_t>(kCount)> degree = {};
  std::array<Product, static_cast<std::size_t>(kProducts)> products = {};

  constexpr Monomials() {
    int count = 0;
    for (int d = 0; d <= kDegree; ++d) {
      Exponents e = {};
      for (int code = 0; code < 64; ++code) {
        int rest = code, sum = 0;
        for (auto& exponent : e) {
          exponent = rest % 4;
          sum += exponent;
          rest /= 4;
        }
        if (rest != 0 || sum != d) continue;
        exponents[static_cast<std::size_t>(count)] = e;
        degree[static_cast<std::size_t>(count++)] = d;
      }
    }
    std::size_t k = 0;
    for (int a = 0; a < kCount; ++a)
      for (int b = 0; b < kCount; ++b) {
        if (degree[static_cast<std::size_t>(a)] + degree[static_cast<std::size_t>(b)] > kDegree) continue;
        Exponents e = exponents[static_cast<std::size_t>(a)];
        for (std::size_t v = 0; v < e.size(); ++v) e[v] += exponents[static_cast<std::size_t>(b)][v];
        products[k++] = {a, b, index(e)};
      }
  }

  constexpr int index(const Exponents& e) const {
    for (int i = 0; i < kCount; ++i)
      if (exponents[static_cast<std::size_t>(i)] == e) return i;
    return -1;
  }
};
template <int N>
inline constexpr Monomials<N> kMonomials;

}  // namespace detail

/// A function of N variables (two or three) over a box: enclosures, over the whole of it, of the value and of all
/// derivatives up to the third, as Taylor coefficients. Works in place of a number in formulas and in costs that
/// compile with it, and inside Dual.
template <int N>
class IntervalJet {
 public:
  static constexpr int kCount = detail::Monomials<N>::kCount;

  IntervalJet() = default;
  IntervalJet(double constant) { c_[0] = Interval(constant); }  // NOLINT: numbers convert, as everywhere
  IntervalJet(const Interval& constant) { c_[0] = constant; }   // NOLINT

  /// The variable number k, in `range`.
  static IntervalJet variable(const Interval& range, int k) {
    IntervalJet x(range);
    x.c_[static_cast<std::size_t>(place(k))] = Interval(1);
    return x;
  }
  /// A function of which nothing is known.
  static IntervalJet unknown() {
    IntervalJet x;
    x.c_.fill(Interval::all());
    return x;
  }

  const Interval& value() const { return c_[0]; }
  Interval d(int k) const { return c_[static_cast<std::size_t>(place(k))]; }
  Interval d(int k, int l) const { return factor(k, l) * c_[static_cast<std::size_t>(place(k, l))]; }
  Interval d(int k, int l, int m) const { return factor(k, l, m) * c_[static_cast<std::size_t>(place(k, l, m))]; }

  /// The derivative of a function of variable k alone; its own third derivative is unknown.
  IntervalJet derivative(int k) const {
    IntervalJet out(d(k));
    out.c_[static_cast<std::size_t>(place(k))] = d(k, k);
    out.c_[static_cast<std::size_t>(place(k, k))] = d(k, k, k) / Interval(2);
    out.c_[static_cast<std::size_t>(place(k, k, k))] = Interval::all();
    return out;
  }

  /// A function of variable k alone, from its value and derivatives there.
  static IntervalJet along(int k, const Interval& f, const Interval& f1, const Interval& f2, const Interval& f3) {
    IntervalJet out(f);
    out.c_[static_cast<std::size_t>(place(k))] = f1;
    out.c_[static_cast<std::size_t>(place(k, k))] = f2 / Interval(2);
    out.c_[static_cast<std::size_t>(place(k, k, k))] = f3 / Interval(6);
    return out;
  }

  IntervalJet scaled(const Interval& factor) const {
    IntervalJet out = *this;
    for (Interval& c : out.c_) c *= factor;
    return out;
  }

  IntervalJet& operator+=(const IntervalJet& o) {
    for (std::size_t i = 0; i < c_.size(); ++i) c_[i] += o.c_[i];
    return *this;
  }
  IntervalJet& operator-=(const IntervalJet& o) {
    for (std::size_t i = 0; i < c_.size(); ++i) c_[i] -= o.c_[i];
    return *this;
  }
  IntervalJet& operator*=(const IntervalJet& o) { return *this = *this * o; }
  IntervalJet& operator/=(const IntervalJet& o) { return *this = *this * reciprocal(o); }
  IntervalJet operator-() const {
    IntervalJet out;
    for (std::size_t i = 0; i < c_.size(); ++i) out.c_[i] = -c_[i];
    return out;
  }

  friend IntervalJet operator+(IntervalJet a, const IntervalJet& b) { return a += b; }
  friend IntervalJet operator-(IntervalJet a, const IntervalJet& b) { return a -= b; }
  friend IntervalJet operator*(const IntervalJet& a, const IntervalJet& b) {
    IntervalJet out;
    for (const auto& p : detail::kMonomials<N>.products) {
      const Interval &x = a.c_[static_cast<std::size_t>(p.a)], &y = b.c_[static_cast<std::size_t>(p.b)];
      if ((x.lo == 0 && x.hi == 0) || (y.lo == 0 && y.hi == 0)) continue;
      out.c_[static_cast<std::size_t>(p.to)] += x * y;
    }
    return out;
  }
  friend IntervalJet operator/(const IntervalJet& a, const IntervalJet& b) { return a * reciprocal(b); }
  friend bool operator<(const IntervalJet& a, const IntervalJet& b) { return a.value() < b.value(); }
  friend bool operator>(const IntervalJet& a, const IntervalJet& b) { return b < a; }
  friend bool operator<=(const IntervalJet& a, const IntervalJet& b) { return a.value() <= b.value(); }
  friend bool operator>=(const IntervalJet& a, const IntervalJet& b) { return b <= a; }

  bool is_constant() const {
    for (std::size_t i = 1; i < c_.size(); ++i)
      if (c_[i].lo != 0 || c_[i].hi != 0) return false;
    return c_[0].is_number();
  }

  friend IntervalJet square(const IntervalJet& x) {
    IntervalJet out = x * x;
    out.c_[0] = square(x.c_[0]);
    return out;
  }
  /// f(x) from f, f', f'', f''' on the range of x.
  friend IntervalJet compose(const IntervalJet& x, const Interval& f, const Interval& f1, const Interval& f2,
                             const Interval& f3) {
    IntervalJet change = x;
    change.c_[0] = Interval(0);
    if (x.is_constant()) return IntervalJet(f);
    const IntervalJet change2 = change * change;
    IntervalJet out = (change2 * change).scaled(f3 / Interval(6));
    out += change2.scaled(f2 / Interval(2));
    out += change.scaled(f1);
    out.c_[0] = f;
    return out;
  }
  friend IntervalJet reciprocal(const IntervalJet& x) {
    const Interval r = Interval(1) / x.value(), r2 = square(r);
    return compose(x, r, -r2, Interval(2) * r2 * r, Interval(-6) * square(r2));
  }

  /// What holds of both functions: value and first derivatives of either. Where a function changes from one to the
  /// other it may have a kink, and no higher derivatives.
  friend IntervalJet either(const IntervalJet& a, const IntervalJet& b) {
    IntervalJet out = unknown();
    for (std::size_t i = 0; i <= N; ++i) out.c_[i] = hull(a.c_[i], b.c_[i]);
    return out;
  }
  friend IntervalJet either_slope(const IntervalJet& a, const IntervalJet& b) {
    IntervalJet out = unknown();
    out.c_[0] = hull(a.c_[0], b.c_[0]);
    return out;
  }

 private:
  static constexpr int place(int k) {
    typename detail::Monomials<N>::Exponents e = {};
    ++e[static_cast<std::size_t>(k)];
    return detail::kMonomials<N>.index(e);
  }
  static constexpr int place(int k, int l) {
    typename detail::Monomials<N>::Exponents e = {};
    ++e[static_cast<std::size_t>(k)], ++e[static_cast<std::size_t>(l)];
    return detail::kMonomials<N>.index(e);
  }
  static constexpr int place(int k, int l, int m) {
    typename detail::Monomials<N>::Exponents e = {};
    ++e[static_cast<std::size_t>(k)], ++e[static_cast<std::size_t>(l)], ++e[static_cast<std::size_t>(m)];
    return detail::kMonomials<N>.index(e);
  }
  static Interval factor(int k, int l) { return Interval(k == l ? 2 : 1); }
  static Interval factor(int k, int l, int m) {
    return Interval(k == l && l == m ? 6 : k == l || l == m || k == m ? 2 : 1);
  }

  std::array<Interval, static_cast<std::size_t>(kCount)> c_ = {};
};

namespace detail {
template <int N>
struct IsIntervalBased<IntervalJet<N>> : std::true_type {};
}  // namespace detail

template <int N>
const Interval& range_of(const IntervalJet<N>& x) {
  return x.value();
}

template <int N>
double innermost(const IntervalJet<N>& x) {
  return innermost(x.value());
}
template <int N>
bool is_constant(const IntervalJet<N>& x) {
  return x.is_constant();
}

template <int N>
IntervalJet<N> sqrt(const IntervalJet<N>& x) {
  const Interval f = sqrt(x.value()), r = Interval(1) / x.value(), f1 = Interval(0.5) * f * r,
                 f2 = Interval(-0.5) * f1 * r;
  return compose(x, f, f1, f2, Interval(-1.5) * f2 * r);
}
template <int N>
IntervalJet<N> exp(const IntervalJet<N>& x) {
  const Interval f = exp(x.value());
  return compose(x, f, f, f, f);
}
template <int N>
IntervalJet<N> log(const IntervalJet<N>& x) {
  const Interval r = Interval(1) / x.value();
  return compose(x, log(x.value()), r, -square(r), Interval(2) * square(r) * r);
}
template <int N>
IntervalJet<N> sin(const IntervalJet<N>& x) {
  const Interval s = sin(x.value()), c = cos(x.value());
  return compose(x, s, c, -s, -c);
}
template <int N>
IntervalJet<N> cos(const IntervalJet<N>& x) {
  const Interval s = sin(x.value()), c = cos(x.value());
  return compose(x, c, -s, -c, s);
}
template <int N>
IntervalJet<N> tan(const IntervalJet<N>& x) {
  const Interval t = tan(x.value()), f1 = Interval(1) + square(t), f2 = Interval(2) * t * f1;
  return compose(x, t, f1, f2, Interval(2) * f1 * (Interval(1) + Interval(3) * square(t)));
}
template <int N>
IntervalJet<N> asin(const IntervalJet<N>& x) {
  const Interval v = x.value(), f1 = Interval(1) / sqrt((Interval(1) - v) * (Interval(1) + v)), f13 = f1 * square(f1);
  return compose(x, asin(v), f1, v * f13, (Interval(1) + Interval(2) * square(v)) * f13 * square(f1));
}
template <int N>
IntervalJet<N> acos(const IntervalJet<N>& x) {
  const Interval v = x.value(), f1 = Interval(1) / sqrt((Interval(1) - v) * (Interval(1) + v)), f13 = f1 * square(f1);
  return compose(x, acos(v), -f1, -(v * f13), -((Interval(1) + Interval(2) * square(v)) * f13 * square(f1)));
}
template <int N>
IntervalJet<N> atan(const IntervalJet<N>& x) {
  const Interval v = x.value(), f1 = Interval(1) / (Interval(1) + square(v));
  return compose(x, atan(v), f1, Interval(-2) * v * square(f1),
                 (Interval(6) * square(v) - Interval(2)) * f1 * square(f1));
}
template <int N>
IntervalJet<N> sinh(const IntervalJet<N>& x) {
  const Interval s = sinh(x.value()), c = cosh(x.value());
  return compose(x, s, c, s, c);
}
template <int N>
IntervalJet<N> cosh(const IntervalJet<N>& x) {
  const Interval s = sinh(x.value()), c = cosh(x.value());
  return compose(x, c, s, c, s);
}
template <int N>
IntervalJet<N> tanh(const IntervalJet<N>& x) {
  const Interval t = tanh(x.value()), f1 = Interval(1) - square(t), f2 = Interval(-2) * t * f1;
  return compose(x, t, f1, f2, Interval(-2) * f1 * (Interval(1) - Interval(3) * square(t)));
}
template <int N>
IntervalJet<N> pow(const IntervalJet<N>& x, double p) {
  const auto term = [&](double factor, double exponent) {
    return factor == 0 ? Interval(0) : Interval(factor) * pow(x.value(), exponent);
  };
  return compose(x, pow(x.value(), p), term(p, p - 1), Interval(p) * term(p - 1, p - 2),
                 Interval(p) * Interval(p - 1) * term(p - 2, p - 3));
}
template <int N>
IntervalJet<N> pow(const IntervalJet<N>& x, const IntervalJet<N>& p) {
  if (p.is_constant()) return pow(x, p.value().lo);
  return exp(p * log(x));
}
template <int N>
IntervalJet<N> pow(double x, const IntervalJet<N>& p) {
  return x > 0 ? exp(p * IntervalJet<N>(log(Interval(x)))) : IntervalJet<N>::unknown();
}
template <int N>
IntervalJet<N> hypot(const IntervalJet<N>& x, const IntervalJet<N>& y) {
  return sqrt(square(x) + square(y));
}
/// By the arc tangent of the quotient whose denominator keeps away from zero; they differ by constants.
template <int N>
IntervalJet<N> atan2(const IntervalJet<N>& y, const IntervalJet<N>& x) {
  const Interval angle = atan2(y.value(), x.value());
  if (!angle.is_finite()) return IntervalJet<N>::unknown();
  const bool steep = x.value().contains(0);
  IntervalJet<N> out = steep ? -atan(x / y) : atan(y / x);
  out += IntervalJet<N>(angle - out.value());
  return out;
}
template <int N>
IntervalJet<N> abs(const IntervalJet<N>& x) {
  return max(x, -x);
}

}  // namespace leastcost

namespace Eigen {

template <int N>
struct NumTraits<leastcost::IntervalJet<N>> : NumTraits<double> {
  using Real = leastcost::IntervalJet<N>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = double;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 20,
    AddCost = 20,
    MulCost = 100
  };
};

template <int N, class Op>
struct ScalarBinaryOpTraits<leastcost::IntervalJet<N>, double, Op> {
  using ReturnType = leastcost::IntervalJet<N>;
};
template <int N, class Op>
struct ScalarBinaryOpTraits<double, leastcost::IntervalJet<N>, Op> {
  using ReturnType = leastcost::IntervalJet<N>;
};

}  // namespace Eigen
