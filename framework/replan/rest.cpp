// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/replan/rest.hpp>

#include <algorithm>
#include <cmath>

namespace leastcost {
namespace {

constexpr double kReach = 0.6;   ///< of the longest move: no point keeps farther from what its moves touch
constexpr double kSame = 1e-10;  ///< of the reach, and of a slope

bool same(const NearBound& a, const NearBound& b, double reach) {
  return a.number == b.number && std::abs(a.gap - b.gap) <= kSame * reach && a.slope.size() == b.slope.size() &&
         (a.slope - b.slope).norm() <= kSame * a.slope.norm();
}

}  // namespace

Rest::Rest(const Problem& problem, const CoordinatePath& path) {
  const auto* bounds = find_ability<SeesBounds>(*problem.manifold);
  if (bounds == nullptr || path.ring || path.u.cols() < 2) return;
  cost_ = problem.cost;
  u_ = path.u;
  reach_ = kReach * (u_.rightCols(u_.cols() - 1) - u_.leftCols(u_.cols() - 1)).colwise().norm().maxCoeff();
  beside_.resize(static_cast<std::size_t>(path.free_count()));
  for (Index i = 0; i < path.free_count(); ++i)
    bounds->bounds_within(path, path.free_begin() + i, reach_, beside_[static_cast<std::size_t>(i)]);
}

/// Bounds that have come near do not matter: they push nothing that is clear of them.
bool Rest::holds(const Problem& problem, const CoordinatePath& path) const {
  const auto* bounds = find_ability<SeesBounds>(*problem.manifold);
  if (cost_ == nullptr || bounds == nullptr || problem.cost != cost_ || path.ring || path.u.rows() != u_.rows() ||
      path.u.cols() != u_.cols() || path.u != u_)
    return false;
  std::vector<NearBound> now;
  for (Index i = 0; i < path.free_count(); ++i) {
    const std::vector<NearBound>& before = beside_[static_cast<std::size_t>(i)];
    if (before.empty()) continue;
    bounds->bounds_within(path, path.free_begin() + i, reach_, now);
    for (const NearBound& bound : before)
      if (std::none_of(now.begin(), now.end(), [&](const NearBound& b) { return same(bound, b, reach_); }))
        return false;
  }
  return true;
}

}  // namespace leastcost
