// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <leastcost/problems/distance/grid_shape.hpp>
#include <leastcost/problems/level_set/constraint_function.hpp>

namespace leastcost {

/// A function sampled on a regular grid, between its nodes the tricubic spline through them: twice continuously
/// differentiable, of order 4 where what was sampled is smooth. Coefficients of B-splines are computed once (Unser,
/// Aldroubi, Eden 1993, IEEE PAMI 13:277, here by one tridiagonal solve per line with clamped ends whose slopes come
/// from four nodes); value and gradient then take 64 of them. Not finite outside the grid.
class DistanceGrid final : public ConstraintFunction {
 public:
  /// `values` of all nodes, in the order of GridShape::index. Throws InputError when a value is not finite, when their
  /// number is not that of the nodes, or for fewer than GridShape::kFewest nodes along an axis.
  DistanceGrid(const GridShape& shape, std::vector<double> values);

  int inputs() const override { return 3; }
  int outputs() const override { return 1; }
  void evaluate(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> value,
                Eigen::Ref<Points> gradients) const override;

  bool knows_curvature() const override { return true; }
  void curvature(const Eigen::Ref<const Eigen::VectorXd>& x, const Eigen::Ref<const Eigen::VectorXd>& weights,
                 Eigen::Ref<Points> out) const override;

  /// Value at x, NaN outside the grid, and its gradient.
  double evaluate(const Eigen::Vector3d& x, Eigen::Vector3d& gradient) const;

  const GridShape& shape() const { return shape_; }  ///< nodes and cells
  /// The value that was given at a node, to rounding.
  double at_node(int i, int j, int k) const;
  /// The 4 x 4 x 4 coefficients of B-splines whose sum the function is in the cell after node (i, j, k), x fastest.
  std::array<double, 64> coefficients_of_cell(int i, int j, int k) const;
  /// The grid through every second node. Throws InputError when too few are left.
  DistanceGrid every_second() const;
  /// The same function, `rise` higher: its zeros lie that much farther inside.
  DistanceGrid raised(double rise) const;

 private:
  /// The first nodes of the cell that x lies in and its place there, in cells; false outside the grid.
  bool locate(const Eigen::Vector3d& x, std::array<int, 3>& from, Eigen::Vector3d& place) const;
  std::size_t padded(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * rows_ + static_cast<std::size_t>(j)) * row_ + static_cast<std::size_t>(i);
  }
  void filter();

  GridShape shape_;
  std::size_t row_, rows_;            // of the padded array along x and y
  std::vector<double> coefficients_;  // one more on every side than nodes, x fastest
};

}  // namespace leastcost
