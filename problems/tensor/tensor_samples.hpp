// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include <leastcost/problems/cloud/neighbour_search.hpp>
#include <leastcost/problems/tensor/ball_tree.hpp>
#include <leastcost/problems/tensor/surface_samples.hpp>

namespace leastcost {

/// A symmetric 3 x 3 tensor at a place with its derivatives. Entries are those on and above the diagonal, row by row.
struct TensorJet {
  static constexpr int kEntries = 6;     ///< of a symmetric 3 x 3 matrix
  Eigen::Matrix<double, 6, 1> value;     ///< xx, xy, xz, yy, yz, zz
  Eigen::Matrix<double, 6, 3> gradient;  ///< its derivatives by place
  Eigen::Matrix<double, 6, 6> hessian;   ///< per entry: xx, xy, xz, yy, yz, zz
  /// Column of the second derivative along axes i and j.
  static constexpr int column(int i, int j) { return i <= j ? i * 3 - i * (i + 1) / 2 + j : column(j, i); }
};

/// A smooth field of symmetric positive definite tensors T(x) in R^3 through tensors T_i given at samples of a surface:
///
///     T(x) = sum_i w_i(x) (T_i + G_i y_i) / sum_i w_i(x),    w_i(x) = (1 - y_i' Q_i y_i)^4,    y_i = x - p_i.
///
/// Q_i is the ellipsoid of the sample's support, half as thick along its normal as it is wide. G_i is the slope of the
/// tensors around the sample along the surface, by least squares (a modified Shepard interpolant; Renka, ACM TOMS
/// 14:139). Constant tensors are reproduced exactly, smooth fields to second order in the spacing. A slope is lowered
/// until T_i + G_i y >= T_i / 2 within the support: T(x) is positive definite everywhere. Three times differentiable
/// where some support reaches, which is so near the surface; beyond, constant: the tensor of the nearest sample.
///
/// Sheets nearer than half a support (0.8 spacings of a mesh, 1 of a cloud) share their tensors to some part: choosing
/// among them, by the normal of the nearest sample say, would make the field jump where the surface is rough.
class TensorSamples {
 public:
  /// One tensor per sample, positive definite.
  TensorSamples(const SurfaceSamples& samples, const std::vector<Eigen::Matrix3d>& tensors);

  /// T(x) and its derivatives up to `Order`, 0 to 2; the others may hold anything. Asked again for the same x a thread
  /// gets what it got, because segments share their ends.
  template <int Order>
  void evaluate(const Eigen::Vector3d& x, TensorJet& out) const;

 private:
  struct Sample {
    Eigen::Vector3d position, normal;
    double across, along;                    ///< Q = across I + along n n'
    Eigen::Matrix<double, 6, 4> polynomial;  ///< T_i, then the slopes along x, y, z
  };

  template <int Order>
  void interpolate(const Eigen::Vector3d& x, TensorJet& out) const;
  void fit_slopes(const SurfaceSamples& samples, const std::vector<Eigen::Matrix3d>& tensors);

  std::uint64_t id_;  ///< of all that this process makes
  BallTree tree_;
  std::vector<Sample> samples_;         ///< in the order of the tree
  std::vector<std::int32_t> place_of_;  ///< of a sample as it was given
  NeighbourSearch search_;
};

}  // namespace leastcost
