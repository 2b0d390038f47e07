// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/domain/manifold.hpp>

#include <algorithm>
#include <limits>

namespace leastcost {

Points positions(const ConstraintManifold& manifold, const CoordinatePath& path) {
  const auto* chart = find_ability<HasChart>(manifold);
  if (chart == nullptr) return path.u;
  Points x;
  chart->embed(path, x);
  return x;
}

std::string reason_for_failure(const ConstraintManifold& manifold, const Eigen::VectorXd& x) {
  const auto* domain = find_ability<ExplainsProjection>(manifold);
  return domain == nullptr ? "" : ": " + domain->why_not_projected(x);
}

void prepare_like(const CoordinatePath& from, CoordinatePath& to) {
  to.u.resize(from.u.rows(), from.u.cols());
  to.ring = from.ring;
  to.sites = from.sites;
  to.closing = from.closing;
  if (from.ring) return;
  to.u.col(0) = from.u.col(0);
  to.u.rightCols(1) = from.u.rightCols(1);
}

Projection EmbeddedManifold::project(CoordinatePath& path) const {
  Projection result;
  for (Index i = 0; i < path.u.cols(); ++i) {
    const Eigen::VectorXd before = path.u.col(i);
    if (project_point(path.u.col(i)))
      result.moved = std::max(result.moved, (path.u.col(i) - before).norm());
    else
      result.failed.push_back(i);
  }
  return result;
}

void EmbeddedManifold::tangent_bases(const CoordinatePath& path, Points& bases) const {
  const int k = dimensions_.tangent;
  bases.resize(path.u.rows(), k * path.u.cols());
  for (Index i = 0; i < path.u.cols(); ++i) tangent_basis(path.u.col(i), bases.middleCols(k * i, k));
}

void EmbeddedManifold::retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  prepare_like(from, to);
  const Index first = from.free_begin();
  for (Index i = 0; i < step.cols(); ++i) {
    to.u.col(first + i) = from.u.col(first + i) + step.col(i);
    // Where there is no nearest point the trial point stays off the domain, and its infinite cost rejects the step.
    if (!project_point(to.u.col(first + i))) to.u.col(first + i).setConstant(std::numeric_limits<double>::quiet_NaN());
  }
}

double EmbeddedManifold::residual(const CoordinatePath& path) const {
  CoordinatePath projected = path;
  const Projection projection = project(projected);
  return projection.failed.empty() ? projection.moved : std::numeric_limits<double>::infinity();
}

}  // namespace leastcost
