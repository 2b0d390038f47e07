// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
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

/// A function of N variables (two or three) over a box: enclosures of the value and of all derivatives up to the third,
/// over the whole of it and at its centre, as Taylor coefficients. After each operation the mean value theorem bounds
/// what holds over the box by what holds at the centre, so that what cancels there cancels over the box, and bounds are
/// too wide by the square of its size only. Works in place of a number in formulas and in costs that compile with it,
/// and inside Dual.
template <int N>
class IntervalJet {
 public:
  static constexpr int kCount = detail::Monomials<N>::kCount;
  /// Value and first three derivatives of a function of one variable.
  using Derivatives = std::array<Interval, 4>;

  IntervalJet() = default;
  IntervalJet(double constant) : IntervalJet(Interval(constant)) {}     // NOLINT: numbers convert, as everywhere
  IntervalJet(const Interval& constant) { c_[0] = at_[0] = constant; }  // NOLINT

  /// The variable number k, in `range`.
  static IntervalJet variable(const Interval& range, int k) {
    return along(k, range, [](const Interval& x) { return Derivatives{x, 1.0, 0.0, 0.0}; });
  }
  /// A function of variable number k alone, which is in `range`.
  template <class F>
  static IntervalJet along(int k, const Interval& range, const F& derivatives) {
    IntervalJet x;
    const double middle = range.middle();
    x.radius_[static_cast<std::size_t>(k)] = std::max(range.hi - middle, middle - range.lo) * (1 + kRounding);
    x.c_ = along(k, derivatives(range));
    x.at_ = along(k, derivatives(Interval(middle)));
    x.tighten();
    return x;
  }
  /// A function of which nothing is known.
  static IntervalJet unknown() {
    IntervalJet x;
    x.c_.fill(Interval::all());
    x.at_.fill(Interval::all());
    return x;
  }

  const Interval& value() const { return c_[0]; }
  Interval d(int k) const { return c_[kFirst[static_cast<std::size_t>(k)]]; }
  Interval d(int k, int l) const { return factor(k, l) * c_[place(k, l)]; }
  Interval d(int k, int l, int m) const { return factor(k, l, m) * c_[place(k, l, m)]; }
  /// The same at the centre of the box.
  const Interval& value_at_center() const { return at_[0]; }
  Interval d_at_center(int k) const { return at_[kFirst[static_cast<std::size_t>(k)]]; }
  Interval d_at_center(int k, int l) const { return factor(k, l) * at_[place(k, l)]; }

  /// The derivative of a function of variable k alone; its own third derivative is unknown.
  IntervalJet derivative(int k) const {
    IntervalJet out;
    out.radius_ = radius_;
    out.c_ = derivative(k, c_);
    out.at_ = derivative(k, at_);
    return out;
  }
  IntervalJet scaled(const Interval& factor) const {
    IntervalJet out = *this;
    for (Interval& c : out.c_) c *= factor;
    for (Interval& c : out.at_) c *= factor;
    return out;
  }

  IntervalJet& operator+=(const IntervalJet& o) {
    for (std::size_t i = 0; i < c_.size(); ++i) c_[i] += o.c_[i], at_[i] += o.at_[i];
    widen(o);
    return *this;
  }
  IntervalJet& operator-=(const IntervalJet& o) {
    for (std::size_t i = 0; i < c_.size(); ++i) c_[i] -= o.c_[i], at_[i] -= o.at_[i];
    widen(o);
    return *this;
  }
  IntervalJet& operator*=(const IntervalJet& o) { return *this = *this * o; }
  IntervalJet& operator/=(const IntervalJet& o) { return *this = *this * reciprocal(o); }
  IntervalJet operator-() const {
    IntervalJet out = *this;
    for (std::size_t i = 0; i < c_.size(); ++i) out.c_[i] = -c_[i], out.at_[i] = -at_[i];
    return out;
  }

  friend IntervalJet operator+(IntervalJet a, const IntervalJet& b) { return a += b; }
  friend IntervalJet operator-(IntervalJet a, const IntervalJet& b) { return a -= b; }
  friend IntervalJet operator*(const IntervalJet& a, const IntervalJet& b) {
    if (a.is_constant()) return b.scaled(a.c_[0]);
    if (b.is_constant()) return a.scaled(b.c_[0]);
    IntervalJet out = a;
    out.widen(b);
    out.at_ = product(a.at_, b.at_);
    out.c_ = out.is_thin() ? out.at_ : product(a.c_, b.c_);
    out.tighten();
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
    out.c_[0] = common(out.c_[0], square(x.c_[0]));
    out.at_[0] = common(out.at_[0], square(x.at_[0]));
    return out;
  }
  /// f(x), where `derivatives` of an interval encloses f and its first three derivatives over it.
  template <class F>
  friend IntervalJet compose(const IntervalJet& x, const F& derivatives) {
    IntervalJet out;
    out.radius_ = x.radius_;
    out.at_ = composed(x.at_, derivatives(x.at_[0]));
    out.c_ = x.is_thin() ? out.at_ : composed(x.c_, derivatives(x.c_[0]));
    out.tighten();
    return out;
  }
  friend IntervalJet reciprocal(const IntervalJet& x) {
    return compose(x, [](const Interval& v) {
      const Interval r = Interval(1) / v, r2 = square(r);
      return Derivatives{r, -r2, Interval(2) * r2 * r, Interval(-6) * square(r2)};
    });
  }

  /// By the arc tangent of the quotient whose denominator keeps away from zero; they differ by constants.
  friend IntervalJet atan2(const IntervalJet& y, const IntervalJet& x) {
    const Interval angle = atan2(y.value(), x.value());
    if (!angle.is_finite()) return unknown();
    IntervalJet out = x.value().contains(0) ? -atan(x / y) : atan(y / x);
    out.c_[0] = angle;
    out.at_[0] = atan2(y.at_[0], x.at_[0]);
    return out;
  }

  /// What holds of both functions: value and first derivatives of either. Where a function changes from one to the
  /// other it may have a kink, and no higher derivatives.
  friend IntervalJet either(const IntervalJet& a, const IntervalJet& b) { return either(a, b, N + 1); }
  friend IntervalJet either_slope(const IntervalJet& a, const IntervalJet& b) { return either(a, b, 1); }

  /// The wider bounds made narrower by what is known at the centre: worth it after a sum in which much cancels.
  IntervalJet& tighten() {
    if (is_thin()) return *this;
    for (std::size_t i = kLowOrders; i-- > 0;) {
      Interval there = at_[i];
      for (std::size_t k = 0; k < N; ++k) {
        const Rise& rise = kRises[i * N + k];
        const double off = radius_[k] * rise.factor;
        there += c_[rise.to] * Interval(-off, off);
      }
      c_[i] = common(c_[i], there);
    }
    return *this;
  }

 private:
  using Coefficients = std::array<Interval, static_cast<std::size_t>(kCount)>;
  static constexpr double kRounding = 1e-15;
  /// Monomials up to the second degree come first: they have derivatives among the others.
  static constexpr std::size_t kLowOrders = static_cast<std::size_t>((N + 1) * (N + 2) / 2);

  /// The derivative of coefficient c_a by variable k is `factor` times coefficient `to`.
  struct Rise {
    std::size_t to = 0;
    double factor = 0;
  };
  static constexpr std::array<Rise, kLowOrders* static_cast<std::size_t>(N)> kRises = [] {
    std::array<Rise, kLowOrders* static_cast<std::size_t>(N)> rises = {};
    for (std::size_t i = 0; i < kLowOrders; ++i)
      for (std::size_t k = 0; k < static_cast<std::size_t>(N); ++k) {
        auto e = detail::kMonomials<N>.exponents[i];
        ++e[k];
        rises[i * N + k] = {static_cast<std::size_t>(detail::kMonomials<N>.index(e)), static_cast<double>(e[k])};
      }
    return rises;
  }();
  static constexpr std::array<std::size_t, static_cast<std::size_t>(N)> kFirst = [] {
    std::array<std::size_t, static_cast<std::size_t>(N)> first = {};
    for (std::size_t k = 0; k < static_cast<std::size_t>(N); ++k) first[k] = kRises[k].to;
    return first;
  }();
  static constexpr std::size_t place(int k, int l) {
    return kRises[kFirst[static_cast<std::size_t>(k)] * N + static_cast<std::size_t>(l)].to;
  }
  static constexpr std::size_t place(int k, int l, int m) {
    return kRises[place(k, l) * N + static_cast<std::size_t>(m)].to;
  }
  static Interval factor(int k, int l) { return Interval(k == l ? 2 : 1); }
  static Interval factor(int k, int l, int m) {
    return Interval(k == l && l == m ? 6 : k == l || l == m || k == m ? 2 : 1);
  }

  /// What is in both of two enclosures of the same.
  static Interval common(const Interval& a, const Interval& b) {
    const Interval both(std::max(a.lo, b.lo), std::min(a.hi, b.hi));
    return both.lo <= both.hi ? both : a;
  }

  static Coefficients along(int k, const Derivatives& f) {
    Coefficients out;
    out[0] = f[0];
    out[kFirst[static_cast<std::size_t>(k)]] = f[1];
    out[place(k, k)] = f[2] / Interval(2);
    out[place(k, k, k)] = f[3] / Interval(6);
    return out;
  }
  static Coefficients derivative(int k, const Coefficients& c) {
    Coefficients out;
    out[0] = c[kFirst[static_cast<std::size_t>(k)]];
    out[kFirst[static_cast<std::size_t>(k)]] = factor(k, k) * c[place(k, k)];
    out[place(k, k)] = Interval(3) * c[place(k, k, k)];
    out[place(k, k, k)] = Interval::all();
    return out;
  }
  static Coefficients product(const Coefficients& a, const Coefficients& b) {
    Coefficients out;
    for (const auto& p : detail::kMonomials<N>.products) {
      const Interval &x = a[static_cast<std::size_t>(p.a)], &y = b[static_cast<std::size_t>(p.b)];
      if ((x.lo == 0 && x.hi == 0) || (y.lo == 0 && y.hi == 0)) continue;
      out[static_cast<std::size_t>(p.to)] += x * y;
    }
    return out;
  }
  static Coefficients composed(const Coefficients& x, const Derivatives& f) {
    Coefficients change = x;
    change[0] = Interval(0);
    const Coefficients change2 = product(change, change), change3 = product(change2, change);
    const Interval half = f[2] / Interval(2), sixth = f[3] / Interval(6);
    Coefficients out;
    out[0] = f[0];
    for (std::size_t i = 1; i < out.size(); ++i) out[i] = f[1] * change[i] + half * change2[i] + sixth * change3[i];
    return out;
  }
  static IntervalJet either(const IntervalJet& a, const IntervalJet& b, std::size_t known) {
    IntervalJet out = unknown();
    out.radius_ = a.radius_;
    out.widen(b);
    for (std::size_t i = 0; i < known; ++i) {
      out.c_[i] = hull(a.c_[i], b.c_[i]);
      out.at_[i] = hull(a.at_[i], b.at_[i]);
    }
    return out;
  }

  bool is_thin() const {
    return std::all_of(radius_.begin(), radius_.end(), [](double r) { return r == 0; });
  }
  void widen(const IntervalJet& o) {
    for (std::size_t k = 0; k < radius_.size(); ++k) radius_[k] = std::max(radius_[k], o.radius_[k]);
  }

  Coefficients c_ = {}, at_ = {};                                ///< over the box, at its centre
  std::array<double, static_cast<std::size_t>(N)> radius_ = {};  ///< of the box, in the variables it depends on
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
  return compose(x, [](const Interval& v) -> std::array<Interval, 4> {
    const Interval f = sqrt(v), r = Interval(1) / v, f1 = Interval(0.5) * f * r, f2 = Interval(-0.5) * f1 * r;
    return {f, f1, f2, Interval(-1.5) * f2 * r};
  });
}
template <int N>
IntervalJet<N> exp(const IntervalJet<N>& x) {
  return compose(x, [](const Interval& v) -> std::array<Interval, 4> {
    const Interval f = exp(v);
    return {f, f, f, f};
  });
}
template <int N>
IntervalJet<N> log(const IntervalJet<N>& x) {
  return compose(x, [](const Interval& v) -> std::array<Interval, 4> {
    const Interval r = Interval(1) / v;
    return {log(v), r, -square(r), Interval(2) * square(r) * r};
  });
}
template <int N>
IntervalJet<N> sin(const IntervalJet<N>& x) {
  return compose(x, [](const Interval& v) -> std::array<Interval, 4> {
    const Interval s = sin(v), c = cos(v);
    return {s, c, -s, -c};
  });
}
template <int N>
IntervalJet<N> cos(const IntervalJet<N>& x) {
  return compose(x, [](const Interval& v) -> std::array<Interval, 4> {
    const Interval s = sin(v), c = cos(v);
    return {c, -s, -c, s};
  });
}
template <int N>
IntervalJet<N> tan(const IntervalJet<N>& x) {
  return compose(x, [](const Interval& v) -> std::array<Interval, 4> {
    const Interval t = tan(v), f1 = Interval(1) + square(t), f2 = Interval(2) * t * f1;
    return {t, f1, f2, Interval(2) * f1 * (Interval(1) + Interval(3) * square(t))};
  });
}
template <int N>
IntervalJet<N> asin(const IntervalJet<N>& x) {
  return compose(x, [](const Interval& v) -> std::array<Interval, 4> {
    const Interval f1 = Interval(1) / sqrt((Interval(1) - v) * (Interval(1) + v)), f12 = square(f1), f13 = f1 * f12;
    return {asin(v), f1, v * f13, (Interval(1) + Interval(2) * square(v)) * f13 * f12};
  });
}
template <int N>
IntervalJet<N> acos(const IntervalJet<N>& x) {
  return compose(x, [](const Interval& v) -> std::array<Interval, 4> {
    const Interval f1 = Interval(1) / sqrt((Interval(1) - v) * (Interval(1) + v)), f12 = square(f1), f13 = f1 * f12;
    return {acos(v), -f1, -(v * f13), -((Interval(1) + Interval(2) * square(v)) * f13 * f12)};
  });
}
template <int N>
IntervalJet<N> atan(const IntervalJet<N>& x) {
  return compose(x, [](const Interval& v) -> std::array<Interval, 4> {
    const Interval f1 = Interval(1) / (Interval(1) + square(v)), f12 = square(f1);
    return {atan(v), f1, Interval(-2) * v * f12, (Interval(6) * square(v) - Interval(2)) * f1 * f12};
  });
}
template <int N>
IntervalJet<N> sinh(const IntervalJet<N>& x) {
  return compose(x, [](const Interval& v) -> std::array<Interval, 4> {
    const Interval s = sinh(v), c = cosh(v);
    return {s, c, s, c};
  });
}
template <int N>
IntervalJet<N> cosh(const IntervalJet<N>& x) {
  return compose(x, [](const Interval& v) -> std::array<Interval, 4> {
    const Interval s = sinh(v), c = cosh(v);
    return {c, s, c, s};
  });
}
template <int N>
IntervalJet<N> tanh(const IntervalJet<N>& x) {
  return compose(x, [](const Interval& v) -> std::array<Interval, 4> {
    const Interval t = tanh(v), f1 = Interval(1) - square(t), f2 = Interval(-2) * t * f1;
    return {t, f1, f2, Interval(-2) * f1 * (Interval(1) - Interval(3) * square(t))};
  });
}
template <int N>
IntervalJet<N> pow(const IntervalJet<N>& x, double p) {
  return compose(x, [p](const Interval& v) -> std::array<Interval, 4> {
    const auto term = [&](double factor, double exponent) {
      return factor == 0 ? Interval(0) : Interval(factor) * pow(v, exponent);
    };
    return {pow(v, p), term(p, p - 1), Interval(p) * term(p - 1, p - 2),
            Interval(p) * Interval(p - 1) * term(p - 2, p - 3)};
  });
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
