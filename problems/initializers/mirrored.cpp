// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/mirrored.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "framework/domain/in_parts.hpp"

namespace leastcost {
namespace {

/// Mean unit normal of a surface in R^3 at the ends of a path.
Eigen::Vector3d mean_normal(const Problem& problem) {
  CoordinatePath ends{Points(3, 2), {}, false};
  ends.u << problem.source.u, problem.target.u;
  if (problem.source.site != kNoSite) ends.sites = {problem.source.site, problem.target.site};
  Points bases;
  problem.manifold->tangent_bases(ends, bases);
  const auto normal = [&bases](Index i) {
    return Eigen::Vector3d(bases.col(2 * i)).cross(Eigen::Vector3d(bases.col(2 * i + 1)));
  };
  const Eigen::Vector3d a = normal(0), b = normal(1);
  return a.dot(b) < 0 ? Eigen::Vector3d(a - b) : Eigen::Vector3d(a + b);
}

/// Directions that a mirror through both ends keeps, orthonormal columns.
Points kept_directions(const Problem& problem) {
  const Eigen::VectorXd line = problem.target.u - problem.source.u;
  const Dimensions dims = problem.manifold->dimensions();
  Points kept = line.normalized();
  if (dims.coordinate != 3 || dims.tangent != 2) return kept;
  Eigen::Vector3d normal = mean_normal(problem);
  normal -= normal.dot(kept.col(0)) * Eigen::Vector3d(kept.col(0));
  if (normal.norm() < 1e-6)
    throw InitializationError("the path cannot be mirrored: the line between the ends is normal to the surface");
  kept.conservativeResize(Eigen::NoChange, 2);
  kept.col(1) = normal.normalized();
  return kept;
}

double longest_move(const Points& u) {
  return (u.rightCols(u.cols() - 1) - u.leftCols(u.cols() - 1)).colwise().norm().maxCoeff();
}

}  // namespace

MirroredInitializer::MirroredInitializer(std::shared_ptr<const Initializer> original) : original_(std::move(original)) {
  if (!original_) throw InputError("mirrored needs an initializer");
}

FirstPath MirroredInitializer::first_path(const Problem& problem, const Monitor& monitor) const {
  if (problem.ring) throw InitializationError("a ring has no ends and cannot be mirrored");
  if (problem.source.u == problem.target.u)
    throw InitializationError("a loop has no line between its ends and cannot be mirrored");
  FirstPath first = original_->first_path(problem, monitor);
  Points& u = first.path.u;
  if (u.rows() != problem.source.u.size() || u.cols() < 2)
    throw InputError("the path to mirror is " + std::to_string(u.rows()) + " x " + std::to_string(u.cols()));
  const Points kept = kept_directions(problem);
  const double before = longest_move(u);
  const Points off = u.colwise() - problem.source.u;
  u = (2 * (kept * (kept.transpose() * off)) - off).colwise() + problem.source.u;
  first.path.sites.clear();
  const Projection projection = project(*problem.manifold, first.path, monitor.limit());
  if (!projection.failed.empty())
    throw InitializationError("point " + std::to_string(projection.failed.front()) +
                              " of the mirror image has no nearest point on the domain" +
                              reason_for_failure(*problem.manifold, u.col(projection.failed.front())));
  constexpr double kJump = 8;  // times the longest move of the original
  const bool curved = problem.manifold->shape() != Shape::flat;
  if (curved && longest_move(u) > kJump * before)
    throw InitializationError("the mirror image jumps where it is projected onto the domain");
  if (problem.source.site != kNoSite) {
    first.path.sites.front() = problem.source.site;
    first.path.sites.back() = problem.target.site;
  }
  u.col(0) = problem.source.u;
  u.rightCols(1) = problem.target.u;
  return first;
}

}  // namespace leastcost
