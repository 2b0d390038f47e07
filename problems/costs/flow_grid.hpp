// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include <leastcost/framework/cost/segment_derivatives.hpp>

namespace leastcost {

/// Weights of the values at -1, 0, 1, 2 for a place t between 0 and 1: the quintic whose value and first two
/// derivatives at 0 and 1 are those of the parabolas through the nodes around. Twice continuously differentiable from
/// cell to cell, exact for polynomials of degree 2; a B-spline would need all values, and flows have gaps (land).
template <class S>
std::array<S, 4> quintic_weights(const S& t) {
  const S t2 = t * t, t3 = t2 * t, t4 = t2 * t2, t5 = t4 * t;
  const S one = 10.0 * t3 - 15.0 * t4 + 6.0 * t5;
  const S slope0 = t - 6.0 * t3 + 8.0 * t4 - 3.0 * t5, slope1 = -4.0 * t3 + 7.0 * t4 - 3.0 * t5;
  const S bend0 = 0.5 * (t2 - 3.0 * t3 + 3.0 * t4 - t5), bend1 = 0.5 * (t3 - 2.0 * t4 + t5);
  return {bend0 - 0.5 * slope0, 1.0 - one - 2.0 * bend0 - 0.5 * slope1 + bend1,
          one + 0.5 * slope0 + bend0 - 2.0 * bend1, 0.5 * slope1 + bend1};
}

/// The nodes of an axis that a place between two of them depends on, and their weights. Beyond the ends of the axis the
/// parabola through the last three nodes goes on.
template <class S>
struct AxisStencil {
  Eigen::Index first = 0;
  std::array<S, 4> weights;
  int nodes = 4;
};

template <class S>
AxisStencil<S> axis_stencil(const S& position, Eigen::Index count) {
  const auto cell = std::min(static_cast<Eigen::Index>(std::max(0.0, innermost(position))), count - 2);
  AxisStencil<S> out{cell - 1, quintic_weights<S>(position - static_cast<double>(cell))};
  std::array<S, 4>& w = out.weights;
  if (cell + 2 >= count) {
    w[2] += 3.0 * w[3], w[1] -= 3.0 * w[3], w[0] += w[3];
    out.nodes = 3;
  }
  if (cell == 0) {
    const S before = w[0];
    w[0] = w[1] + 3.0 * before, w[1] = w[2] - 3.0 * before, w[2] = w[3] + before;
    out.first = 0;
    out.nodes = 3;
  }
  return out;
}

/// Velocities at the nodes of a regular grid in D dimensions, with two continuous derivatives between them.
template <int D>
class FlowGrid {
 public:
  static constexpr int dim = D;
  static constexpr Eigen::Index kFewest = 3;  ///< nodes along an axis

  struct Axis {
    double first = 0, step = 1;
    Eigen::Index count = kFewest;
    double last() const { return first + step * static_cast<double>(count - 1); }
  };

  /// `values`: D x nodes, the first axis running fastest; NaN: no value.
  FlowGrid(const std::array<Axis, D>& axes, Points values) : axes_(axes), values_(std::move(values)) {}

  const std::array<Axis, D>& axes() const { return axes_; }

  bool contains(const Point<double, D>& x) const {
    constexpr double kRounding = 1e-9;  // steps
    for (std::size_t k = 0; k < D; ++k) {
      const double room = kRounding * axes_[k].step, at = x[static_cast<Eigen::Index>(k)];
      if (!(at >= axes_[k].first - room && at <= axes_[k].last() + room)) return false;
    }
    return true;
  }

  bool has_value(const Point<double, D>& x) const { return (*this)(x).allFinite(); }

  /// NaN outside, and where a node that counts has no value.
  template <class S>
  Point<S, D> operator()(const Point<S, D>& x) const {
    Point<double, D> place;
    for (Eigen::Index k = 0; k < D; ++k) place[k] = innermost(x[k]);
    if (!contains(place)) return Point<S, D>::Constant(S(std::numeric_limits<double>::quiet_NaN()));
    std::array<AxisStencil<S>, D> stencils;
    for (std::size_t k = 0; k < D; ++k) {
      const S position = (x[static_cast<Eigen::Index>(k)] - axes_[k].first) / axes_[k].step;
      stencils[k] = axis_stencil<S>(position, axes_[k].count);
    }
    Point<S, D> sum = Point<S, D>::Constant(S(0.0));
    add<D - 1>(stencils, S(1.0), 0, sum);
    return sum;
  }

 private:
  /// Axis K and those below it.
  template <int K, class S>
  void add(const std::array<AxisStencil<S>, D>& stencils, const S& weight, Eigen::Index above, Point<S, D>& sum) const {
    const AxisStencil<S>& stencil = stencils[K];
    for (int i = 0; i < stencil.nodes; ++i) {
      const S w = weight * stencil.weights[static_cast<std::size_t>(i)];
      const Eigen::Index node = above * axes_[K].count + stencil.first + i;
      if constexpr (K > 0) {
        add<K - 1>(stencils, w, node, sum);
      } else {
        for (Eigen::Index k = 0; k < D; ++k) sum[k] += w * values_(k, node);
      }
    }
  }

  std::array<Axis, D> axes_;
  Points values_;
};

/// The grid whose nodes are the rows of a table, position then velocity, in any order. `file` is for messages. Throws
/// InputError where the rows are no regular grid.
template <int D>
FlowGrid<D> flow_grid(const Eigen::MatrixXd& rows, const std::string& file);

extern template FlowGrid<2> flow_grid<2>(const Eigen::MatrixXd&, const std::string&);
extern template FlowGrid<3> flow_grid<3>(const Eigen::MatrixXd&, const std::string&);

}  // namespace leastcost
