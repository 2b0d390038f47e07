// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include <leastcost/problems/tensor/surface_samples.hpp>

namespace leastcost {

/// Shape operators of a surface at its samples, k1 t1 t1' + k2 t2 t2' as 3 x 3 matrices (1 / length), by quadratic fits
/// to the samples within `radius` local spacings, on the same sheet. Where these are too few or lie on a line the
/// radius grows, up to four times; where that does not help (loose points, degenerate faces) the surface counts as
/// flat. Converges on smooth surfaces with the spacing; a crease shows as a curvature of about its angle over the
/// radius.
std::vector<Eigen::Matrix3d> shape_operators(const SurfaceSamples& samples, double radius);

/// The metric of surface and normals together, ds^2 = |dx|^2 + weight^2 |dn|^2: M = I + weight^2 (k1^2 t1 t1' + k2^2 t2
/// t2'), the first plus the third fundamental form (isophotic, feature-sensitive: Pottmann et al., GMP 2004). `weight`
/// is a length.
std::vector<Eigen::Matrix3d> isophotic_metric(const std::vector<Eigen::Matrix3d>& shapes, double weight);

}  // namespace leastcost
