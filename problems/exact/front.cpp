// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leastcost {
namespace {

constexpr int kLanes = 16;                // points that are looked at together
constexpr float kRoundUp = 1 + 0x1p-20F;  // more than the roundings of a radius

using Lanes = Eigen::Array<float, kLanes, 1>;

Eigen::Map<const Lanes> lanes(const std::vector<float>& numbers, std::size_t ball) {
  return Eigen::Map<const Lanes>(numbers.data() + ball * kLanes);
}

}  // namespace

double sag(double gap, double piece) {
  const double distance = gap - piece;
  return distance > 0 ? std::min(piece, piece * piece / (8 * distance)) : piece;
}

void Front::begin(double piece) {
  for (std::vector<float>* numbers : {&x_, &y_, &z_, &bound_}) numbers->clear();
  piece_ = piece;
}

void Front::add(const Eigen::Vector3d& place, double at_least) {
  x_.push_back(static_cast<float>(place.x()));
  y_.push_back(static_cast<float>(place.y()));
  z_.push_back(static_cast<float>(place.z()));
  bound_.push_back(static_cast<float>(at_least));
}

/// Fills up with copies of the last point, so that the last ball has as many as the others.
void Front::finish() {
  const std::size_t count = (x_.size() + kLanes - 1) / kLanes;
  for (std::vector<float>* numbers : {&x_, &y_, &z_, &bound_}) numbers->resize(count * kLanes, numbers->back());
  balls_.clear();
  balls_.reserve(count);
  last_ = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Ball ball{lanes(x_, i).mean(), lanes(y_, i).mean(), lanes(z_, i).mean(), 0, lanes(bound_, i).minCoeff()};
    const Lanes squared =
        (lanes(x_, i) - ball.x).square() + (lanes(y_, i) - ball.y).square() + (lanes(z_, i) - ball.z).square();
    ball.radius = std::sqrt(squared.maxCoeff()) * kRoundUp;
    balls_.push_back(ball);
  }
}

Front::Seen Front::look(const Eigen::Vector3f& place, std::size_t ball) const {
  const Lanes squared = (lanes(x_, ball) - place.x()).square() + (lanes(y_, ball) - place.y()).square() +
                        (lanes(z_, ball) - place.z()).square();
  const Lanes distance = squared.sqrt();
  return {(lanes(bound_, ball) + distance).minCoeff(), distance.minCoeff()};
}

Front::Least Front::less_sag(const Seen& seen) const {
  const double gap = static_cast<double>(seen.nearest);
  return {static_cast<double>(seen.least) - sag(gap, piece_), gap};
}

Front::Least Front::through(const Eigen::Vector3d& place) {
  const Eigen::Vector3f p = place.cast<float>();
  const std::size_t first = last_;
  Seen best = look(p, first);
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const Ball& ball = balls_[i];
    const float dx = ball.x - p.x(), dy = ball.y - p.y(), dz = ball.z - p.z();
    // From farther away than this, none of its points is the nearest, nor has the least sum.
    const float away = std::max(best.nearest, best.least - ball.bound) + ball.radius;
    if (i == first || !(dx * dx + dy * dy + dz * dz < away * away)) continue;
    const Seen seen = look(p, i);
    best.nearest = std::min(best.nearest, seen.nearest);
    if (seen.least < best.least) {
      best.least = seen.least;
      last_ = i;
    }
  }
  return less_sag(best);
}

void Front::gather(const Eigen::Vector3d& place, const Least& least, double reach, Balls& balls) const {
  const Eigen::Vector3f p = place.cast<float>();
  const float sum = static_cast<float>(least.bound + sag(least.gap, piece_)), gap = static_cast<float>(least.gap);
  const float farther = 2 * static_cast<float>(reach);
  balls.clear();
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const Ball& ball = balls_[i];
    const float dx = ball.x - p.x(), dy = ball.y - p.y(), dz = ball.z - p.z();
    const float away = (std::max(gap, sum - ball.bound) + ball.radius + farther) * kRoundUp;
    if (dx * dx + dy * dy + dz * dz < away * away) balls.push_back(static_cast<std::uint32_t>(i));
  }
}

Front::Least Front::through(const Eigen::Vector3d& place, const Balls& balls) const {
  const Eigen::Vector3f p = place.cast<float>();
  Seen best{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
  for (const std::uint32_t i : balls) {
    const Seen seen = look(p, i);
    best.nearest = std::min(best.nearest, seen.nearest);
    best.least = std::min(best.least, seen.least);
  }
  return less_sag(best);
}

}  // namespace leastcost
