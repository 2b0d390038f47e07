// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/manifold.h>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// One point of a path on the domain, for Ceres: its tangent plane and the domain's own retraction, on a path of one
/// column. A point with blocked directions moves in the others: those of `free`, turned along with the tangent plane.
/// A step that leads where the domain is not (off the band of a grid, beyond the samples of a cloud) is shortened until
/// it lands, or left out: Ceres gives a problem up whose Plus() fails, even for the step -gradient that only measures.
class PointManifold final : public ceres::Manifold {
 public:
  /// free: orthonormal, coordinate x m; without columns: every direction of the tangent plane. stopped: set by a move
  /// that a bound has stopped. Past the deadline no point moves any more (Plus fails, Ceres rejects the step).
  PointManifold(const ConstraintManifold& manifold, Points free, bool& stopped, const Deadline& deadline);

  int AmbientSize() const override { return dims_.coordinate; }
  int TangentSize() const override { return free_.cols() > 0 ? static_cast<int>(free_.cols()) : dims_.tangent; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  bool MinusJacobian(const double* x, double* jacobian) const override;

 private:
  bool is_late() const;
  CoordinatePath at(const double* x) const;
  Points basis(const CoordinatePath& one) const;

  const ConstraintManifold& manifold_;
  Dimensions dims_;
  Points free_;
  bool& stopped_;
  const Deadline& deadline_;
};

}  // namespace leastcost
