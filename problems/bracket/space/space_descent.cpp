// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/space/space_descent.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "problems/bracket/space/spline_place.hpp"

namespace leastcost::bracket {
namespace {

using Eigen::Vector3d;

/// Unit vector down the field; not finite where there is none.
Vector3d downhill(const SpaceLevel& level, const std::vector<double>& u, const Vector3d& x) {
  if (!x.allFinite()) return x;
  return -spline_slope(level.grid, level.nodes, u, level.grid.in_box(x)).normalized();
}

/// Empty where it gets stuck.
std::vector<Vector3d> way_down(const SpaceLevel& level, const SpaceDistance& field, const Vector3d& from) {
  const SpaceGrid& grid = level.grid;
  constexpr double kNear = 3, kStep = 0.5;  // cells
  const auto most = static_cast<std::size_t>(64) * static_cast<std::size_t>(grid.longest());
  std::vector<Vector3d> way = {from};
  while ((way.back() - field.ball.place).norm() > kNear * grid.h) {
    const double step = kStep * grid.h;
    const Vector3d half = way.back() + 0.5 * step * downhill(level, field.u, way.back());
    const Vector3d next = way.back() + step * downhill(level, field.u, half);
    if (!next.allFinite() || way.size() > most) return {};
    way.push_back(grid.in_box(next));
  }
  way.push_back(field.ball.place);
  return way;
}

}  // namespace

std::vector<Eigen::Matrix3Xd> ways_down(const SpaceLevel& level, const SpaceDistance& field, const Vector3d& from) {
  constexpr double kAside = 2;          // cells
  constexpr std::ptrdiff_t kJoin = 24;  // points of the way that a straight move to it leaves out
  const SpaceGrid& grid = level.grid;
  const Vector3d down = downhill(level, field.u, from);
  if (!down.allFinite()) return {};
  const Vector3d one = down.unitOrthogonal(), other = down.cross(one);
  std::vector<Eigen::Matrix3Xd> out;
  for (const Vector3d& aside : {Vector3d(Vector3d::Zero()), one, Vector3d(-one), other, Vector3d(-other)}) {
    const Vector3d begin = grid.in_box(from + kAside * grid.h * aside);
    std::vector<Vector3d> way = way_down(level, field, begin);
    if (way.empty()) continue;
    const bool straight = aside.isZero();
    if (!straight) way.erase(way.begin(), way.begin() + std::min<std::ptrdiff_t>(kJoin, std::ssize(way) - 1));
    if (!straight) way.insert(way.begin(), from);
    Eigen::Matrix3Xd x(3, static_cast<Eigen::Index>(way.size()));
    for (std::size_t k = 0; k < way.size(); ++k) x.col(x.cols() - 1 - static_cast<Eigen::Index>(k)) = way[k];
    out.push_back(std::move(x));
  }
  return out;
}

}  // namespace leastcost::bracket
