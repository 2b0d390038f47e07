// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include <leastcost/framework/base/options.hpp>

namespace leastcost {

/// Corners of a box in coordinates, one number each, possibly infinite; without one it is unbounded there.
struct BoxOptions {
  std::optional<Eigen::VectorXd> lower = {};
  std::optional<Eigen::VectorXd> upper = {};
  bool given() const { return lower || upper; }  ///< whether a bound was given
  void fields(FieldVisitor& visit);
};

/// Bounds on the coordinates of points, some of them possibly infinite.
class Box {
 public:
  /// No bounds.
  explicit Box(int dimension);
  /// Throws OptionError("lower" or "upper") when a side does not fit the dimension or the box is empty.
  Box(int dimension, const BoxOptions& options);

  const Eigen::VectorXd& lower() const { return lower_; }  ///< least coordinates; -inf: none
  const Eigen::VectorXd& upper() const { return upper_; }  ///< greatest coordinates; inf: none
  bool bounded() const { return bounded_; }                ///< whether any bound is finite

  /// Moves every column to the nearest point of the box.
  template <class Columns>
  void clamp(Columns&& x) const {
    if (!bounded_) return;
    for (auto column : x.colwise()) column = column.cwiseMax(lower_).cwiseMin(upper_);
  }
  /// Outward unit normals of the sides that x lies on, as in HasBounds::active_bounds.
  int active(const Eigen::VectorXd& x, Eigen::Ref<Eigen::MatrixXd> normals) const;

 private:
  bool bounded_ = false;
  Eigen::VectorXd lower_, upper_;
};

}  // namespace leastcost
