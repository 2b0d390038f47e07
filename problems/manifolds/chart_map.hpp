// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

#include <leastcost/framework/numbers/dual.hpp>
#include <leastcost/framework/numbers/interval_jet.hpp>
#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// The embedding x(u, v) of a surface in R^3 with its derivatives, VFCS Eq. (12). Immutable.
class ChartMap {
 public:
  virtual ~ChartMap() = default;
  virtual Eigen::Vector3d position(const Eigen::Vector2d& u) const = 0;  ///< place in space of coordinates
  /// The same with the columns dx/du, dx/dv.
  virtual Eigen::Vector3d position(const Eigen::Vector2d& u, Eigen::Matrix<double, 3, 2>& jacobian) const = 0;
  /// Columns dx/du, dx/dv alone.
  Eigen::Matrix<double, 3, 2> jacobian(const Eigen::Vector2d& u) const {
    Eigen::Matrix<double, 3, 2> j;
    position(u, j);
    return j;
  }
  /// Hessian of w . x(u, v).
  virtual Eigen::Matrix2d curvature(const Eigen::Vector2d& u, const Eigen::Vector3d& w) const = 0;
  /// Position and Jacobian, the latter row by row, in intervals: see EnclosesChart.
  virtual void enclose(std::span<const IntervalJet<2>, 2> u, std::span<IntervalJet<2>, 3> x,
                       std::span<IntervalJet<2>, 6> jacobian) const = 0;
};

/// Lifts a struct with `template <class S> Eigen::Matrix<S, 3, 1> operator()(const S& u, const S& v) const`; the
/// derivatives come from dual numbers.
template <class Function>
class ChartMapOf final : public ChartMap {
 public:
  explicit ChartMapOf(Function function) : function_(std::move(function)) {}

  Eigen::Vector3d position(const Eigen::Vector2d& u) const override { return function_(u[0], u[1]); }

  Eigen::Vector3d position(const Eigen::Vector2d& u, Eigen::Matrix<double, 3, 2>& jacobian) const override {
    using S = Dual<double, 2>;
    const Eigen::Matrix<S, 3, 1> x = function_(S(u[0], {1, 0}), S(u[1], {0, 1}));
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 2; ++k) jacobian(i, k) = x[i].d[static_cast<std::size_t>(k)];
    return {x[0].value, x[1].value, x[2].value};
  }

  Eigen::Matrix2d curvature(const Eigen::Vector2d& u, const Eigen::Vector3d& w) const override {
    using Inner = Dual<double, 2>;
    using S = Dual<Inner, 2>;
    const S first(Inner(u[0], {1, 0}), {Inner(1.0), Inner(0.0)}), second(Inner(u[1], {0, 1}), {Inner(0.0), Inner(1.0)});
    const Eigen::Matrix<S, 3, 1> x = function_(first, second);
    Eigen::Matrix2d h = Eigen::Matrix2d::Zero();
    for (int i = 0; i < 3; ++i)
      for (std::size_t p = 0; p < 2; ++p)
        for (std::size_t q = 0; q < 2; ++q) h(static_cast<Index>(p), static_cast<Index>(q)) += w[i] * x[i].d[p].d[q];
    return h;
  }

  void enclose(std::span<const IntervalJet<2>, 2> u, std::span<IntervalJet<2>, 3> x,
               std::span<IntervalJet<2>, 6> jacobian) const override {
    using Jet = IntervalJet<2>;
    using S = Dual<Jet, 2>;
    const Eigen::Matrix<S, 3, 1> at = function_(S(u[0], {Jet(1.0), Jet(0.0)}), S(u[1], {Jet(0.0), Jet(1.0)}));
    for (std::size_t i = 0; i < 3; ++i) {
      const S& xi = at[static_cast<Index>(i)];
      x[i] = xi.value;
      for (std::size_t k = 0; k < 2; ++k) jacobian[2 * i + k] = xi.d[k];
    }
  }

 private:
  Function function_;
};

/// Makes a map of a function with templates for its numbers.
template <class Function>
std::shared_ptr<const ChartMap> make_chart_map(Function function) {
  return std::make_shared<ChartMapOf<Function>>(std::move(function));
}

}  // namespace leastcost
