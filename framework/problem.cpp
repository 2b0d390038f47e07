// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/problem.hpp"

#include <sstream>

#include "framework/errors.hpp"

namespace leastcost {
namespace {

std::string text(const Eigen::VectorXd& x) {
  std::ostringstream out;
  out.precision(17);
  out << '(';
  for (Index i = 0; i < x.size(); ++i) out << (i ? ", " : "") << x[i];
  out << ')';
  return out.str();
}

void check_end(const PathEnd& end, const char* which, int dim) {
  if (end.u.size() != dim)
    throw InputError(std::string(which) + ": " + std::to_string(end.u.size()) + " coordinates, the domain has " +
                     std::to_string(dim));
  if (!end.u.allFinite()) throw InputError(std::string(which) + " " + text(end.u) + ": coordinates must be finite");
}

}  // namespace

PathEnd project_end(const ConstraintManifold& manifold, const Eigen::VectorXd& point, double* moved) {
  const Dimensions dims = manifold.dimensions();
  if (point.size() != dims.coordinate)
    throw InputError("point " + text(point) + " has " + std::to_string(point.size()) + " coordinates, the domain has " +
                     std::to_string(dims.coordinate));
  if (!point.allFinite()) throw InputError("point " + text(point) + ": coordinates must be finite");
  CoordinatePath path{point, {}, true};
  const Projection projection = manifold.project(path);
  if (!projection.failed.empty())
    throw InputError("point " + text(point) + " has no nearest point on the domain" +
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
    throw InputError("the cost works in " + std::to_string(problem.cost->dim()) + " dimensions, the domain lies in " +
                     std::to_string(dims.ambient));
  if (!problem.ring || problem.based) check_end(problem.source, "source", dims.coordinate);
  if (problem.ring) return;
  check_end(problem.target, "target", dims.coordinate);
  if (problem.source.u == problem.target.u && !problem.based)
    throw InputError("source and target coincide at " + text(problem.source.u) +
                     "; a closed path is a ring (path.ring: true)");
}

}  // namespace leastcost
