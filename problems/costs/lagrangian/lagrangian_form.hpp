// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

namespace leastcost {

/// What the text of a formula F(x, v) proves about it as a function of v, x held fixed: computed in place of a number,
/// operation by operation. Nothing is claimed that does not follow for all x and v.
struct LagrangianForm {
  /// `root`: a factor without v times the root of a form of second degree, so that F^2 is such a form: a metric.
  enum class Kind { constant, linear, quadratic, root, other };
  enum class Parity { even, odd, none };

  Kind kind = Kind::other;
  double degree = std::numeric_limits<double>::quiet_NaN();  ///< f(l v) = l^degree f(v) for l > 0; NaN: unknown
  Parity parity = Parity::none;                              ///< f(-v) = f(v), or -f(v)
  bool zero = false;

  LagrangianForm() = default;
  LagrangianForm(Kind k, double d, Parity p) : kind(k), degree(d), parity(p) {}
  LagrangianForm(double number)  // NOLINT: numbers convert, as everywhere
      : kind(Kind::constant), degree(0), parity(Parity::even), zero(number == 0) {}
  /// A component of x or v.
  static LagrangianForm position() { return {Kind::constant, 0, Parity::even}; }
  static LagrangianForm velocity() { return {Kind::linear, 1, Parity::odd}; }

  bool is_constant() const { return kind == Kind::constant; }
  bool has_degree() const { return !std::isnan(degree); }
};

namespace detail {

inline LagrangianForm::Parity parity_of_product(LagrangianForm::Parity a, LagrangianForm::Parity b) {
  using P = LagrangianForm::Parity;
  if (a == P::none || b == P::none) return P::none;
  return a == b ? P::even : P::odd;
}
/// A function of something without v has none; of something of degree 0 it has degree 0; otherwise it has no degree.
inline LagrangianForm function_of(const LagrangianForm& x, LagrangianForm::Parity if_odd) {
  using P = LagrangianForm::Parity;
  if (x.is_constant()) return LagrangianForm::position();
  LagrangianForm out;
  if (x.degree == 0) out.degree = 0;
  out.parity = x.parity == P::odd ? if_odd : x.parity;
  return out;
}
/// A function of two, of which nothing is known but that it has no more v than they have.
inline LagrangianForm function_of(const LagrangianForm& x, const LagrangianForm& y) {
  using P = LagrangianForm::Parity;
  if (x.is_constant() && y.is_constant()) return LagrangianForm::position();
  LagrangianForm out;
  if (x.parity == P::even && y.parity == P::even) out.parity = P::even;
  return out;
}

}  // namespace detail

inline LagrangianForm operator-(const LagrangianForm& x) { return x; }
inline LagrangianForm operator+(const LagrangianForm& a, const LagrangianForm& b) {
  if (a.zero) return b;
  if (b.zero) return a;
  using K = LagrangianForm::Kind;
  LagrangianForm out;
  if (a.degree == b.degree) out.degree = a.degree;
  if (a.parity == b.parity) out.parity = a.parity;
  if (a.kind == b.kind && a.kind != K::root) out.kind = a.kind;
  return out;
}
inline LagrangianForm operator-(const LagrangianForm& a, const LagrangianForm& b) { return a + b; }
inline LagrangianForm operator*(const LagrangianForm& a, const LagrangianForm& b) {
  using K = LagrangianForm::Kind;
  if (a.zero || b.zero) return 0.0;
  LagrangianForm out(K::other, a.degree + b.degree, detail::parity_of_product(a.parity, b.parity));
  if (a.is_constant()) out.kind = b.kind;
  if (b.is_constant()) out.kind = a.kind;
  if (a.kind == K::linear && b.kind == K::linear) out.kind = K::quadratic;
  return out;
}
inline LagrangianForm operator/(const LagrangianForm& a, const LagrangianForm& b) {
  if (a.zero) return 0.0;
  return {b.is_constant() ? a.kind : LagrangianForm::Kind::other, a.degree - b.degree,
          detail::parity_of_product(a.parity, b.parity)};
}
inline bool operator<(const LagrangianForm&, const LagrangianForm&) { return false; }

inline LagrangianForm pow(const LagrangianForm& x, double p) {
  using K = LagrangianForm::Kind;
  using P = LagrangianForm::Parity;
  if (x.is_constant() || p == 1) return x;
  if (p == 0) return 1.0;
  LagrangianForm out(K::other, x.degree * p, P::none);
  if (x.parity == P::even) out.parity = P::even;
  if (x.parity == P::odd && std::floor(p) == p) out.parity = std::fmod(p, 2) == 0 ? P::even : P::odd;
  if (p == 2 && (x.kind == K::linear || x.kind == K::root)) out.kind = K::quadratic;
  if (p == 0.5 && x.kind == K::quadratic) out.kind = K::root;
  return out;
}
inline LagrangianForm sqrt(const LagrangianForm& x) { return pow(x, 0.5); }
inline LagrangianForm pow(const LagrangianForm& x, const LagrangianForm& p) {
  LagrangianForm out = detail::function_of(x, p);
  if (x.degree == 0 && p.degree == 0) out.degree = 0;
  return out;
}
inline LagrangianForm pow(double, const LagrangianForm& p) {
  return detail::function_of(p, LagrangianForm::Parity::none);
}

inline LagrangianForm exp(const LagrangianForm& x) { return detail::function_of(x, LagrangianForm::Parity::none); }
inline LagrangianForm log(const LagrangianForm& x) { return exp(x); }
inline LagrangianForm acos(const LagrangianForm& x) { return exp(x); }
inline LagrangianForm sin(const LagrangianForm& x) { return detail::function_of(x, LagrangianForm::Parity::odd); }
inline LagrangianForm tan(const LagrangianForm& x) { return sin(x); }
inline LagrangianForm asin(const LagrangianForm& x) { return sin(x); }
inline LagrangianForm atan(const LagrangianForm& x) { return sin(x); }
inline LagrangianForm sinh(const LagrangianForm& x) { return sin(x); }
inline LagrangianForm tanh(const LagrangianForm& x) { return sin(x); }
inline LagrangianForm cos(const LagrangianForm& x) { return detail::function_of(x, LagrangianForm::Parity::even); }
inline LagrangianForm cosh(const LagrangianForm& x) { return cos(x); }

/// The absolute value of a linear form is the root of its square.
inline LagrangianForm abs(const LagrangianForm& x) {
  using K = LagrangianForm::Kind;
  using P = LagrangianForm::Parity;
  LagrangianForm out = x;
  if (x.parity == P::odd) out.parity = P::even;
  if (!x.is_constant()) out.kind = x.kind == K::linear || x.kind == K::root ? K::root : K::other;
  return out;
}
inline LagrangianForm hypot(const LagrangianForm& x, const LagrangianForm& y) { return sqrt(x * x + y * y); }
inline LagrangianForm atan2(const LagrangianForm& y, const LagrangianForm& x) {
  LagrangianForm out = detail::function_of(y, x);
  if (!out.is_constant() && y.degree == x.degree) out.degree = 0;
  return out;
}
/// The lesser or the greater of both.
inline LagrangianForm one_of(const LagrangianForm& a, const LagrangianForm& b) {
  LagrangianForm out = detail::function_of(a, b);
  if (a.degree == b.degree) out.degree = a.degree;
  return out;
}
inline LagrangianForm lesser(const LagrangianForm& a, const LagrangianForm& b) { return one_of(a, b); }
inline LagrangianForm greater(const LagrangianForm& a, const LagrangianForm& b) { return one_of(a, b); }

// What a formula program calls (problems/formula/formula_program.hpp).
inline void set_sum(LagrangianForm& to, const LagrangianForm& a, const LagrangianForm& b) { to = a + b; }
inline void set_difference(LagrangianForm& to, const LagrangianForm& a, const LagrangianForm& b) { to = a - b; }
inline void set_product(LagrangianForm& to, const LagrangianForm& a, const LagrangianForm& b) {
  using K = LagrangianForm::Kind;
  to = &a == &b && a.kind == K::root ? LagrangianForm(K::quadratic, 2 * a.degree, LagrangianForm::Parity::even) : a * b;
}
inline void set_quotient(LagrangianForm& to, const LagrangianForm& a, const LagrangianForm& b) { to = a / b; }
inline void set_shifted(LagrangianForm& to, const LagrangianForm& a, double c) { to = a + LagrangianForm(c); }
inline void set_scaled(LagrangianForm& to, const LagrangianForm& a, double c) { to = a * LagrangianForm(c); }
inline void set_divided(LagrangianForm& to, const LagrangianForm& a, double) { to = a; }

}  // namespace leastcost
