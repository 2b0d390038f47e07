// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <span>
#include <utility>

#include <leastcost/framework/cost/segment_derivatives.hpp>
#include <leastcost/framework/domain/encloses_level_set.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/numbers/dual.hpp>

namespace leastcost {

/// F: R^n -> R^k, k < n, whose zeros are a domain: a surface in space for n = 3, k = 1. Twice differentiable with a
/// Jacobian of full rank on the zeros. Immutable, hence shareable between threads.
class ConstraintFunction {
 public:
  virtual ~ConstraintFunction() = default;
  virtual int inputs() const = 0;   ///< n
  virtual int outputs() const = 0;  ///< k
  /// F(x), k numbers, and the gradients of its components, n x k (the transposed Jacobian).
  virtual void evaluate(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> value,
                        Eigen::Ref<Points> gradients) const = 0;
  /// Whether curvature() says something.
  virtual bool knows_curvature() const { return false; }
  /// sum_j w_j Hess F_j(x), n x n, the w the k numbers of `weights`.
  virtual void curvature(const Eigen::Ref<const Eigen::VectorXd>& x, const Eigen::Ref<const Eigen::VectorXd>& weights,
                         Eigen::Ref<Points> out) const {
    static_cast<void>(x);
    static_cast<void>(weights);
    out.setZero();
  }
  /// F in intervals, of a surface in space; null where only its values are known. Lives as long as this object.
  virtual const LevelSetEnclosure* enclosure() const { return nullptr; }
};

/// Values with first and second derivatives by N coordinates.
template <int N>
using SecondDual = Dual<Dual<double, N>, N>;

/// A place whose coordinates carry both.
template <int N>
Point<SecondDual<N>, N> seeded_twice(const Eigen::Ref<const Eigen::VectorXd>& x) {
  Point<SecondDual<N>, N> at;
  for (int i = 0; i < N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    at[i] = SecondDual<N>(x[i]);
    at[i].value.d[k] = 1;
    at[i].d[k].value = 1;
  }
  return at;
}

/// out = sum_j w_j Hess F_j, from the F_j with their derivatives.
template <int N>
void sum_of_curvatures(std::span<const SecondDual<N>> f, const Eigen::Ref<const Eigen::VectorXd>& weights,
                       Eigen::Ref<Points> out) {
  out.setZero();
  for (std::size_t j = 0; j < f.size(); ++j)
    for (std::size_t p = 0; p < N; ++p)
      for (std::size_t q = 0; q < N; ++q)
        out(static_cast<Index>(q), static_cast<Index>(p)) += weights[static_cast<Index>(j)] * f[j].d[p].d[q];
}

/// Lifts a struct that knows its value; gradients by dual numbers:
///
///     struct Sphere {
///       static constexpr int inputs = 3, outputs = 1;
///       template <class S> S value(const Point<S, 3>& x) const { return x.squaredNorm() - 1.0; }
///     };
///
/// With more than one output, `value` returns a Point<S, outputs>. A surface in space that says `static constexpr bool
/// encloses = true` is compiled with intervals as well (framework/numbers/interval.hpp, interval_jet.hpp), and
/// certificates on it can be proved: what it does with S are the operators and functions of these, and no branch
/// depends on a value.
template <class F>
class ConstraintFunctionOf final : public ConstraintFunction, private LevelSetEnclosure {
 public:
  static constexpr int n = F::inputs, k = F::outputs;  ///< coordinates and constraints

  explicit ConstraintFunctionOf(F function) : function_(std::move(function)) {}
  int inputs() const override { return n; }
  int outputs() const override { return k; }
  void evaluate(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> value,
                Eigen::Ref<Points> gradients) const override {
    using S = Dual<double, n>;
    Point<S, n> at;
    for (int i = 0; i < n; ++i) {
      at[i] = S(x[i]);
      at[i].d[static_cast<std::size_t>(i)] = 1;
    }
    Point<S, k> f;
    if constexpr (k == 1)
      f[0] = function_.template value<S>(at);
    else
      f = function_.template value<S>(at);
    for (int j = 0; j < k; ++j) {
      value[j] = f[j].value;
      for (int i = 0; i < n; ++i) gradients(i, j) = f[j].d[static_cast<std::size_t>(i)];
    }
  }
  bool knows_curvature() const override { return true; }
  void curvature(const Eigen::Ref<const Eigen::VectorXd>& x, const Eigen::Ref<const Eigen::VectorXd>& weights,
                 Eigen::Ref<Points> out) const override {
    const Point<SecondDual<n>, n> at = seeded_twice<n>(x);
    Point<SecondDual<n>, k> f;
    if constexpr (k == 1)
      f[0] = function_.template value<SecondDual<n>>(at);
    else
      f = function_.template value<SecondDual<n>>(at);
    sum_of_curvatures<n>({f.data(), k}, weights, out);
  }
  const LevelSetEnclosure* enclosure() const override { return kEncloses ? this : nullptr; }

 private:
  static constexpr bool kEncloses = n == 3 && k == 1 && requires { requires F::encloses; };

  IntervalJet<3> enclose(std::span<const IntervalJet<3>, 3> x) const override { return value_at(x); }
  Sloped enclose(std::span<const Sloped, 3> x) const override { return value_at(x); }

  template <class S>
  S value_at(std::span<const S, 3> x) const {
    if constexpr (kEncloses)
      return function_.template value<S>(Point<S, 3>(x[0], x[1], x[2]));
    else
      return S();
  }

  F function_;
};

/// Makes constraints of a function with templates for its numbers.
template <class F>
std::shared_ptr<const ConstraintFunction> make_constraint_function(F function) {
  return std::make_shared<ConstraintFunctionOf<F>>(std::move(function));
}

}  // namespace leastcost
