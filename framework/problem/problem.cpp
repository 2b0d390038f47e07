// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/problem/problem.hpp>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/counted.hpp"
#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

void check_end(const PathEnd& end, const char* which, int dim) {
  if (end.u.size() != dim)
    throw InputError(std::string(which) + ": " + std::to_string(end.u.size()) + " coordinates, but the domain has " +
                     std::to_string(dim));
  if (!end.u.allFinite())
    throw InputError(std::string(which) + " " + point_text(end.u, 17) + ": coordinates must be finite");
}

}  // namespace

PathEnd project_end(const ConstraintManifold& manifold, const Eigen::VectorXd& point, double* moved) {
  const Dimensions dims = manifold.dimensions();
  if (point.size() != dims.coordinate)
    throw InputError("point " + point_text(point, 17) + " has " + std::to_string(point.size()) +
                     " coordinates, but the domain has " + std::to_string(dims.coordinate));
  if (!point.allFinite()) throw InputError("point " + point_text(point, 17) + ": coordinates must be finite");
  CoordinatePath path{point, {}, true};
  const Projection projection = manifold.project(path);
  if (!projection.failed.empty())
    throw InputError("point " + point_text(point, 17) + " has no nearest point on the domain" +
                     reason_for_failure(manifold, point));
  if (moved) *moved = projection.moved;
  return {path.u.col(0), path.site(0)};
}

void pin_ends(const Problem& problem, CoordinatePath& path) {
  if (path.ring || path.u.cols() < 2) return;
  path.u.col(0) = problem.source.u;
  path.u.rightCols(1) = problem.target.u;
}

void check(const Problem& problem) {
  if (!problem.manifold || !problem.cost || !problem.kernel)
    throw InputError("a problem needs a manifold, a cost and a kernel");
  const Dimensions dims = problem.manifold->dimensions();
  if (problem.cost->dim() != dims.ambient)
    throw InputError("the cost is defined in " + counted(problem.cost->dim(), "dimension") +
                     ", but the domain lies in " + std::to_string(dims.ambient));
  if (!problem.ring || problem.based) check_end(problem.source, "source", dims.coordinate);
  if (problem.ring) return;
  check_end(problem.target, "target", dims.coordinate);
  if (problem.source.u == problem.target.u && problem.source.site == problem.target.site && !problem.based)
    throw InputError("source and target coincide at " + point_text(problem.source.u, 17) +
                     "; for a closed path, use a ring (path.ring: true)");
}

}  // namespace leastcost
