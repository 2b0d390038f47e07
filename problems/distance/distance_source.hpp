// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/problems/distance/build_progress.hpp>
#include <leastcost/problems/distance/grid_shape.hpp>

namespace leastcost {

/// A surface whose distances can be sampled.
class DistanceSource {
 public:
  virtual ~DistanceSource() = default;
  /// Bounds of the surface, length units.
  virtual Eigen::AlignedBox3d box() const = 0;
  /// Distances at all nodes, negative inside (all positive from a source without sides), in the order of
  /// GridShape::index: exact to rounding up to the distance `exact` from the surface, farther away right to a small
  /// part of a cell. Throws InputError where there is no inside and outside.
  virtual std::vector<double> sample(const GridShape& shape, double exact, const BuildProgress& progress) const = 0;
  /// Cells around the surface in which a grid should have exact distances: splines feel what is wrong k cells away by
  /// 0.27^k of it.
  virtual double exact_cells() const { return 6; }
  /// The point of the surface nearest to x, which is at most a few of its cells away; nothing where it is not found.
  virtual std::optional<Eigen::Vector3d> foot(const Eigen::Vector3d& x) const = 0;
  /// Whether the source is itself a sample of a surface, and has a coarser version: the same surface from half the
  /// data.
  virtual bool is_sample() const { return false; }
  /// The same surface from half the data; null: there is none.
  virtual std::shared_ptr<const DistanceSource> coarser() const { return nullptr; }
  /// Why the source does not say where its surface is near x, with the place; empty: nothing is known against it.
  virtual std::string why_unresolved(const Eigen::Vector3d& x) const {
    static_cast<void>(x);
    return "";
  }
  /// What a user should know about the source.
  virtual std::vector<std::string> notes() const { return {}; }
};

}  // namespace leastcost
