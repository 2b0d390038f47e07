// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <leastcost/framework/path/path.hpp>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// Layers of constant index, one above the other, between planes (lines in the plane) that may dip. Interface k is
/// normal_k . x = offset_k; layer k lies above interface k - 1 and below interface k, on the side from which normal k
/// points away. Where two interfaces have crossed, so that a point would be above the upper and below the lower one,
/// there is no layer. An interface itself costs the lower index of the layers beside it.
class LayerStack {
 public:
  /// normals: d x K, any length but 0; offsets: K; indices: K + 1, cost of a unit of length, greater than 0. K >= 1, d
  /// >= 2. Throws OptionError (keys "normals", "interfaces", "indices") for what does not fit.
  LayerStack(const Eigen::MatrixXd& normals, const Eigen::VectorXd& offsets, Eigen::VectorXd indices);

  int dimension() const { return static_cast<int>(normals_.rows()); }   ///< of the space
  int interfaces() const { return static_cast<int>(offsets_.size()); }  ///< number of interfaces
  int layers() const { return interfaces() + 1; }                       ///< number of layers
  double index(int layer) const { return indices_[layer]; }             ///< of refraction of a layer
  const Eigen::VectorXd& indices() const { return indices_; }           ///< of refraction of all layers
  auto normal(int k) const { return normals_.col(k); }                  ///< of length one, but for rounding
  double offset(int k) const { return offsets_[k]; }                    ///< of an interface along its normal
  /// Orthonormal vectors along interface k, d x (d - 1).
  const Eigen::MatrixXd& tangents(int k) const { return tangents_[static_cast<std::size_t>(k)]; }
  /// Whether all normals are one.
  bool is_parallel() const { return parallel_; }

  /// Above interface k, negative below it.
  double height(int k, const Eigen::VectorXd& x) const { return normals_.col(k).dot(x) - offsets_[k]; }
  /// Whether x is on interface k, to what rounding makes of its coordinates.
  bool lies_on(int k, const Eigen::VectorXd& x) const;
  /// The layer that holds x; of a point on interfaces the lowest one that touches it. Null where interfaces have
  /// crossed.
  std::optional<int> layer_of(const Eigen::VectorXd& x) const;
  /// The layers that touch x: one, or on interfaces those beside them. Empty where interfaces have crossed.
  std::vector<int> layers_at(const Eigen::VectorXd& x) const;
  /// The layer of the straight leg a -> b, which crosses no interface: along one it is the faster layer beside it. Null
  /// where it does cross one, or there is no layer.
  std::optional<int> layer_of_leg(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;

 private:
  Eigen::MatrixXd normals_;
  Eigen::VectorXd offsets_, indices_;
  std::vector<Eigen::MatrixXd> tangents_;
  bool parallel_ = false;
};

}  // namespace leastcost
