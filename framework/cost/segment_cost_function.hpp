// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include <leastcost/framework/cost/encloses_metric.hpp>
#include <leastcost/framework/cost/segment_blocks.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>

namespace leastcost {

/// Lifts a SegmentCostFunction to the run-level interface. Energy and gradient: one virtual call per path into a typed
/// loop over blocks of segments, one kernel call per block. Blocks, residuals and line elements: one virtual call per
/// segment out of loops that are compiled once per dimension (framework/cost/segment_blocks). No heap for a
/// compile-time dimension. Base: SegmentCost, or a base that adds abilities to it.
template <SegmentCostFunction C, class Base = SegmentCost>
class SegmentCostOf : public Base, public ExplainsInfinity {
 public:
  static constexpr int kDim = C::dim;  ///< dimension of the space; Eigen::Dynamic: any

  explicit SegmentCostOf(C function, int dim = kDim)
      : function_(std::move(function)), traits_(function_.traits()), dim_(dim) {}

  int dim() const override { return dim_; }
  const CostTraits& traits() const override { return traits_; }
  const C& function() const { return function_; }  ///< the function that it was made of

  void squared_costs(const AmbientPath& path, std::span<double> q) const override {
    for (Index i = 0; i < path.segment_count(); ++i)
      q[static_cast<std::size_t>(i)] =
          squared_cost<C>(function_, column_of<kDim>(path, i), column_of<kDim>(path, i + 1));
  }

  double energy_and_gradient(const AmbientPath& path, const Kernel& kernel, double s0,
                             Eigen::Ref<Points> gradient) const override {
    constexpr Index kBlock = kDim == Eigen::Dynamic ? 16 : 64;  // segments per call of the kernel
    std::array<double, kBlock> q;
    std::array<Jet2, kBlock> phi;
    std::array<SegmentGradient<kDim>, kBlock> g;
    gradient.setZero();
    double energy = 0;
    const double scale = 1 / (s0 * s0);
    for (Index begin = 0; begin < path.segment_count(); begin += kBlock) {
      const Index count = std::min(kBlock, path.segment_count() - begin);
      for (Index j = 0; j < count; ++j) {
        q[j] = scale * squared_cost_gradient(function_, segment_ends<kDim>(path, begin + j), g[j]);
      }
      kernel.apply({q.data(), static_cast<std::size_t>(count)}, {phi.data(), static_cast<std::size_t>(count)});
      const Index d = path.x.rows(), stride = gradient.outerStride();
      for (Index j = 0; j < count; ++j) {
        energy += phi[j].value;
        const double slope = scale * phi[j].d1;
        double* const at = gradient.data() + stride * (begin + j);
        for (Index k = 0; k < d; ++k) {
          at[k] += slope * g[j].a[k];
          at[stride + k] += slope * g[j].b[k];
        }
      }
    }
    return std::isnan(energy) ? std::numeric_limits<double>::infinity() : energy;
  }

  void chain_blocks(const AmbientPath& path, const Kernel& kernel, double s0, HessianKind kind,
                    ChainBlocks& out) const override {
    segment_chain_blocks<kDim>(segment(), path, kernel, s0, kind, dim_, out);
  }

  void residuals(const AmbientPath& path, Points& r, Points* jacobians) const override {
    segment_residuals<kDim>(segment(), path, dim_, r, jacobians);
  }

  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const override {
    if constexpr (requires { function_.line_element(x, v); })
      return function_.line_element(x, v);
    else
      return line_element_from_hessian<kDim>(segment(), traits_.quadratic_at_rest, x, v);
  }

  /// That of the function, where it has one: std::string why_infinite(const VectorXd& a, const VectorXd& b) const.
  std::string why_infinite(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const override {
    if constexpr (requires { std::string(function_.why_infinite(a, b)); })
      return function_.why_infinite(a, b);
    else
      return "";
  }

 private:
  SegmentFunctionOf<C> segment() const { return SegmentFunctionOf<C>(function_); }

  C function_;
  CostTraits traits_;
  int dim_;
};

/// A cost in two or three dimensions that says `static constexpr bool encloses = true` is compiled with intervals as
/// well, and its certificates can be proved: what it does with S are the operators and functions of
/// framework/numbers/interval_jet.hpp, and no branch depends on a value but one that returns infinity unless a
/// condition holds, `if (!(speed > S(0.0)))`.
template <class C>
concept EnclosedSegmentCost = SegmentCostFunction<C> && requires {
  requires C::encloses;
  requires C::dim == 2 || C::dim == 3;
};

/// Its metric is half the Hessian of q in the move, at rest.
template <EnclosedSegmentCost C>
class EnclosedSegmentCostOf final : public SegmentCostOf<C>, public EnclosesMetricBy<EnclosedSegmentCostOf<C>> {
 public:
  using SegmentCostOf<C>::SegmentCostOf;

  /// Encloses the metric at x.
  template <class Jet>
  void enclose(std::span<const Jet> x, std::span<Jet> upper) const {
    constexpr int d = C::dim;
    using S = Dual<Dual<Jet, d>, d>;
    Point<S, d> from, to;
    for (int i = 0; i < d; ++i) {
      const auto k = static_cast<std::size_t>(i);
      from[i].value.value = to[i].value.value = x[k];
      to[i].d[k].value = to[i].value.d[k] = Jet(1.0);
    }
    const S q = this->function().template value<S>(from, to);
    const bool defined = this->traits().quadratic_at_rest && q.value.value.value().is_finite();
    std::size_t entry = 0;
    for (std::size_t i = 0; i < d; ++i)
      for (std::size_t j = i; j < d; ++j) upper[entry++] = defined ? q.d[i].d[j].scaled(Interval(0.5)) : Jet::unknown();
  }
};

/// Makes a cost of a function of two points; `dim`: of the space, for functions of any dimension.
template <SegmentCostFunction C>
std::shared_ptr<const SegmentCost> make_segment_cost(C function, int dim = C::dim) {
  if constexpr (EnclosedSegmentCost<C>)
    return std::make_shared<EnclosedSegmentCostOf<C>>(std::move(function), dim);
  else
    return std::make_shared<SegmentCostOf<C>>(std::move(function), dim);
}

}  // namespace leastcost
