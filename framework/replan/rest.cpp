// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/replan/rest.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <leastcost/framework/domain/has_box.hpp>

namespace leastcost {
namespace {

constexpr double kReach = 0.6;   ///< of the longest move: no point keeps farther from what its moves touch
constexpr double kSame = 1e-10;  ///< of the reach, and of a slope

bool same(const NearBound& a, const NearBound& b, double reach) {
  return a.number == b.number && std::abs(a.gap - b.gap) <= kSame * reach && a.slope.size() == b.slope.size() &&
         (a.slope - b.slope).norm() <= kSame * a.slope.norm();
}

bool is_same(const Points& a, const Points& b) { return a.rows() == b.rows() && a.cols() == b.cols() && a == b; }

/// Empty: none.
std::pair<Eigen::VectorXd, Eigen::VectorXd> box_of(const ConstraintManifold& manifold) {
  const auto* box = find_ability<HasBox>(manifold);
  if (box == nullptr) return {};
  return {box->box_lower(), box->box_upper()};
}

bool is_among(const std::vector<int>& numbers, int number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

}  // namespace

Rest::Rest(const Problem& problem, const CoordinatePath& path, const SolvedChain& solved) {
  const auto* bounds = find_ability<SeesBounds>(*problem.manifold);
  if (bounds == nullptr || path.ring || path.u.cols() < 2) return;
  cost_ = problem.cost;
  u_ = path.u;
  reach_ = kReach * (u_.rightCols(u_.cols() - 1) - u_.leftCols(u_.cols() - 1)).colwise().norm().maxCoeff();
  std::tie(lower_, upper_) = box_of(*problem.manifold);
  const auto count = static_cast<std::size_t>(path.free_count());
  const auto& resting = solved.margins.resting;
  const bool known = resting.size() == count && is_same(path.u, solved.path.u);
  beside_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (known && resting[i].empty()) continue;
    bounds->bounds_within(path, path.free_begin() + static_cast<Index>(i), reach_, beside_[i]);
    if (known) std::erase_if(beside_[i], [&](const NearBound& bound) { return !is_among(resting[i], bound.number); });
  }
}

/// Bounds that have come near do not matter: they push nothing that is clear of them.
bool Rest::holds(const Problem& problem, const CoordinatePath& path) const {
  const auto* bounds = find_ability<SeesBounds>(*problem.manifold);
  if (cost_ == nullptr || bounds == nullptr || problem.cost != cost_ || path.ring || !is_same(path.u, u_)) return false;
  const auto [lower, upper] = box_of(*problem.manifold);
  if (!is_same(lower, lower_) || !is_same(upper, upper_)) return false;
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
