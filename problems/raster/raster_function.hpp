// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include <leastcost/framework/numbers/interval.hpp>
#include "framework/base/gauss.hpp"
#include "problems/raster/raster_patches.hpp"

namespace leastcost {

/// A function of the plane at a place, with its derivatives by x and y.
struct PlaneJet {
  double value = 0;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
};

/// What a function and its derivatives lie between, all over a patch or at a place.
struct PatchBounds {
  Interval value, dx, dy;
};

/// Second derivatives by x and y between bounds.
struct PlaneBends {
  Interval xx, xy, yy;
};

/// Nodes and weights on [0, 1] that integrate a function along any straight line within a patch exactly.
struct PatchQuadrature {
  std::span<const double> nodes, weights;
};

/// A continuous function through or near the values of a raster, a polynomial on each patch. Immutable.
class RasterFunction {
 public:
  virtual ~RasterFunction() = default;
  const RasterPatches& patches() const { return patches_; }
  /// In a patch, at a place in cells, the polynomial of the patch also beside it.
  virtual PlaneJet in_patch(const RasterPatch& patch, double column, double row) const = 0;
  /// Rounded outward.
  virtual PatchBounds bounds(const RasterPatch& patch) const = 0;
  /// The polynomial of a patch at a place, in cells and known up to rounding, also beside the patch. Rounded outward.
  virtual PatchBounds enclose(const RasterPatch& patch, const Interval& column, const Interval& row) const = 0;
  /// Of the polynomial of a patch over a rectangle, in cells, also beside the patch. Rounded outward.
  virtual PlaneBends bends(const RasterPatch& patch, const Interval& column, const Interval& row) const = 0;
  /// Within all patches from one to another. Rounded outward, and wider than their hull by what a patch beyond it adds.
  virtual PlaneBends bends(const RasterPatch& first, const RasterPatch& last) const = 0;
  virtual PatchQuadrature quadrature() const = 0;
  /// Where it is bilinear: the values at (row, column), (row, column + 1), (row + 1, column), (row + 1, column + 1).
  virtual std::optional<std::array<double, 4>> corners(const RasterPatch&) const { return std::nullopt; }

  /// At (x, y); not finite where the function is not known.
  PlaneJet at(double x, double y) const {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    const Eigen::Vector2d place = patches_.in_cells(x, y);
    const std::optional<RasterPatch> patch = patches_.at(place[0], place[1]);
    if (patch) return in_patch(*patch, place[0], place[1]);
    return {kUnknown, Eigen::Vector2d::Constant(kUnknown), Eigen::Matrix2d::Constant(kUnknown)};
  }

 protected:
  explicit RasterFunction(RasterPatches patches) : patches_(std::move(patches)) {}

 private:
  RasterPatches patches_;
};

/// Bilinear between the values: continuous, with kinks at the borders of patches.
class BilinearFunction final : public RasterFunction {
 public:
  /// Throws InputError.
  explicit BilinearFunction(const RasterGrid& raster);
  PlaneJet in_patch(const RasterPatch& patch, double column, double row) const override;
  PatchBounds bounds(const RasterPatch& patch) const override;
  PatchBounds enclose(const RasterPatch& patch, const Interval& column, const Interval& row) const override;
  PlaneBends bends(const RasterPatch& patch, const Interval& column, const Interval& row) const override;
  PlaneBends bends(const RasterPatch& first, const RasterPatch& last) const override;
  PatchQuadrature quadrature() const override;
  std::optional<std::array<double, 4>> corners(const RasterPatch& patch) const override { return values_at(patch); }

 private:
  std::array<double, 4> values_at(const RasterPatch& patch) const;

  int columns_;
  std::vector<double> values_;
};

/// A bicubic spline: twice continuously differentiable, a bicubic polynomial on each patch.
class SplineFunction final : public RasterFunction {
 public:
  /// Through the values. What it needs beyond them (where there are no data) goes on from them, and matters little: 7 %
  /// of a change reach the patches where the spline is known. Throws InputError for fewer than four rows or columns.
  static SplineFunction through(const RasterGrid& raster);
  /// Near the values: they are the coefficients, so that the spline lies between those of the 16 values around a patch.
  /// At a value it is the mean of the nine around it with the weights 1, 4, 1 (squared) / 36. Throws InputError.
  static SplineFunction near(const RasterGrid& raster);

  PlaneJet in_patch(const RasterPatch& patch, double column, double row) const override;
  PatchBounds bounds(const RasterPatch& patch) const override;
  PatchBounds enclose(const RasterPatch& patch, const Interval& column, const Interval& row) const override;
  PlaneBends bends(const RasterPatch& patch, const Interval& column, const Interval& row) const override;
  PlaneBends bends(const RasterPatch& first, const RasterPatch& last) const override;
  PatchQuadrature quadrature() const override { return {kGaussNodes, kGaussWeights}; }

 private:
  SplineFunction(RasterPatches patches, std::vector<double> coefficients);
  const double* coefficients_of(const RasterPatch& patch) const {
    return &coefficients_[static_cast<std::size_t>(patch.row) * width_ + static_cast<std::size_t>(patch.column)];
  }
  PlaneBends scaled(const PlaneBends& in_cells) const;

  std::size_t width_;                 ///< of a row of coefficients: two more than values
  std::vector<double> coefficients_;  ///< one more on every side than values
};

}  // namespace leastcost
