// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/domain/around_pole.hpp"

#include <cmath>
#include <numbers>

namespace leastcost {

std::optional<AroundPole> AroundPole::of(const HasChart& chart, const Points& u) {
  constexpr double kNear = 0.7;  // radians
  for (const SeamMap& pole : chart.poles()) {
    AroundPole around;
    if (pole.sign.size() != 2 || pole.sign[0] * pole.sign[1] >= 0) continue;
    around.distance_ = pole.sign[0] < 0 ? 0 : 1;
    around.turn_ = 1 - around.distance_;
    around.at_ = pole.shift[around.distance_] / 2;
    const double half_turn = std::abs(pole.shift[around.turn_]);
    if (!(half_turn > 0)) continue;
    around.scale_ = std::numbers::pi / half_turn;
    const Eigen::ArrayXd off = around.scale_ * (u.row(around.distance_).array() - around.at_).transpose();
    if (!(off.abs().minCoeff() < kNear)) continue;
    around.side_ = off.sum() < 0 ? -1 : 1;
    return around;
  }
  return std::nullopt;
}

Points AroundPole::flat(const Points& u) const {
  Points p(2, u.cols());
  for (Index i = 0; i < u.cols(); ++i) {
    const double r = scale_ * (u(distance_, i) - at_), angle = scale_ * u(turn_, i);
    p.col(i) << r * std::cos(angle), r * std::sin(angle);
  }
  return p;
}

void AroundPole::chart_of(const Eigen::Vector2d& p, const Eigen::Vector2d& dp, Eigen::Vector2d& u,
                          Eigen::Vector2d& velocity) const {
  constexpr double kAtPole = 1e-9;  // radians: the chart's own rounding there is 1e-16
  const double r = p.norm();
  const bool away = r > kAtPole;
  const Eigen::Vector2d direction = side_ * (away ? p : dp);
  u[distance_] = at_ + side_ * r / scale_;
  u[turn_] = std::atan2(direction[1], direction[0]) / scale_;
  velocity[distance_] = side_ * (away ? p.dot(dp) / r : dp.norm()) / scale_;
  velocity[turn_] = away ? (p[0] * dp[1] - p[1] * dp[0]) / (r * r) / scale_ : 0;
}

}  // namespace leastcost
