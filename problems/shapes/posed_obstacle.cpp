// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/shapes/posed_obstacle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/ability.hpp>
#include "problems/shapes/in_space.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

}  // namespace

PosedObstacle::PosedObstacle(std::shared_ptr<const Obstacle> core, const Support& support,
                             const Eigen::Isometry3d& pose, std::string name)
    : core_(std::move(core)),
      triangles_(find_ability<MeetsTriangles>(*core_)),
      turn_(pose.linear()),
      position_(pose.translation()),
      name_(std::move(name)) {
  constexpr double kOutwards = 8 * std::numeric_limits<double>::epsilon();
  const Eigen::Index d = core_->core_bounds().dim();
  bounds_ = Box(d);
  for (Eigen::Index i = 0; i < d; ++i) {
    const Vector3d along = turn_.row(i);
    const double least = position_[i] - support(-along), most = position_[i] + support(along);
    const double rounding = kOutwards * std::max({std::abs(least), std::abs(most), std::abs(position_[i])});
    bounds_.min()[i] = least - rounding;
    bounds_.max()[i] = most + rounding;
  }
  if (const auto* has = find_ability<HasCoreBox>(*core_)) {
    const OrientedBox own = has->core_box();
    core_box_ = OrientedBox{pose * own.center, turn_ * own.axes, own.half};
  }
}

/// Its own frame is asked in these, without memory being asked for.
void PosedObstacle::to_own(const Vector& x, Vector& own) const {
  const Vector3d inside = turn_.transpose() * (in_space(x) - position_);
  own.resize(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) own[i] = inside[i];
}

Eigen::MatrixXd PosedObstacle::corners() const {
  Eigen::MatrixXd all = core_->corners();
  const Eigen::Index d = all.rows();
  all = (turn_.topLeftCorner(d, d) * all).eval();
  return all.colwise() + position_.head(d);
}

double PosedObstacle::distance(const Vector& x, Eigen::Ref<Vector> away) const {
  thread_local Vector own, out;
  to_own(x, own);
  out.resize(x.size());
  const double distance = core_->distance(own, out);
  const Vector3d turned = turn_ * in_space(out);
  for (Eigen::Index i = 0; i < x.size(); ++i) away[i] = turned[i];
  return distance;
}

double PosedObstacle::distance_of_segment(const Vector& a, const Vector& b, double& t) const {
  thread_local Vector from, to;
  to_own(a, from);
  to_own(b, to);
  return core_->distance_of_segment(from, to, t);
}

double PosedObstacle::distance_of_triangle(const std::array<Vector3d, 3>& corners, Vector3d& nearest) const {
  std::array<Vector3d, 3> own;
  for (std::size_t k = 0; k < 3; ++k) own[k] = turn_.transpose() * (corners[k] - position_);
  const double distance = triangles_->distance_of_triangle(own, nearest);
  nearest = (turn_ * nearest + position_).eval();
  return distance;
}

}  // namespace leastcost
