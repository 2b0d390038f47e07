// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>

#include <leastcost/framework/numbers/ball_polynomial.hpp>
#include <leastcost/framework/numbers/implicit_function.hpp>
#include <leastcost/framework/numbers/interval.hpp>

namespace leastcost {

/// A function of N variables (two or three) over a box: enclosures of the value and of all derivatives up to the third,
/// over the whole of it and at its centre, as Taylor coefficients. After each operation the mean value theorem bounds
/// what holds over the box by what holds at the centre, so that what cancels there cancels over the box, and bounds are
/// too wide by the square of its size only. Works in place of a number in formulas and in costs that compile with it,
/// and inside Dual.
template <int N>
class IntervalJet {
 public:
  /// Value and first three derivatives of a function of one variable.
  using Derivatives = std::array<Interval, 4>;

  IntervalJet() = default;
  IntervalJet(double constant) {  // NOLINT: numbers convert, as everywhere
    c_.set(0, constant);
    at_ = c_;
  }
  IntervalJet(const Interval& constant) {  // NOLINT
    c_.set(0, constant);
    at_ = c_;
  }

  /// The variable number k, in `range`.
  static IntervalJet variable(const Interval& range, int k) {
    return along(k, range, [](const Interval& x) { return Derivatives{x, 1.0, 0.0, 0.0}; });
  }
  /// A function of variable number k alone, which is in `range`.
  template <class F>
  static IntervalJet along(int k, const Interval& range, const F& derivatives) {
    IntervalJet x;
    x.radius_[static_cast<std::size_t>(k)] = radius(range);
    x.at_ = along(k, derivatives(Interval(range.middle())));
    x.c_ = x.is_thin() ? x.at_ : along(k, derivatives(range));
    x.tighten();
    return x;
  }
  /// A function of which all this is known, over `box` and at its centre.
  static IntervalJet from(const IntervalDerivatives<N>& over_box, const IntervalDerivatives<N>& at_center,
                          const std::array<Interval, static_cast<std::size_t>(N)>& box) {
    IntervalJet x(coefficients(over_box), coefficients(at_center), {});
    for (std::size_t k = 0; k < x.radius_.size(); ++k) x.radius_[k] = radius(box[k]);
    return x.tighten();
  }
  /// A function of which nothing is known.
  static IntervalJet unknown() {
    IntervalJet x;
    for (std::size_t i = 0; i < kCount; ++i) x.c_.forget(i);
    x.at_ = x.c_;
    return x;
  }

  Interval value() const { return c_[0]; }                                   ///< enclosure of the value over the box
  Interval d(int k) const { return c_[first(k)]; }                           ///< of a first derivative
  Interval d(int k, int l) const { return factor(k, l) * c_[place(k, l)]; }  ///< of a second derivative
  Interval d(int k, int l, int m) const { return factor(k, l, m) * c_[place(k, l, m)]; }  ///< of a third derivative
  /// The same at the centre of the box.
  Interval value_at_center() const { return at_[0]; }
  Interval d_at_center(int k) const { return at_[first(k)]; }  ///< of a first derivative at the centre of the box
  /// Of a second derivative at the centre of the box.
  Interval d_at_center(int k, int l) const { return factor(k, l) * at_[place(k, l)]; }
  /// All of them, over the box.
  IntervalDerivatives<N> derivatives() const {
    IntervalDerivatives<N> out;
    out.value = value();
    for (int k = 0; k < N; ++k) {
      const auto a = static_cast<std::size_t>(k);
      out.first[a] = d(k);
      for (int l = 0; l < N; ++l) {
        const auto b = static_cast<std::size_t>(l);
        out.second[a][b] = d(k, l);
        for (int m = 0; m < N; ++m) out.third[a][b][static_cast<std::size_t>(m)] = d(k, l, m);
      }
    }
    return out;
  }

  /// The derivative of a function of variable k alone; its own third derivative is unknown.
  IntervalJet derivative(int k) const { return {derivative(k, c_), derivative(k, at_), radius_}; }
  /// The product with an interval.
  IntervalJet scaled(const Interval& factor) const {
    if (factor.lo == 0 && factor.hi == 0) return {};
    const Coefficients at = at_.scaled(factor);
    return {is_thin() ? at : c_.scaled(factor), at, radius_};
  }

  IntervalJet& operator+=(const IntervalJet& o) {
    c_ += o.c_;
    at_ += o.at_;
    widen(o);
    return *this;
  }
  IntervalJet& operator-=(const IntervalJet& o) {
    c_ -= o.c_;
    at_ -= o.at_;
    widen(o);
    return *this;
  }
  IntervalJet& operator*=(const IntervalJet& o) { return *this = *this * o; }
  IntervalJet& operator/=(const IntervalJet& o) { return *this = *this * reciprocal(o); }
  IntervalJet operator-() const { return {-c_, -at_, radius_}; }

  friend IntervalJet operator+(IntervalJet a, const IntervalJet& b) { return a += b; }
  friend IntervalJet operator-(IntervalJet a, const IntervalJet& b) { return a -= b; }
  friend IntervalJet operator*(const IntervalJet& a, const IntervalJet& b) {
    if (a.is_constant()) return b.scaled(a.c_[0]);
    if (b.is_constant()) return a.scaled(b.c_[0]);
    const bool thin = a.is_thin() && b.is_thin();
    const Coefficients at = a.at_ * b.at_;
    IntervalJet out(thin ? at : a.c_ * b.c_, at, a.radius_);
    out.widen(b);
    out.tighten();
    return out;
  }
  friend IntervalJet operator/(const IntervalJet& a, const IntervalJet& b) { return a * reciprocal(b); }
  friend bool operator<(const IntervalJet& a, const IntervalJet& b) { return a.value() < b.value(); }
  friend bool operator>(const IntervalJet& a, const IntervalJet& b) { return b < a; }
  friend bool operator<=(const IntervalJet& a, const IntervalJet& b) { return a.value() <= b.value(); }
  friend bool operator>=(const IntervalJet& a, const IntervalJet& b) { return b <= a; }

  /// Whether it has no derivatives.
  bool is_constant() const {
    for (std::size_t i = 1; i < kCount; ++i)
      if (!c_.is_zero(i)) return false;
    return c_.is_number(0);
  }

  friend IntervalJet square(const IntervalJet& x) {
    IntervalJet out = x * x;
    out.c_.narrow(0, square(x.c_[0]));
    out.at_.narrow(0, square(x.at_[0]));
    return out;
  }
  /// f(x), where `derivatives` of an interval encloses f and its first three derivatives over it.
  template <class F>
  friend IntervalJet compose(const IntervalJet& x, const F& derivatives) {
    const Coefficients at = Coefficients::composed(x.at_, derivatives(x.at_[0]));
    IntervalJet out(x.is_thin() ? at : Coefficients::composed(x.c_, derivatives(x.c_[0])), at, x.radius_);
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
    out.c_.set(0, angle);
    out.at_.set(0, atan2(y.at_[0], x.at_[0]));
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
      double off = 0;
      for (std::size_t k = 0; k < N; ++k) {
        const Rise& rise = kRises[i * N + k];
        off += radius_[k] == 0 ? 0 : radius_[k] * rise.factor * c_.magnitude(rise.to);
      }
      c_.narrow(i, at_, off * (1 + kRounding));
    }
    return *this;
  }

 private:
  using Coefficients = BallPolynomial<N>;
  using Radii = std::array<double, static_cast<std::size_t>(N)>;
  static constexpr std::size_t kCount = Coefficients::kCount;
  static constexpr double kRounding = 4e-15;
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
        auto e = kMonomials<N>.exponents[i];
        ++e[k];
        rises[i * N + k] = {kMonomials<N>.index(e), static_cast<double>(e[k])};
      }
    return rises;
  }();
  static constexpr std::size_t first(int k) { return kRises[static_cast<std::size_t>(k)].to; }
  static constexpr std::size_t place(int k, int l) { return kRises[first(k) * N + static_cast<std::size_t>(l)].to; }
  static constexpr std::size_t place(int k, int l, int m) {
    return kRises[place(k, l) * N + static_cast<std::size_t>(m)].to;
  }
  static Interval factor(int k, int l) { return Interval(k == l ? 2 : 1); }
  static Interval factor(int k, int l, int m) {
    return Interval(k == l && l == m ? 6 : k == l || l == m || k == m ? 2 : 1);
  }

  IntervalJet(const Coefficients& over_box, const Coefficients& at_center, const Radii& radius)
      : c_(over_box), at_(at_center), radius_(radius) {}

  static double radius(const Interval& range) {
    const double middle = range.middle();
    return std::max(range.hi - middle, middle - range.lo) * (1 + kRounding);
  }
  static Coefficients coefficients(const IntervalDerivatives<N>& f) {
    Coefficients out;
    out.set(0, f.value);
    for (int k = 0; k < N; ++k) {
      const auto a = static_cast<std::size_t>(k);
      out.set(first(k), f.first[a]);
      for (int l = k; l < N; ++l) {
        const auto b = static_cast<std::size_t>(l);
        out.set(place(k, l), f.second[a][b] / factor(k, l));
        for (int m = l; m < N; ++m)
          out.set(place(k, l, m), f.third[a][b][static_cast<std::size_t>(m)] / factor(k, l, m));
      }
    }
    return out;
  }
  static Coefficients along(int k, const Derivatives& f) {
    Coefficients out;
    out.set(0, f[0]);
    out.set(first(k), f[1]);
    out.set(place(k, k), f[2] / Interval(2));
    out.set(place(k, k, k), f[3] / Interval(6));
    return out;
  }
  static Coefficients derivative(int k, const Coefficients& c) {
    Coefficients out;
    out.set(0, c[first(k)]);
    out.set(first(k), factor(k, k) * c[place(k, k)]);
    out.set(place(k, k), Interval(3) * c[place(k, k, k)]);
    out.forget(place(k, k, k));
    return out;
  }
  static IntervalJet either(const IntervalJet& a, const IntervalJet& b, std::size_t known) {
    IntervalJet out = unknown();
    out.radius_ = a.radius_;
    out.widen(b);
    for (std::size_t i = 0; i < known; ++i) {
      out.c_.set(i, hull(a.c_[i], b.c_[i]));
      out.at_.set(i, hull(a.at_[i], b.at_[i]));
    }
    return out;
  }

  bool is_thin() const {
    return std::all_of(radius_.begin(), radius_.end(), [](double r) { return r == 0; });
  }
  void widen(const IntervalJet& o) {
    for (std::size_t k = 0; k < radius_.size(); ++k) radius_[k] = std::max(radius_[k], o.radius_[k]);
  }

  Coefficients c_, at_;  ///< over the box, at its centre
  Radii radius_ = {};    ///< of the box, in the variables it depends on
};

namespace detail {
template <int N>
struct IsIntervalBased<IntervalJet<N>> : std::true_type {};
}  // namespace detail

template <int N>
Interval range_of(const IntervalJet<N>& x) {
  return x.value();
}

template <int N>
double innermost(const IntervalJet<N>& x) {
  return innermost(x.value());
}
/// Whether it has no derivatives.
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
