// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include <leastcost/problems/level_set/constraint_function.hpp>
#include "problems/drawing/surroundings.hpp"

namespace leastcost {

/// A function of the plane or of space on a regular grid over a box, corners included. Values are taken near its zeros
/// only: where the signs of a coarser grid change, and one coarse cell around; elsewhere they are NaN.
class LevelSamples {
 public:
  /// `cells` along the longest side.
  LevelSamples(const ConstraintFunction& function, const Surroundings& box, int cells);

  int dimension() const { return static_cast<int>(count_.size()); }
  int nodes(int axis) const { return count_[axis]; }
  double cell() const { return cell_; }
  double value(const Eigen::VectorXi& node) const { return values_[index(node)]; }
  Eigen::VectorXd position(const Eigen::VectorXi& node) const { return origin_ + cell_ * node.cast<double>(); }
  std::size_t index(const Eigen::VectorXi& node) const;

  /// One point per cell that the level set passes through: the mean of the crossings of its edges (Gibson 1998, surface
  /// nets).
  struct Net {
    std::vector<Eigen::VectorXd> points;
    std::vector<Eigen::VectorXi> cells;  ///< lower corner of the cell of each point
    std::vector<int> point_of_cell;      ///< by index of the lower corner; -1: none
  };
  Net net() const;
  bool crossed(const Eigen::VectorXi& a, const Eigen::VectorXi& b) const;

 private:
  static constexpr int kBlock = 4;  ///< cells of the fine grid along one of the coarse
  void evaluate_near_zeros(const ConstraintFunction& function);
  std::vector<char> active_blocks(const ConstraintFunction& function, const Eigen::VectorXi& blocks) const;

  Eigen::VectorXd origin_;
  Eigen::VectorXi count_;
  double cell_ = 0;
  std::vector<double> values_;
};

/// A box that shows the level set around a path: all of it where it is closed and not much larger, else the part beside
/// the path.
struct LevelRegion {
  Surroundings box;
  bool whole = false;
};
LevelRegion level_region(const ConstraintFunction& function, const Surroundings& path);

/// Moves points onto the domain; `keep` tells those that got there by less than `reach`. Others lie beyond a bound.
std::vector<char> settle(const ConstraintManifold& manifold, std::vector<Eigen::VectorXd>& points, double reach);

}  // namespace leastcost
