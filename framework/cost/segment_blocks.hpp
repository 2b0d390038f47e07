// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/cost/segment_derivatives.hpp>
#include <leastcost/framework/path/kernel.hpp>

/// \file
/// From the derivatives of q to those of phi(q / s0^2), one 2d x 2d block per segment. What needs neither the type of
/// the cost nor its dimension is compiled once, in the library: a user's cost does not pay for an eigenvalue solver.

namespace leastcost {

/// The kernel and its derivatives at a squared cost.
inline Jet2 evaluate(const Kernel& kernel, double q) {
  Jet2 jet;
  kernel.apply({&q, 1}, {&jet, 1});
  return jet;
}

namespace detail {

/// h <- scale h + factor g g' over the stacked gradient g = (g.a; g.b).
template <int D>
void scale_and_add_outer(double scale, double factor, const SegmentGradient<D>& g, Eigen::Ref<Points> h) {
  const Index d = D == Eigen::Dynamic ? g.a.size() : D, stride = h.outerStride();
  const auto add = [&](const Point<double, D>& rows, double slope, double* out) {
    for (Index i = 0; i < d; ++i) out[i] = scale * out[i] + factor * rows[i] * slope;
  };
  double* column = h.data();
  for (Index j = 0; j < 2 * d; ++j, column += stride) {
    const double slope = j < d ? g.a[j] : g.b[j - d];
    add(g.a, slope, column);
    add(g.b, slope, column + d);
  }
}

/// h = factor J'J. By loops over compile-time widths: Eigen unrolls such products, which takes seconds to compile.
template <int D, class Jacobian>
void scaled_normal_matrix(double factor, const Jacobian& j, Eigen::Ref<Points> h) {
  if constexpr (D == Eigen::Dynamic) {
    h.noalias() = factor * j.transpose() * j;
  } else {
    for (Index q = 0; q < 2 * D; ++q) {
      for (Index p = 0; p <= q; ++p) {
        double sum = 0;
        for (Index k = 0; k < j.rows(); ++k) sum += j(k, p) * j(k, q);
        h(p, q) = h(q, p) = factor * sum;
      }
    }
  }
}

/// Negative eigenvalues of a symmetric matrix, and those that are zero to rounding, lifted to a little above zero.
void lift_eigenvalues(Eigen::Ref<Points> h);

/// r = (c / |b - a|) (b - a) and its Jacobian, d x 2d, from q and its gradient. Zero, the Jacobian too, where the ends
/// coincide; columns of fixed ends are zero.
using ConstVector = Eigen::Ref<const Eigen::VectorXd>;
void chord_residual(const ConstVector& a, const ConstVector& b, double q, const ConstVector* ga, const ConstVector* gb,
                    Eigen::Ref<Eigen::VectorXd> r, Eigen::Ref<Points> jacobian);

/// lim c(x, x + e v) / e from q(e) = c(x, x + e v)^2 itself: three short moves, extrapolated. About 1e-9 relative.
template <class MoveCost>
double short_move_limit(double size, double speed, MoveCost cost) {
  if (!(speed > 0)) return 0;
  const double e = 2e-4 * (size > 0 ? size : 1) / speed;
  const double f1 = cost(e) / e, f2 = cost(e / 2) / (e / 2), f4 = cost(e / 4) / (e / 4);
  return (f1 - 6 * f2 + 8 * f4) / 3;  // free of the terms of first and second order in e
}

}  // namespace detail

/// A residual r of q, |r|^2 = q, and its Jacobian over (a, b), rows x 2d; columns of fixed ends are zero.
template <int D>
struct SegmentResidual {
  static constexpr int kMost = D == Eigen::Dynamic ? kMaxDimension : D;        ///< rows that a residual has room for
  static constexpr int kWidth = D == Eigen::Dynamic ? Eigen::Dynamic : 2 * D;  ///< columns of the Jacobian: both ends
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMost, 1> r;  ///< the residual: the squared cost is its squared norm
  /// Its derivatives by both ends, a first.
  Eigen::Matrix<double, Eigen::Dynamic, kWidth, 0, kMost, 2 * kMost> jacobian;
};

/// That of the cost itself.
template <class C>
void own_residual(const C& c, const SegmentEnds<C::dim>& e, SegmentResidual<C::dim>& out) {
  constexpr int D = C::dim;
  const Index d = e.a.size();
  if constexpr (D != Eigen::Dynamic) {
    using S = Dual<double, 2 * D>;
    Point<S, D> a, b;
    detail::seed<S, D>(e.a, e.a_fixed, 0, a);
    detail::seed<S, D>(e.b, e.b_fixed, D, b);
    const auto r = c.template residual<S>(a, b);
    out.r.resize(r.size());
    out.jacobian.resize(r.size(), 2 * D);
    for (Index i = 0; i < r.size(); ++i) {
      out.r[i] = r[i].value;
      for (int k = 0; k < 2 * D; ++k) out.jacobian(i, k) = r[i].d[static_cast<std::size_t>(k)];
    }
  } else {
    using S = detail::Dual1;
    Point<S, D> a = detail::constants<S, D>(e.a), b = detail::constants<S, D>(e.b);
    out.r = c.template residual<double>(e.a, e.b);
    out.jacobian.resize(out.r.size(), 2 * d);
    for (Index k = 0; k < 2 * d; ++k) {
      S& x = detail::variable<S, D>(a, b, k);
      x.d[0] = detail::is_fixed(e, k) ? 0 : 1;
      const auto r = c.template residual<S>(a, b);
      for (Index i = 0; i < r.size(); ++i) out.jacobian(i, k) = r[i].d[0];
      x.d[0] = 0;
    }
  }
}

/// q of a segment and its derivatives, whatever the type of the cost. Blocks, residuals and line elements are made from
/// it by code that is compiled once per dimension instead of once per cost; a virtual call is small beside them.
template <int D>
class SegmentFunction {
 public:
  virtual ~SegmentFunction() = default;
  /// Squared cost from a to b.
  virtual double squared_cost(const Point<double, D>& a, const Point<double, D>& b) const = 0;
  /// Squared cost with its first derivatives.
  virtual double gradient(const SegmentEnds<D>& e, SegmentGradient<D>& g) const = 0;
  /// Gradient and Hessian.
  virtual double derivatives(const SegmentEnds<D>& e, SegmentGradient<D>& g, Eigen::Ref<Points> h) const = 0;
  /// d^2/de^2 of q(x, x + e v) at e = 0.
  virtual double second_derivative(const Point<double, D>& x, const Point<double, D>& v) const = 0;
  virtual bool has_residual() const = 0;  ///< whether the squared cost is the squared norm of a residual
  /// The residual with its Jacobian; only where has_residual().
  virtual void residual(const SegmentEnds<D>& e, SegmentResidual<D>& out) const = 0;
};

/// The SegmentFunction of a cost, which must outlive it.
template <class C>
class SegmentFunctionOf final : public SegmentFunction<C::dim> {
 public:
  static constexpr int kDim = C::dim;  ///< dimension of the space; Eigen::Dynamic: any

  explicit SegmentFunctionOf(const C& c) : c_(c) {}

  /// Squared cost from a to b.
  double squared_cost(const Point<double, kDim>& a, const Point<double, kDim>& b) const override {
    return leastcost::squared_cost(c_, a, b);
  }
  /// Squared cost with its first derivatives.
  double gradient(const SegmentEnds<kDim>& e, SegmentGradient<kDim>& g) const override {
    return squared_cost_gradient(c_, e, g);
  }
  /// Squared cost with its first and second derivatives.
  double derivatives(const SegmentEnds<kDim>& e, SegmentGradient<kDim>& g, Eigen::Ref<Points> h) const override {
    return squared_cost_derivatives(c_, e, g, h);
  }
  /// Of the squared cost of a short move along v at x.
  double second_derivative(const Point<double, kDim>& x, const Point<double, kDim>& v) const override {
    if constexpr (requires(const Eigen::VectorXd& any) { c_.line_element(any, any); }) {
      return std::numeric_limits<double>::quiet_NaN();  // never asked for; such a cost may know no duals
    } else {
      using S = detail::Dual11;
      Point<S, kDim> a = detail::constants<S, kDim>(x), b = a;
      for (Index k = 0; k < x.size(); ++k) {
        b[k].value.d[0] = v[k];
        b[k].d[0].value = v[k];
      }
      return c_.template value<S>(a, b).d[0].d[0];
    }
  }
  bool has_residual() const override { return kHasResidual; }
  /// The residual with its Jacobian.
  void residual(const SegmentEnds<kDim>& e, SegmentResidual<kDim>& out) const override {
    if constexpr (kHasResidual) own_residual(c_, e, out);
  }

 private:
  static constexpr bool kHasResidual = requires(const C c, const Point<double, kDim> x) {
    c.template residual<double>(x, x);
  };

  const C& c_;
};

/// Column number i of a path, whose size the compiler knows where the cost says it.
template <int D>
auto column_of(const AmbientPath& path, Index i) {
  return Eigen::Map<const Eigen::Matrix<double, D, 1>>(path.x.data() + path.x.rows() * i, path.x.rows());
}

/// Segment number i. The ends of an open path are constants; a ring has none.
template <int D>
SegmentEnds<D> segment_ends(const AmbientPath& path, Index i) {
  return {column_of<D>(path, i), column_of<D>(path, i + 1), path.begin_fixed() && i == 0,
          path.end_fixed() && i + 1 == path.segment_count()};
}

/// Hessian of phi(q / s0^2): phi' d2q / s0^2 + phi'' dq dq' / s0^4.
template <int D>
void exact_block(const SegmentFunction<D>& c, const SegmentEnds<D>& e, const Kernel& kernel, double s0,
                 Eigen::Ref<Points> h) {
  SegmentGradient<D> g;
  const double scale = 1 / (s0 * s0);
  const Jet2 phi = evaluate(kernel, scale * c.derivatives(e, g, h));
  detail::scale_and_add_outer(phi.d1 * scale, phi.d2 * scale * scale, g, h);
}

/// The residual of the cost, or r = (c / |b - a|) (b - a) where it has none of its own.
template <int D>
void squared_cost_residual(const SegmentFunction<D>& c, const SegmentEnds<D>& e, SegmentResidual<D>& out) {
  if (c.has_residual()) return c.residual(e, out);
  const Index d = e.a.size();
  SegmentGradient<D> g;
  const double q = c.gradient(e, g);
  out.r.resize(d);
  out.jacobian.resize(d, 2 * d);
  const detail::ConstVector ga(g.a), gb(g.b);
  detail::chord_residual(e.a, e.b, q, e.a_fixed ? nullptr : &ga, e.b_fixed ? nullptr : &gb, out.r, out.jacobian);
}

/// Positive semidefinite stand-in for the exact block. With a residual r: 2 phi' J'J + phi'' dq dq', which is
/// semidefinite for every convex increasing H because dq = 2 J'r and q = |r|^2. Without one: the exact block with its
/// negative eigenvalues lifted to zero. phi'' stays a little above the value at which H = s loses its stiffness along
/// the path.
template <int D>
void gauss_newton_block(const SegmentFunction<D>& c, const SegmentEnds<D>& e, const Kernel& kernel, double s0,
                        Eigen::Ref<Points> h) {
  constexpr double kLeastStiffness = 1e-3;
  if (c.has_residual()) {
    SegmentGradient<D> g;
    const double scale = 1 / (s0 * s0);
    const double q = scale * c.gradient(e, g);
    Jet2 phi = evaluate(kernel, q);
    if (q > 0) phi.d2 = std::max(phi.d2, -(1 - kLeastStiffness) * phi.d1 / (2 * q));
    SegmentResidual<D> residual;
    c.residual(e, residual);
    detail::scaled_normal_matrix<D>(2 * phi.d1 * scale, residual.jacobian, h);
    detail::scale_and_add_outer(1, phi.d2 * scale * scale, g, h);
  } else {
    exact_block(c, e, kernel, s0, h);
    detail::lift_eigenvalues(h);
    // A fixed end must stay decoupled although its eigenvalues were lifted.
    const Index d = e.a.size();
    if (e.a_fixed) h.topRows(d).setZero(), h.leftCols(d).setZero();
    if (e.b_fixed) h.bottomRows(d).setZero(), h.rightCols(d).setZero();
  }
}

/// lim c(x, x + e v) / e for e -> 0+: sqrt(v' q_bb v / 2) at a = b = x from one second-order directional dual. Where q
/// is not twice differentiable there (a Finsler cost: |b - a| has no second derivatives), from short moves, to about
/// 1e-9: a cost that says so is not asked, for it may return any number there. +infinity outside the domain of the
/// cost.
template <int D>
double line_element_from_hessian(const SegmentFunction<D>& c, bool quadratic_at_rest, const Point<double, D>& x,
                                 const Point<double, D>& v) {
  if (!(c.squared_cost(x, x) == 0)) return std::numeric_limits<double>::infinity();
  double size = 0, speed = 0;
  for (Index k = 0; k < x.size(); ++k) {
    size = std::max(size, std::abs(x[k]));
    speed = std::max(speed, std::abs(v[k]));
  }
  if (quadratic_at_rest) {
    const double half = c.second_derivative(x, v) / 2;
    if (half >= 0) return std::sqrt(half);
  }
  return detail::short_move_limit(size, speed, [&](double e) {
    Point<double, D> end = x;
    for (Index k = 0; k < x.size(); ++k) end[k] += e * v[k];
    return std::sqrt(c.squared_cost(x, end));
  });
}

/// The members of SegmentCost (framework/cost/segment_cost.hpp) of these names, by a loop over the segments.
template <int D>
void segment_chain_blocks(const SegmentFunction<D>& c, const AmbientPath& path, const Kernel& kernel, double s0,
                          HessianKind kind, int dim, ChainBlocks& out) {
  const Index width = 2 * dim;
  out.blocks.resize(width, width * path.segment_count());
  for (Index i = 0; i < path.segment_count(); ++i) {
    Eigen::Ref<Points> block = out.blocks.middleCols(width * i, width);
    if (kind == HessianKind::exact)
      exact_block(c, segment_ends<D>(path, i), kernel, s0, block);
    else
      gauss_newton_block(c, segment_ends<D>(path, i), kernel, s0, block);
  }
}

/// Residuals of all segments side by side, with their Jacobians where asked for.
template <int D>
void segment_residuals(const SegmentFunction<D>& c, const AmbientPath& path, int dim, Points& r, Points* jacobians) {
  const Index width = 2 * dim;
  SegmentResidual<D> one;
  for (Index i = 0; i < path.segment_count(); ++i) {
    squared_cost_residual(c, segment_ends<D>(path, i), one);
    if (i == 0) {
      r.resize(one.r.size(), path.segment_count());
      if (jacobians != nullptr) jacobians->resize(one.r.size(), width * path.segment_count());
    }
    r.col(i) = one.r;
    if (jacobians != nullptr) jacobians->middleCols(width * i, width) = one.jacobian;
  }
}

// In the library for the usual dimensions (segment_blocks.cpp); of others the compiler makes its own.
extern template void segment_chain_blocks(const SegmentFunction<2>&, const AmbientPath&, const Kernel&, double,
                                          HessianKind, int, ChainBlocks&);
extern template void segment_residuals(const SegmentFunction<2>&, const AmbientPath&, int, Points&, Points*);
extern template void segment_chain_blocks(const SegmentFunction<3>&, const AmbientPath&, const Kernel&, double,
                                          HessianKind, int, ChainBlocks&);
extern template void segment_residuals(const SegmentFunction<3>&, const AmbientPath&, int, Points&, Points*);
extern template void segment_chain_blocks(const SegmentFunction<Eigen::Dynamic>&, const AmbientPath&, const Kernel&,
                                          double, HessianKind, int, ChainBlocks&);
extern template void segment_residuals(const SegmentFunction<Eigen::Dynamic>&, const AmbientPath&, int, Points&,
                                       Points*);

}  // namespace leastcost
