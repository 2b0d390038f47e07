// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/base/dense_solves.hpp"
#include "framework/domain/in_parts.hpp"

namespace leastcost {
namespace {

constexpr Index kPointsAtOnce = 256;  ///< points between two looks at the clock

/// Turns an orthonormal basis so that its last columns span `directions` (its first `count` columns, projected onto the
/// basis); returns how many independent ones there are.
int turn_to_end(Eigen::Ref<Points> basis, const Points& directions, int count) {
  const Index k = basis.cols();
  const Points inside = basis.transpose() * directions.leftCols(count);
  const auto [q, rank] = ranked_factor(inside, 1e-9);
  Points turned(basis.rows(), k);
  turned.leftCols(k - rank) = basis * q.rightCols(k - rank);
  turned.rightCols(rank) = basis * q.leftCols(rank);
  basis = turned;
  return rank;
}

/// Keeps, among the active bounds with outward normals N, those that a descent along -g would push through: the
/// least-squares multipliers of -g = N lambda, dropping the most negative one until all are positive.
int keep_pushed(Points& normals, int count, const Eigen::VectorXd& descent) {
  while (count > 0) {
    const Eigen::VectorXd lambda = least_squares(normals.leftCols(count), descent);
    Index worst = 0;
    if (lambda.minCoeff(&worst) > 0) break;
    normals.col(worst) = normals.col(count - 1);
    --count;
  }
  return count;
}

}  // namespace

void PathEnergy::frames(const CoordinatePath& path, const Points& gradient, Frames& out) {
  const auto* bounds = find_ability<HasBounds>(*problem_->manifold);
  const int k = dims_.tangent, d = dims_.coordinate;
  const Index n = path.free_count(), first = path.free_begin();
  out.blocked.assign(static_cast<std::size_t>(n), 0);
  // Only a point on a bound, or the pin of a ring, needs a frame of its own on a flat domain.
  Points normals(d, d);
  std::vector<std::pair<Index, Points>> turned;
  for (Index i = 0; bounds && i < n; ++i) {
    if (i % kPointsAtOnce == 0) look_at_clock(deadline_);
    int count = bounds->active_bounds(path, first + i, normals);
    if (count > 0) count = keep_pushed(normals, count, -gradient.col(i));
    if (count > 0) turned.emplace_back(i, normals.leftCols(count));
  }
  const bool cartesian = chart_ || problem_->manifold->shape() == Shape::flat;
  out.identity = cartesian && turned.empty() && !path.ring;
  if (out.identity) {
    lift(path, out);
    return;
  }

  Points all;
  tangent_bases(*problem_->manifold, path, all, deadline_);
  out.bases = all.middleCols(k * first, k * n);
  for (const auto& [i, outward] : turned)
    out.blocked[static_cast<std::size_t>(i)] =
        turn_to_end(out.bases.middleCols(k * i, k), outward, static_cast<int>(outward.cols()));
  // E is all but invariant under sliding every point of a ring along it: pin x_0 (docs/numerics.md Sec. 3.5).
  if (path.ring && n > 1 && out.blocked[0] < k) {
    const Points along = (path.column(1) - path.column(-1)).normalized();
    if (along.allFinite()) out.blocked[0] += turn_to_end(out.bases.leftCols(k - out.blocked[0]), along, 1);
  }
  lift(path, out);
}

void PathEnergy::lift(const CoordinatePath& path, Frames& out) {
  if (!chart_) return;
  const int d = dims_.coordinate;
  const Index n = path.free_count(), first = path.free_begin();
  const Points& j = chart_jacobians(path);
  out.lifted = j.middleCols(d * first, d * n);
  if (out.identity) return;
  for (Index i = 0; i < n; ++i)
    out.lifted.middleCols(d * i, d).noalias() =
        j.middleCols(d * (first + i), d).lazyProduct(out.bases.middleCols(d * i, d));
}

}  // namespace leastcost
