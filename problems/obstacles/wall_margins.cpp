// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/wall_margins.hpp>

#include <algorithm>
#include <cmath>

namespace leastcost {
namespace {

constexpr double kOverCores = 1.05;   ///< of half a move: what keeps it from passing over a core
constexpr double kSameLength = 0.02;  ///< relative: by so much moves may be longer without another fit
constexpr int kLoosened = 6;          ///< fits after which margins only grow, so that they come to an end
constexpr double kKept = 0.25;        ///< of what a fit allows: costs less than the middle, in as few fits

}  // namespace

WallMargins::WallMargins(double longest_move, double thinnest)
    : from_cores_(kOverCores * longest_move / 2), thinnest_(thinnest) {}

WallMargins::WallMargins(double longest_move, double thinnest, const std::map<int, double>& widths)
    : WallMargins(longest_move, thinnest) {
  for (const auto& [obstacle, width] : widths) margins_[obstacle].width = width;
  widths_before_ = widths;
  from_cores_before_ = from_cores_;
  fits_ = 1;
}

std::map<int, double> WallMargins::widths() const {
  std::map<int, double> widths;
  for (const auto& [obstacle, margin] : margins_) widths[obstacle] = margin.width;
  return widths;
}

/// A gap that a margin of its own does not hold open is left.
std::map<int, double> WallMargins::widths_for_next(const std::map<int, double>& gaps, const Fit& closely) const {
  std::map<int, double> next = widths();
  for (auto& [obstacle, width] : next) {
    const auto gap = gaps.find(obstacle);
    if (gap == gaps.end() || gap->second > std::min(closely.agree, width + closely.on)) continue;
    width = std::max(0.0, width + kKept * closely.agree - std::max(0.0, gap->second));
  }
  return next;
}

double WallMargins::of(const Wall& wall) const {
  const auto found = margins_.find(wall.obstacle);
  return std::max(found == margins_.end() ? 0 : found->second.width, from_cores_ - wall.required);
}

double WallMargins::widest() const {
  double widest = std::max(0.0, from_cores_ - thinnest_);
  for (const auto& [obstacle, margin] : margins_) widest = std::max(widest, margin.width);
  return widest;
}

double WallMargins::before(const Wall& wall) const {
  const auto found = widths_before_.find(wall.obstacle);
  return std::max(found == widths_before_.end() ? 0 : found->second, from_cores_before_ - wall.required);
}

double WallMargins::widest_before() const {
  double widest = std::max(0.0, from_cores_before_ - thinnest_);
  for (const auto& [obstacle, width] : widths_before_) widest = std::max(widest, width);
  return widest;
}

/// The margin with which the gap of the moves, which is `gap` at a margin of `now`, will be `to`. A margin moves the
/// gap by as much; where points slide along a wall as they leave it, by more; and where an end of the path touches a
/// wall, so that the first move is tangent to it at last, like the square of what is missing, a root that counts twice.
double WallMargins::fit(const Margin& known, double now, double gap, double to) {
  constexpr double kGentle = 0.7, kLeast = 1e-4, kMost = 5;
  double slope = 1;
  if (known.has_before && now != known.before)
    slope = std::clamp((gap - known.gap_before) / (now - known.before), kLeast, kMost);
  if (slope < kGentle && gap < 0) slope /= 2;
  return now + std::min((to - gap) / slope, std::max(now, 2 * (to - gap)));
}

std::optional<WallMargins> WallMargins::fitted(const std::map<int, Wall>& least, double longest_move,
                                               const Fit& closely) const {
  WallMargins fitted(longest_move, thinnest_);
  fitted.fits_ = fits_ + 1;
  for (const auto& [obstacle, known] : margins_) fitted.widths_before_[obstacle] = known.width;
  fitted.from_cores_before_ = from_cores_;
  bool changed = std::abs(fitted.from_cores_ - from_cores_) > kSameLength * from_cores_;
  if (!changed) fitted.from_cores_ = from_cores_;
  for (const auto& [obstacle, known] : margins_)  // what is not beside the path any more needs none
    if (least.count(obstacle) == 0 && fits_ >= kLoosened) fitted.margins_[obstacle] = known;
  for (const auto& [obstacle, wall] : least) {
    const auto known = margins_.find(obstacle);
    const Margin last = known == margins_.end() ? Margin{} : known->second;
    const double now = std::max(last.width, from_cores_ - wall.required);
    Margin next{last.width, now, wall.gap, fits_ > 0};  // before the first fit it was not solved
    if (wall.gap < -closely.rounding || (wall.gap > closely.agree && last.width > 0 && fits_ < kLoosened))
      next.width = std::max(0.0, fit(last, now, wall.gap, closely.agree / 2));
    if (next.width > 0) fitted.margins_[obstacle] = next;
    const bool holds = wall.gap <= now + closely.on;
    changed = changed || (next.width != last.width && (holds || next.width > now));
  }
  return changed ? std::optional<WallMargins>(std::move(fitted)) : std::nullopt;
}

void WallMargins::take_sags(const Walls& walls, const Points& x, const Fit& closely, std::map<int, Wall>& least) const {
  std::map<int, double> of_points;
  std::vector<Wall> found;
  for (Index i = 0; i < x.cols(); ++i) {
    walls.near(x.col(i), widest(), found);
    for (const Wall& wall : found) {
      const auto [entry, first] = of_points.try_emplace(wall.obstacle, wall.gap);
      if (!first) entry->second = std::min(entry->second, wall.gap);
    }
  }
  for (auto& [obstacle, wall] : least) {
    const auto points = of_points.find(obstacle);
    if (points == of_points.end()) continue;
    const double at_rest = of(wall) + wall.gap - points->second;
    if (wall.gap < 0 || wall.gap > closely.agree)
      wall.gap = std::min(wall.gap, at_rest);
    else
      wall.gap = at_rest - wall.gap + closely.agree / 2;  // as it is
  }
}

std::map<int, Wall> least_on_moves(const Walls& walls, const Points& x, Index moves, double reach) {
  std::map<int, Wall> least;
  std::vector<Wall> found;
  for (Index i = 0; i < moves; ++i) {
    walls.along(x.col(i), x.col((i + 1) % x.cols()), reach, found);
    for (const Wall& wall : found) {
      const auto [entry, first] = least.try_emplace(wall.obstacle, wall);
      if (!first) entry->second.gap = std::min(entry->second.gap, wall.gap);
    }
  }
  return least;
}

}  // namespace leastcost
