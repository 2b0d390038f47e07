// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/replan/shortened.hpp"

#include <algorithm>
#include <limits>

namespace leastcost {
namespace {

/// The place of a path nearest to a point.
struct Nearest {
  Index segment = 0;
  double part = 0;  ///< of the segment that lies before it
};

Nearest nearest_place(const CoordinatePath& path, const Eigen::VectorXd& point) {
  Nearest nearest;
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i + 1 < path.u.cols(); ++i) {
    const Eigen::VectorXd way = path.u.col(i + 1) - path.u.col(i), to = point - path.u.col(i);
    const double length = way.squaredNorm(), t = length > 0 ? std::clamp(to.dot(way) / length, 0.0, 1.0) : 0;
    const double distance = (to - t * way).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    nearest = {i, t};
  }
  return nearest;
}

/// Columns begin ... end - 1 remain.
void keep(CoordinatePath& path, Index begin, Index end) {
  path.u = Points(path.u.middleCols(begin, end - begin));
  if (path.sites.empty()) return;
  path.sites = {path.sites.begin() + begin, path.sites.begin() + end};
}

}  // namespace

bool shorten_to_ends(const Problem& problem, CoordinatePath& path) {
  if (path.ring) return false;
  const bool source = path.u.col(0) != problem.source.u;
  const bool target = !problem.ring && path.u.rightCols(1) != problem.target.u;
  // The beginning of the segment that is nearest becomes the source, the end of it the target; where the place is its
  // other end, that point does, for a path has no two points alike.
  constexpr double kSame = 1e-9;
  if (source) {
    const Nearest at = nearest_place(path, problem.source.u);
    const bool passed = at.part >= 1 - kSame && at.segment + 2 < path.u.cols();
    keep(path, at.segment + (passed ? 1 : 0), path.u.cols());
  }
  if (target) {
    const Nearest at = nearest_place(path, problem.target.u);
    const bool passed = at.part <= kSame && at.segment > 0;
    keep(path, 0, at.segment + (passed ? 1 : 2));
  }
  if (source || target) {
    path.u.col(0) = problem.source.u;
    if (!problem.ring) path.u.rightCols(1) = problem.target.u;
    if (!path.sites.empty()) {
      path.sites.front() = problem.source.site;
      if (!problem.ring) path.sites.back() = problem.target.site;
    }
  }
  return source || target;
}

}  // namespace leastcost
