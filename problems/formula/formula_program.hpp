// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <leastcost/framework/numbers/dual.hpp>
#include <leastcost/framework/numbers/interval.hpp>

namespace leastcost {

/// What one step of a formula does with its operands a, b (registers) and c (a number).
enum class FormulaOp : std::uint8_t {
  constant,  // c
  variable,  // never in a program: variables are in the first registers from the start
  negate,    // -a
  add,
  subtract,
  multiply,
  divide,
  add_constant,    // a + c
  constant_minus,  // c - a
  times_constant,  // a c
  over_constant,   // a / c
  constant_over,   // c / a
  power,           // a^b
  power_constant,  // a^c
  constant_power,  // c^a
  sqrt,
  exp,
  log,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  sinh,
  cosh,
  tanh,
  abs,
  atan2,
  hypot,
  min,
  max
};

struct FormulaStep {
  FormulaOp op = FormulaOp::constant;
  std::uint8_t to = 0, a = 0, b = 0;  ///< registers
  double c = 0;
};

namespace detail {

// Arithmetic writes its result where it is to stand: a result that is returned is put together piece by piece and then
// copied as a whole, and the copy waits for the pieces. `to` is none of the operands.
inline void set_sum(double& to, double a, double b) { to = a + b; }
inline void set_difference(double& to, double a, double b) { to = a - b; }
inline void set_product(double& to, double a, double b) { to = a * b; }
inline void set_quotient(double& to, double a, double b) { to = a / b; }
inline void set_shifted(double& to, double a, double c) { to = a + c; }
inline void set_scaled(double& to, double a, double c) { to = a * c; }
inline void set_divided(double& to, double a, double c) { to = a / c; }

template <IntervalBased S>
void set_sum(S& to, const S& a, const S& b) {
  to = a + b;
}
template <IntervalBased S>
void set_difference(S& to, const S& a, const S& b) {
  to = a - b;
}
/// The square of an interval is less than the product of two that are the same.
template <IntervalBased S>
void set_product(S& to, const S& a, const S& b) {
  if (&a == &b)
    to = square(a);
  else
    to = a * b;
}
template <IntervalBased S>
void set_quotient(S& to, const S& a, const S& b) {
  to = a / b;
}
template <IntervalBased S>
void set_shifted(S& to, const S& a, double c) {
  to = a + S(c);
}
template <IntervalBased S>
void set_scaled(S& to, const S& a, double c) {
  to = a * S(c);
}
template <IntervalBased S>
void set_divided(S& to, const S& a, double c) {
  to = a / S(c);
}

template <class S>
S lesser(const S& a, const S& b) {
  if constexpr (IntervalBased<S>) return min(a, b);
  return b < a ? b : a;
}
template <class S>
S greater(const S& a, const S& b) {
  if constexpr (IntervalBased<S>) return max(a, b);
  return a < b ? b : a;
}

template <class S, int N>
void set_sum(Dual<S, N>& to, const Dual<S, N>& a, const Dual<S, N>& b) {
  set_sum(to.value, a.value, b.value);
  for (std::size_t k = 0; k < N; ++k) set_sum(to.d[k], a.d[k], b.d[k]);
}
template <class S, int N>
void set_difference(Dual<S, N>& to, const Dual<S, N>& a, const Dual<S, N>& b) {
  set_difference(to.value, a.value, b.value);
  for (std::size_t k = 0; k < N; ++k) set_difference(to.d[k], a.d[k], b.d[k]);
}
template <class S, int N>
void set_product(Dual<S, N>& to, const Dual<S, N>& a, const Dual<S, N>& b) {
  set_product(to.value, a.value, b.value);
  for (std::size_t k = 0; k < N; ++k) to.d[k] = a.d[k] * b.value + a.value * b.d[k];
}
template <class S, int N>
void set_quotient(Dual<S, N>& to, const Dual<S, N>& a, const Dual<S, N>& b) {
  set_quotient(to.value, a.value, b.value);
  for (std::size_t k = 0; k < N; ++k) to.d[k] = (a.d[k] - to.value * b.d[k]) / b.value;
}
template <class S, int N>
void set_shifted(Dual<S, N>& to, const Dual<S, N>& a, double c) {
  set_shifted(to.value, a.value, c);
  for (std::size_t k = 0; k < N; ++k) to.d[k] = a.d[k];
}
template <class S, int N>
void set_scaled(Dual<S, N>& to, const Dual<S, N>& a, double c) {
  set_scaled(to.value, a.value, c);
  for (std::size_t k = 0; k < N; ++k) set_scaled(to.d[k], a.d[k], c);
}
template <class S, int N>
void set_divided(Dual<S, N>& to, const Dual<S, N>& a, double c) {
  set_divided(to.value, a.value, c);
  for (std::size_t k = 0; k < N; ++k) set_divided(to.d[k], a.d[k], c);
}

/// One step on values of type S: double, or dual numbers of any nesting.
template <class S>
void apply(FormulaOp op, S& to, const S& a, const S& b, double c) {
  using std::sqrt, std::exp, std::log, std::sin, std::cos, std::tan, std::asin, std::acos, std::atan, std::sinh,
      std::cosh, std::tanh, std::abs, std::atan2, std::hypot, std::pow;
  switch (op) {
    case FormulaOp::variable: return;
    case FormulaOp::add: return set_sum(to, a, b);
    case FormulaOp::subtract: return set_difference(to, a, b);
    case FormulaOp::multiply: return set_product(to, a, b);
    case FormulaOp::divide: return set_quotient(to, a, b);
    case FormulaOp::negate: return set_scaled(to, a, -1);
    case FormulaOp::add_constant: return set_shifted(to, a, c);
    case FormulaOp::times_constant: return set_scaled(to, a, c);
    case FormulaOp::over_constant: return set_divided(to, a, c);
    case FormulaOp::constant: to = S(c); return;
    case FormulaOp::constant_minus: to = S(c) - a; return;
    case FormulaOp::constant_over: to = S(c) / a; return;
    case FormulaOp::power: to = pow(a, b); return;
    case FormulaOp::power_constant: to = pow(a, c); return;
    case FormulaOp::constant_power: to = pow(c, a); return;
    case FormulaOp::sqrt: to = sqrt(a); return;
    case FormulaOp::exp: to = exp(a); return;
    case FormulaOp::log: to = log(a); return;
    case FormulaOp::sin: to = sin(a); return;
    case FormulaOp::cos: to = cos(a); return;
    case FormulaOp::tan: to = tan(a); return;
    case FormulaOp::asin: to = asin(a); return;
    case FormulaOp::acos: to = acos(a); return;
    case FormulaOp::atan: to = atan(a); return;
    case FormulaOp::sinh: to = sinh(a); return;
    case FormulaOp::cosh: to = cosh(a); return;
    case FormulaOp::tanh: to = tanh(a); return;
    case FormulaOp::abs: to = abs(a); return;
    case FormulaOp::atan2: to = atan2(a, b); return;
    case FormulaOp::hypot: to = hypot(a, b); return;
    case FormulaOp::min: to = lesser(a, b); return;
    case FormulaOp::max: to = greater(a, b); return;
  }
}

}  // namespace detail

/// A formula as a flat list of steps over a few registers, the variables in the first of them. Immutable.
class FormulaProgram {
 public:
  static constexpr int kMaxRegisters = 192;  ///< variables and intermediate values alive at the same time
  static constexpr int kMaxSteps = 4096;

  FormulaProgram() = default;
  FormulaProgram(int inputs, std::vector<FormulaStep> steps, std::vector<std::uint8_t> outputs)
      : inputs_(inputs), steps_(std::move(steps)), outputs_(std::move(outputs)) {}

  int inputs() const { return inputs_; }
  int outputs() const { return static_cast<int>(outputs_.size()); }
  std::size_t steps() const { return steps_.size(); }

  /// No heap: the registers are on the stack, and only those that the formula needs are ever touched.
  template <class S>
  void run(std::span<const S> in, std::span<S> out) const {
    static_assert(std::is_trivially_copyable_v<S>);
    assert(static_cast<int>(in.size()) == inputs_ && out.size() == outputs_.size());
    alignas(S) std::array<std::byte, sizeof(S) * kMaxRegisters> storage;
    S* const r = static_cast<S*>(static_cast<void*>(storage.data()));
    std::copy(in.begin(), in.end(), r);
    for (const FormulaStep& s : steps_) detail::apply<S>(s.op, r[s.to], r[s.a], r[s.b], s.c);
    for (std::size_t i = 0; i < outputs_.size(); ++i) out[i] = r[outputs_[i]];
  }

 private:
  int inputs_ = 0;
  std::vector<FormulaStep> steps_;
  std::vector<std::uint8_t> outputs_;  ///< registers
};

}  // namespace leastcost
