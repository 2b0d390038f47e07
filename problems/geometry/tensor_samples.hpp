// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "problems/geometry/ball_tree.hpp"
#include "problems/geometry/neighbour_search.hpp"
#include "problems/geometry/surface_samples.hpp"

namespace leastcost {

/// A symmetric 3 x 3 tensor at a place with its derivatives. Entries are those on and above the diagonal, row by row.
struct TensorJet {
  static constexpr int kEntries = 6;
  Eigen::Matrix<double, 6, 1> value;
  Eigen::Matrix<double, 6, 3> gradient;
  Eigen::Matrix<double, 6, 6> hessian;  ///< per entry: xx, xy, xz, yy, yz, zz
  /// Column of the second derivative along axes i and j.
  static constexpr int column(int i, int j) { return i <= j ? i * 3 - i * (i + 1) / 2 + j : column(j, i); }
};

/// A smooth field of symmetric positive definite tensors T(x) in R^3 through tensors T_i given at samples of a surface:
///
///     T(x) = sum_i w_i(x) (T_i + G_i (x - p_i)) / sum_i w_i(x),    w_i(x) = (1 - |x - p_i|^2 / r_i^2)^4,
///
/// r_i the support of the sample, G_i the slope of the tensors around it along the surface, by least squares (a modified Shepard
/// interpolant; Renka, ACM TOMS 14:139). Constant tensors are reproduced exactly, smooth fields to second order in the spacing. A
/// slope is lowered until T_i + G_i y >= T_i / 2 within the support: T(x) is positive definite everywhere. Three
/// times differentiable where some support reaches, which is so near the surface; beyond, the tensor of the nearest sample.
///
/// Samples whose normal turns more than 120 degrees from that of the sample nearest to x belong to another sheet and do not count. Sheets
/// that face the same way, nearer than a support, do share their tensors.
class TensorSamples {
 public:
  /// One tensor per sample, positive definite.
  TensorSamples(const SurfaceSamples& samples, const std::vector<Eigen::Matrix3d>& tensors);

  /// T(x) and its derivatives up to `Order`, 0 to 2; the others are left alone.
  template <int Order>
  void evaluate(const Eigen::Vector3d& x, TensorJet& out) const;

 private:
  struct Sample {
    Eigen::Vector3d position;
    double inverse_radius2;
    Eigen::Matrix<double, 6, 4> polynomial;  ///< T_i, then the slopes along x, y, z
  };

  void fit_slopes(const SurfaceSamples& samples, const std::vector<Eigen::Matrix3d>& tensors);
  void gather(const Eigen::Vector3d& x, std::vector<std::int32_t>& places) const;

  BallTree tree_;
  std::vector<Sample> samples_;           ///< in the order of the tree
  std::vector<Eigen::Vector3d> normals_;  ///< the same; empty: sheets are not told apart
  std::vector<std::int32_t> place_of_;    ///< of a sample as it was given
  NeighbourSearch search_;
};

}  // namespace leastcost
