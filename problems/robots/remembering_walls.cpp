// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/robots/remembering_walls.hpp"

#include <algorithm>
#include <utility>

namespace leastcost {
namespace {

constexpr std::size_t kMostRemembered = 1024;  ///< then all are forgotten
constexpr std::size_t kPairsOfPlace = 4;       ///< of a place, unless more are as near as was asked for
constexpr double kFartherThanAsked = 2,
                 kLookAtLeast = 0.2;   ///< of what was asked for; of the configuration: how far a look goes
constexpr double kFarthestLook = 4;    ///< of the configuration: looks that go farther are left to the walls
constexpr double kBesidePlace = 0.05;  ///< of the configuration: from farther away too much seems to be near

}  // namespace

RememberingWalls::RememberingWalls(std::shared_ptr<const PairWalls> walls) : walls_(std::move(walls)) {}

/// What is near a place and some way around it.
const RememberingWalls::Seen& RememberingWalls::look(const Vector& x, double reach) const {
  if (seen_.size() == kMostRemembered) seen_.clear();
  Seen seen;
  seen.radius = std::max(kFartherThanAsked * reach, kLookAtLeast);
  walls_->gaps_within(x, seen.radius, seen.pairs);
  if (seen.pairs.size() > kPairsOfPlace) {  // a smaller radius has fewer of them
    std::vector<double> gaps;
    for (const auto& [pair, gap] : seen.pairs) gaps.push_back(gap);
    std::nth_element(gaps.begin(), gaps.begin() + kPairsOfPlace, gaps.end());
    seen.radius = std::min(seen.radius, std::max(kFartherThanAsked * reach, gaps[kPairsOfPlace]));
    std::erase_if(seen.pairs, [&](const PairWalls::PairGap& one) { return one.gap >= seen.radius; });
  }
  if (places_.rows() != x.size()) places_.resize(x.size(), static_cast<Eigen::Index>(kMostRemembered));
  places_.col(static_cast<Eigen::Index>(seen_.size())) = x;
  last_ = seen_.size();
  from_place_ = 0;
  return seen_.emplace_back(std::move(seen));
}

/// What was seen from a place beside x, so far around that all gaps below `reach` at x are known.
const RememberingWalls::Seen& RememberingWalls::around(const Vector& x, double reach) const {
  const std::size_t count = seen_.size();
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t i = last_ + k;
    if (i >= count) i -= count;
    from_place_ = (x - places_.col(static_cast<Eigen::Index>(i))).norm();
    if (from_place_ > std::max(kBesidePlace, reach / 2) || from_place_ + reach > seen_[i].radius) continue;
    last_ = i;
    return seen_[i];
  }
  return look(x, reach);
}

/// The pairs that may be nearer than that to x.
void RememberingWalls::candidates(const Vector& x, double reach) const {
  const Seen& seen = around(x, reach);
  pairs_.clear();
  for (const auto& [pair, gap] : seen.pairs)
    if (gap - from_place_ < reach) pairs_.push_back(pair);
}

void RememberingWalls::near(const Vector& x, double reach, std::vector<Wall>& found) const {
  if (!mine() || !x.allFinite()) return walls_->near(x, reach, found);
  candidates(x, std::max(0.0, reach));
  found.clear();
  if (!pairs_.empty()) walls_->near_among(pairs_, x, reach, found);
}

void RememberingWalls::along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const {
  const double half = (b - a).norm() / 2;
  if (!mine() || !(half < kLookAtLeast) || !a.allFinite()) return walls_->along(a, b, reach, found);
  candidates((a + b) / 2, half + std::max(0.0, reach));
  found.clear();
  if (!pairs_.empty()) walls_->along_among(pairs_, a, b, reach, found);
}

/// The nearest core decides: pairs are looked at in the order of what is known of them, as long as they may be it.
double RememberingWalls::room(const Vector& a, const Vector& b, double reach) const {
  const double half = (b - a).norm() / 2;
  if (!mine() || !(half + reach < kFarthestLook) || !a.allFinite()) return walls_->room(a, b, reach);
  const Seen& seen = around((a + b) / 2, half + reach);
  bounds_.clear();
  for (const auto& [pair, gap] : seen.pairs) {
    const double least = gap + pair.required / pair.steepest - from_place_ - half;
    if (least < reach) bounds_.push_back({pair, least});
  }
  if (bounds_.empty()) return reach;
  std::sort(bounds_.begin(), bounds_.end(), [](const auto& p, const auto& q) { return p.gap < q.gap; });
  return walls_->room_among(bounds_, a, b, reach);
}

}  // namespace leastcost
