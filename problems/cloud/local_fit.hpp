// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace leastcost {

/// A quadratic height field over the tangent plane of a neighbourhood.
struct LocalFit {
  bool valid = false;                                ///< false: too few points, or points on a line
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, of either sign, at the foot of the centre
  double height = 0;                                 ///< of the centre over the fitted surface, length units
  double apart =
      0;  ///< part of the neighbours that lie off the fit by more than an eighth of the radius and do not count
  double scale = 0;  ///< robust standard deviation of the residuals, length units
  /// Shape operator at the foot of the centre, on tangent vectors of R^3: k1 t1 t1' + k2 t2 t2' with the principal
  /// curvatures and directions; its sign goes with that of the normal.
  Eigen::Matrix3d shape = Eigen::Matrix3d::Zero();
};

/// Fits neighbours, given as offsets from the centre (which may be among them), by weighted least squares with compact
/// weights of support `radius`, re-weighted by Tukey's biweight on the median absolute residual (three rounds), so that
/// outliers and a few points of another sheet do not count. First frame: principal components.
LocalFit fit_locally(const std::vector<Eigen::Vector3d>& offsets, double radius);

/// The same by plain weighted least squares, without re-weighting, from a normal that is known: every neighbour counts,
/// so that a crease is seen as strong curvature, not as outliers.
LocalFit fit_locally(const std::vector<Eigen::Vector3d>& offsets, double radius, const Eigen::Vector3d& normal);

/// Fewest neighbours of a fit: the six coefficients and two to judge them by.
inline constexpr std::size_t kFewestForFit = 8;

}  // namespace leastcost
