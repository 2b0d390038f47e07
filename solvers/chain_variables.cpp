// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/chain_variables.hpp>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "solvers/first_move.hpp"
#include "solvers/free_move.hpp"

namespace leastcost {
namespace {

constexpr double kDifference = 6e-6;  ///< of the extent: rounding and truncation of a central difference balance

}  // namespace

bool ChainVariables::centre(const CoordinatePath& path) {
  base_ = path;
  if (!model_.evaluate(energy_, base_)) return false;
  model_.solve(energy_, base_, HessianKind::gauss_newton);
  if (scale_ == 0) scale_ = first_scale();
  return true;
}

double ChainVariables::first_scale() const {
  const Index k = energy_.problem().manifold->dimensions().tangent;
  const double longest = model_.tangent.reshaped(k, base_.free_count()).colwise().norm().maxCoeff();
  const double scale = std::sqrt(kFirstMove * mean_segment(base_) / longest);  // a step -S g in z is one of -S^2 g
  return std::isfinite(scale) && scale > 0 ? scale : 1;
}

Points ChainVariables::steps(const Eigen::VectorXd& z) const {
  Eigen::VectorXd t = z;
  if (scaling_ == Preconditioner::chain)
    model_.system.solve_upper(t);
  else
    t *= scale_;
  Points step;
  energy_.from_tangent(model_.frames, t, step);
  return step;
}

bool ChainVariables::path_at(const Eigen::VectorXd& z, CoordinatePath& path) {
  energy_.count({.projections = 1});
  return move_freely(*energy_.problem().manifold, base_, steps(z), path, energy_.deadline());
}

void ChainVariables::pull_back(const Eigen::VectorXd& z, const Points& path_gradient, Eigen::VectorXd& gradient) {
  to_tangent(z, path_gradient, gradient);
  if (scaling_ == Preconditioner::chain)
    model_.system.solve_lower(gradient);
  else
    gradient *= scale_;
}

/// T' dR' g. In a flat space or a chart dR is the identity, on a polyhedron the frames at x0 stand for those of the
/// piece; elsewhere dR by central differences along the tangent directions, all points at once.
void ChainVariables::to_tangent(const Eigen::VectorXd& z, const Points& path_gradient, Eigen::VectorXd& gradient) {
  const ConstraintManifold& manifold = *energy_.problem().manifold;
  if (manifold.shape() != Shape::smooth || find_ability<HasChart>(manifold) != nullptr)
    return energy_.to_tangent(model_.frames, path_gradient, gradient);
  const Index k = manifold.dimensions().tangent, n = base_.free_count(), first = base_.free_begin();
  const double h = kDifference * extent_of(base_.u);
  const Points step = steps(z);
  gradient.resize(k * n);
  Points moved(step.rows(), n);
  for (Index p = 0; p < k; ++p) {
    for (const double sign : {1.0, -1.0}) {
      for (Index i = 0; i < n; ++i) moved.col(i) = step.col(i) + sign * h * model_.frames.bases.col(k * i + p);
      energy_.retract(base_, moved, sign > 0 ? plus_ : minus_);
    }
    for (Index i = 0; i < n; ++i) {
      const bool blocked = p >= k - model_.frames.blocked[static_cast<std::size_t>(i)];
      gradient[k * i + p] =
          blocked ? 0 : path_gradient.col(i).dot(plus_.u.col(first + i) - minus_.u.col(first + i)) / (2 * h);
    }
  }
}

double ChainVariables::turned(const CoordinatePath& path) const {
  const ConstraintManifold& manifold = *energy_.problem().manifold;
  if (manifold.shape() == Shape::flat || find_ability<HasChart>(manifold) != nullptr) return 1;
  Points there;
  manifold.tangent_bases(path, there);
  const Index k = manifold.dimensions().tangent, first = base_.free_begin();
  double least = 1;
  for (Index i = 0; i < base_.free_count(); ++i) {
    const Points overlap = model_.frames.bases.middleCols(k * i, k).transpose() * there.middleCols(k * (first + i), k);
    least = std::min(least, overlap.jacobiSvd().singularValues().minCoeff());
  }
  return least;
}

}  // namespace leastcost
