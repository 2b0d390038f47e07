// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <leastcost/framework/numbers/interval.hpp>
#include <leastcost/framework/numbers/monomials.hpp>

namespace leastcost {

/// Polynomials of a degree of three in N variables whose coefficients are known to within a radius, product and sum cut
/// off at that degree. Middles and radii rather than intervals: a product takes three multiplications per pair of
/// terms and no comparison. A coefficient of which nothing is known has the radius infinity. Sound for numbers of any
/// size: what is smaller than kTiny belongs to the radius, so that no product of two underflows. Rump, "Fast and
/// parallel interval arithmetic", BIT 39, 1999.
template <int N>
class BallPolynomial {
 public:
  static constexpr std::size_t kCount = Monomials<N>::kCount;  ///< number of coefficients

  BallPolynomial() : middle_(), radius_() {}

  Interval operator[](std::size_t i) const {
    return radius_[i] == 0 ? Interval(middle_[i]) : detail::outward(middle_[i] - radius_[i], middle_[i] + radius_[i]);
  }
  /// Sets a coefficient to an interval.
  void set(std::size_t i, const Interval& x) {
    const double middle = x.middle();
    store(i, middle, std::max(x.hi - middle, middle - x.lo) * (1 + kEps));
  }
  /// Sets a coefficient to a number.
  void set(std::size_t i, double x) { store(i, x, 0); }
  /// To the part that is also in x.
  void narrow(std::size_t i, const Interval& x) {
    const Interval here = (*this)[i], both(std::max(here.lo, x.lo), std::min(here.hi, x.hi));
    if (both.lo <= both.hi && both.width() < here.width()) set(i, both);
  }
  /// Nothing is known of this coefficient any more.
  void forget(std::size_t i) { store(i, 0, kInfinity); }

  /// Whether a coefficient is exactly 0.
  bool is_zero(std::size_t i) const { return middle_[i] == 0 && radius_[i] == 0; }
  bool is_number(std::size_t i) const { return radius_[i] == 0; }  ///< whether a coefficient has no radius
  /// Greatest absolute value of a coefficient.
  double magnitude(std::size_t i) const { return (std::abs(middle_[i]) + radius_[i]) * (1 + kEps); }

  BallPolynomial& operator+=(const BallPolynomial& o) {
    for (std::size_t i = 0; i < kCount; ++i) add(i, o.middle_[i], o.radius_[i]);
    return *this;
  }
  BallPolynomial& operator-=(const BallPolynomial& o) {
    for (std::size_t i = 0; i < kCount; ++i) add(i, -o.middle_[i], o.radius_[i]);
    return *this;
  }
  BallPolynomial operator-() const {
    BallPolynomial out = *this;
    for (double& middle : out.middle_) middle = -middle;
    return out;
  }
  /// The product with an interval.
  BallPolynomial scaled(const Interval& factor) const {
    const Factor f(factor);
    BallPolynomial out(kUnset);
    for (std::size_t i = 0; i < kCount; ++i) out.store(i, middle_[i] * f.middle, f.radius_of_product(*this, i));
    return out;
  }
  friend BallPolynomial operator*(const BallPolynomial& a, const BallPolynomial& b) { return product<0, 0>(a, b); }

  /// f(x), from f and its first three derivatives at the first coefficient.
  static BallPolynomial composed(const BallPolynomial& x, const std::array<Interval, 4>& f) {
    const BallPolynomial second = product<1, 1>(x, x), third = product<2, 1>(second, x);
    const Factor f1(f[1]), f2(f[2] / Interval(2)), f3(f[3] / Interval(6));
    BallPolynomial out(kUnset);
    out.set(0, f[0]);
    for (std::size_t i = 1; i < kCount; ++i) {
      double middle = x.middle_[i] * f1.middle, radius = f1.radius_of_product(x, i);
      if (kMonomials<N>.degree[i] >= 2) {
        middle += second.middle_[i] * f2.middle;
        radius += f2.radius_of_product(second, i);
      }
      if (kMonomials<N>.degree[i] == 3) {
        middle += third.middle_[i] * f3.middle;
        radius += f3.radius_of_product(third, i);
      }
      out.store(i, middle, radius * (1 + kDotEps));
    }
    return out;
  }

  /// Makes coefficient i narrower where it is known to be within `radius` of that of `o`.
  void narrow(std::size_t i, const BallPolynomial& o, double radius) {
    const double reach = (o.radius_[i] + radius) * (1 + kEps), apart = std::abs(middle_[i] - o.middle_[i]);
    if (!(reach < kInfinity) || radius_[i] + apart <= reach) return;
    if (reach + apart <= radius_[i])
      store(i, o.middle_[i], reach);
    else
      narrow(i, detail::outward(o.middle_[i] - reach, o.middle_[i] + reach));
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr double kEps = std::numeric_limits<double>::epsilon();
  static constexpr double kDotEps = 16 * kEps;  ///< of sums of up to eight products
  static constexpr double kTiny = 1e-140;
  struct Unset {};
  static constexpr Unset kUnset = {};

  explicit BallPolynomial(Unset) {}

  struct Factor {
    double middle, slack, reach;  ///< what a radius grows by, per size and per radius of the other factor

    explicit Factor(const Interval& x) {
      BallPolynomial constant(kUnset);
      constant.set(0, x);
      middle = constant.middle_[0];
      slack = constant.radius_[0] + kDotEps * std::abs(middle);
      reach = constant.radius_[0] + std::abs(middle);
    }
    double radius_of_product(const BallPolynomial& p, std::size_t i) const {
      return (std::abs(p.middle_[i]) * slack + p.radius_[i] * reach) * (1 + kDotEps);
    }
  };

  void store(std::size_t i, double middle, double radius) {
    const double size = std::abs(middle);
    if (!(size >= kTiny && radius >= kTiny && size + radius < kInfinity)) return store_rare(i, middle, radius);
    middle_[i] = middle;
    radius_[i] = radius;
  }
  void store_rare(std::size_t i, double middle, double radius) {
    if (!(std::abs(middle) + radius < kInfinity)) {
      middle = 0;
      radius = kInfinity;
    } else if (std::abs(middle) < kTiny && middle != 0) {
      radius = (radius + std::abs(middle)) * (1 + kEps);
      middle = 0;
    }
    middle_[i] = middle;
    radius_[i] = radius < kTiny && radius != 0 ? kTiny : radius;
  }
  void add(std::size_t i, double middle, double radius) {
    const double sum = middle_[i] + middle;
    store(i, sum, (radius_[i] + radius) * (1 + 2 * kEps) + kEps * std::abs(sum));
  }

  /// Of the terms of a degree of at least LeastA and LeastB.
  template <int LeastA, int LeastB>
  static BallPolynomial product(const BallPolynomial& a, const BallPolynomial& b) {
    std::array<double, kCount> slack_b, reach_b;  // what |a| and the radius of a are multiplied with
    for (std::size_t i = 0; i < kCount; ++i) {
      const double size = std::abs(b.middle_[i]);
      slack_b[i] = b.radius_[i] + kDotEps * size;
      reach_b[i] = b.radius_[i] + size;
    }
    std::array<double, kCount> middle = {}, radius = {};
    const auto add_term = [&]<std::size_t I>(std::integral_constant<std::size_t, I>) {
      constexpr typename Monomials<N>::Product kTerm = kMonomials<N>.products[I];
      if constexpr (kMonomials<N>.degree[kTerm.a] >= LeastA && kMonomials<N>.degree[kTerm.b] >= LeastB) {
        middle[kTerm.to] += a.middle_[kTerm.a] * b.middle_[kTerm.b];
        radius[kTerm.to] += std::abs(a.middle_[kTerm.a]) * slack_b[kTerm.b] + a.radius_[kTerm.a] * reach_b[kTerm.b];
      }
    };
    [&]<std::size_t... I>(std::index_sequence<I...>) { (add_term(std::integral_constant<std::size_t, I>()), ...); }
    (std::make_index_sequence<Monomials<N>::kProducts>());
    BallPolynomial out(kUnset);
    for (std::size_t i = 0; i < kCount; ++i) out.store(i, middle[i], radius[i] * (1 + kDotEps));
    return out;
  }

  std::array<double, kCount> middle_, radius_;
};

}  // namespace leastcost
