// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// The closed curve in which a plane cuts a smooth surface in R^3, as a ring in the coordinates of the surface: of
/// several curves one near to `point`, which lies in the plane. Found by predictor and corrector: a step along the
/// curve, then Newton steps onto the plane, each followed by the surface's own projection, so that it works for level
/// sets, clouds and charts alike. `normal` has length 1.
///
/// Throws InitializationError where no point of the curve is found near `point`, where the curve comes to a bound or to
/// where the surface ends, and where it does not come back; Interrupted past the deadline.
CoordinatePath smooth_section(const ConstraintManifold& surface, const Eigen::Vector3d& point,
                              const Eigen::Vector3d& normal, const Deadline& deadline = {});

}  // namespace leastcost
