// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/post_processors/way_among_obstacles.hpp"

#include <utility>

#include <leastcost/framework/domain/fits_segments.hpp>
#include <leastcost/framework/problem/clearance.hpp>

namespace leastcost {

std::optional<Points> way_among_obstacles(const Problem& problem, const Points& way) {
  constexpr double kPartOfStep = 0.5;
  if (way.cols() < 2) return std::nullopt;
  CoordinatePath placed{way, {}, false};
  std::shared_ptr<const ConstraintManifold> domain = problem.manifold;
  if (const auto* fits = find_ability<FitsSegments>(*domain)) domain = fits->unfitted(placed);  // to another path
  if (!domain->project(placed).failed.empty()) return std::nullopt;
  placed.u.col(0) = problem.source.u;
  placed.u.rightCols(1) = problem.target.u;
  const double step = (way.rightCols(way.cols() - 1) - way.leftCols(way.cols() - 1)).colwise().norm().mean();
  const auto clearance = measure_clearance(*domain, placed.u, false, {});
  if (clearance && clearance->lower < -kPartOfStep * step) return std::nullopt;
  return std::move(placed.u);
}

}  // namespace leastcost
