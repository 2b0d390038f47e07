// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>

#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/numbers/dual.hpp>

namespace leastcost {

/// Largest ambient dimension of a cost with run-time dimension (no heap in its inner loops).
inline constexpr int kMaxDimension = 64;

template <class S, int D>
using Point = Eigen::Matrix<S, D, 1, 0, D == Eigen::Dynamic ? kMaxDimension : D, 1>;

/// A cost author writes q(a, b) = c(a, b)^2 in [0, +inf] for the straight move a -> b:
///
///     struct Weighted {
///       static constexpr int dim = 2;                                   // 2, 3, or Eigen::Dynamic
///       CostTraits traits() const { return {.unit = "s"}; }
///       template <class S> S value(const Point<S, 2>& a, const Point<S, 2>& b) const { ... }
///     };
///
/// Optional, each replacing what dual numbers would do: `residual(a, b)`, a vector r with |r|^2 = q (its Jacobian gives
/// the Gauss-Newton Hessian); `gradient(a, b, ga, gb)` returning q; `hessian(a, b, H)`, or `derivatives(a, b, ga, gb,
/// H)` returning q where both come cheaper together (H is zero before); `line_element(x, v)`.
template <class C>
concept SegmentCostFunction = requires(const C c, const Point<double, C::dim> p) {
  { c.traits() } -> std::convertible_to<CostTraits>;
  { c.template value<double>(p, p) } -> std::convertible_to<double>;
};

/// The ends of a segment, and which of them are not moved.
template <int D>
struct SegmentEnds {
  Point<double, D> a, b;                  ///< from a to b
  bool a_fixed = false, b_fixed = false;  ///< an end that is not moved has no derivatives
};

/// First derivatives by the ends of a segment.
template <int D>
struct SegmentGradient {
  Point<double, D> a, b;  ///< by each end
};

/// q, with NaN (an argument outside the domain of a root, say) turned into +infinity.
template <class C>
double squared_cost(const C& c, const Point<double, C::dim>& a, const Point<double, C::dim>& b) {
  const double q = c.template value<double>(a, b);
  return q >= 0 ? q : std::numeric_limits<double>::infinity();
}

namespace detail {

/// A fixed point of dimension D as duals: component i carries derivative `first + i` unless the point is fixed.
template <class S, int D>
void seed(const Point<double, D>& x, bool fixed, int first, Point<S, D>& out) {
  out.resize(x.size());
  for (int i = 0; i < x.size(); ++i) {
    out[i] = S(x[i]);
    if (!fixed) out[i].d[static_cast<std::size_t>(first + i)] = decltype(out[i].value)(1.0);
  }
}

template <class S, int D>
Point<S, D> constants(const Point<double, D>& x) {
  Point<S, D> out(x.size());
  for (int i = 0; i < x.size(); ++i) out[i] = S(x[i]);
  return out;
}

/// Variable k of a segment: component k of a, then of b. Fixed ends have none.
template <int D>
bool is_fixed(const SegmentEnds<D>& e, Index k) {
  return k < e.a.size() ? e.a_fixed : e.b_fixed;
}

using Dual1 = Dual<double, 1>;
using Dual11 = Dual<Dual1, 1>;

template <class S, int D>
S& variable(Point<S, D>& a, Point<S, D>& b, Index k) {
  return k < a.size() ? a[k] : b[k - a.size()];
}

/// Hessian of q for a run-time dimension, and the gradient that comes with it: one pair of directions per evaluation,
/// so that no array grows with d. Returns q.
template <class C>
double hessian_by_pairs(const C& c, const SegmentEnds<C::dim>& e, SegmentGradient<C::dim>& g, Eigen::Ref<Points> h) {
  Point<Dual11, C::dim> a = constants<Dual11, C::dim>(e.a), b = constants<Dual11, C::dim>(e.b);
  const Index m = 2 * e.a.size();
  for (Index j = 0; j < m; ++j) {
    if (is_fixed(e, j)) continue;
    variable<Dual11, C::dim>(a, b, j).d[0].value = 1;
    for (Index k = 0; k <= j; ++k) {
      if (is_fixed(e, k)) continue;
      variable<Dual11, C::dim>(a, b, k).value.d[0] = 1;
      const Dual11 q = c.template value<Dual11>(a, b);
      h(j, k) = h(k, j) = q.d[0].d[0];
      (j < e.a.size() ? g.a[j] : g.b[j - e.a.size()]) = q.d[0].value;
      variable<Dual11, C::dim>(a, b, k).value.d[0] = 0;
    }
    variable<Dual11, C::dim>(a, b, j).d[0].value = 0;
  }
  return c.template value<double>(e.a, e.b);
}

/// Hessian of q for a compile-time dimension, and the gradient that comes with it: one evaluation with nested duals.
/// Returns q.
template <class C>
double hessian_nested(const C& c, const SegmentEnds<C::dim>& e, SegmentGradient<C::dim>& g, Eigen::Ref<Points> h) {
  constexpr int D = C::dim, M = 2 * D;
  using Inner = Dual<double, M>;
  using Outer = Dual<Inner, M>;
  Point<Outer, D> a = constants<Outer, D>(e.a), b = constants<Outer, D>(e.b);
  for (int k = 0; k < M; ++k) {
    if (is_fixed(e, k)) continue;
    Outer& x = variable<Outer, D>(a, b, k);
    x.value.d[static_cast<std::size_t>(k)] = 1;
    x.d[static_cast<std::size_t>(k)] = Inner(1.0);
  }
  const Outer q = c.template value<Outer>(a, b);
  for (std::size_t j = 0; j < M; ++j)
    for (std::size_t k = 0; k < M; ++k) h(static_cast<Index>(j), static_cast<Index>(k)) = q.d[j].d[k];
  for (int k = 0; k < D; ++k) {
    g.a[k] = q.value.d[static_cast<std::size_t>(k)];
    g.b[k] = q.value.d[static_cast<std::size_t>(D + k)];
  }
  return q.value.value;
}

/// q and its gradient by dual numbers. g has the size of the ends.
template <class C>
double gradient_by_duals(const C& c, const SegmentEnds<C::dim>& e, SegmentGradient<C::dim>& g) {
  constexpr int D = C::dim;
  if constexpr (D != Eigen::Dynamic) {
    using S = Dual<double, 2 * D>;
    Point<S, D> a, b;
    seed<S, D>(e.a, e.a_fixed, 0, a);
    seed<S, D>(e.b, e.b_fixed, D, b);
    const S value = c.template value<S>(a, b);
    for (int k = 0; k < D; ++k) {
      g.a[k] = value.d[static_cast<std::size_t>(k)];
      g.b[k] = value.d[static_cast<std::size_t>(D + k)];
    }
    return value.value;
  } else {
    using S = Dual1;
    Point<S, D> a = constants<S, D>(e.a), b = constants<S, D>(e.b);
    const double q = c.template value<double>(e.a, e.b);
    for (Index k = 0; k < 2 * e.a.size(); ++k) {
      double& out = k < e.a.size() ? g.a[k] : g.b[k - e.a.size()];
      out = 0;
      if (is_fixed(e, k)) continue;
      S& x = variable<S, D>(a, b, k);
      x.d[0] = 1;
      out = c.template value<S>(a, b).d[0];
      x.d[0] = 0;
    }
    return q;
  }
}

/// h = 0. Where its size is known and it lies in one piece, as in a chain, by a loop without calls.
template <int D>
void clear_block(Eigen::Ref<Points> h) {
  if (D != Eigen::Dynamic && h.outerStride() == 2 * D) {
    double* const all = h.data();
    for (int k = 0; k < 4 * D * D; ++k) all[k] = 0;
  } else {
    h.setZero();
  }
}

}  // namespace detail

/// q and its gradient.
template <class C>
double squared_cost_gradient(const C& c, const SegmentEnds<C::dim>& e, SegmentGradient<C::dim>& g) {
  g.a.resize(e.a.size());
  g.b.resize(e.b.size());
  double q = 0;
  if constexpr (requires { c.gradient(e.a, e.b, g.a, g.b); })
    q = c.gradient(e.a, e.b, g.a, g.b);
  else
    q = detail::gradient_by_duals(c, e, g);
  if (e.a_fixed) g.a.setZero();
  if (e.b_fixed) g.b.setZero();
  return q >= 0 ? q : std::numeric_limits<double>::infinity();
}

/// q, its gradient, and its second derivatives over (a, b) in h, 2d x 2d, from one evaluation where the cost has no
/// derivatives of its own. Rows, columns and slopes of fixed ends are zero.
template <class C>
double squared_cost_derivatives(const C& c, const SegmentEnds<C::dim>& e, SegmentGradient<C::dim>& g,
                                Eigen::Ref<Points> h) {
  const Index d = e.a.size();
  constexpr bool has_gradient = requires { c.gradient(e.a, e.b, g.a, g.b); }
  , has_hessian = requires { c.hessian(e.a, e.b, h); };
  constexpr bool has_both = requires { c.derivatives(e.a, e.b, g.a, g.b, h); };
  g.a.setZero(d);
  g.b.setZero(d);
  detail::clear_block<C::dim>(h);
  double q = 0;
  if constexpr (has_both)
    q = c.derivatives(e.a, e.b, g.a, g.b, h);
  else if constexpr (has_hessian)
    c.hessian(e.a, e.b, h);
  else if constexpr (C::dim == Eigen::Dynamic)
    q = detail::hessian_by_pairs(c, e, g, h);
  else
    q = detail::hessian_nested(c, e, g, h);
  if constexpr (!has_both && (has_gradient || has_hessian)) q = squared_cost_gradient(c, e, g);
  if (e.a_fixed) g.a.setZero(), h.topRows(d).setZero(), h.leftCols(d).setZero();
  if (e.b_fixed) g.b.setZero(), h.bottomRows(d).setZero(), h.rightCols(d).setZero();
  return q >= 0 ? q : std::numeric_limits<double>::infinity();
}

}  // namespace leastcost
