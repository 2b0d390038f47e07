// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/manifolds/bordered_cloud.hpp"

#include <cmath>
#include <limits>

namespace leastcost {
namespace {

constexpr double kAlongBorder = 1e-9;  ///< of a step: what of it may lead off the border that it runs along

void lose(Eigen::Ref<Eigen::VectorXd> x) { x.setConstant(std::numeric_limits<double>::quiet_NaN()); }

}  // namespace

bool BorderedCloud::project_point(Eigen::Ref<Eigen::VectorXd> x) const {
  Eigen::Vector3d y = x;
  if (!surface().project_within(y)) return false;
  x = y;
  return true;
}

/// A point on the border whose step leads along it, or outwards, stays on it.
void BorderedCloud::move(const CoordinatePath& from, const Points& step, const BoundsOfPoints* onto,
                         CoordinatePath& to) const {
  prepare_like(from, to);
  const Index first = from.free_begin();
  for (Index i = 0; i < step.cols(); ++i) {
    const Eigen::Vector3d start = from.u.col(first + i), way = step.col(i);
    bool stays = onto != nullptr && !(*onto)[static_cast<std::size_t>(i)].empty();
    if (!stays) {
      const auto border = surface().border_near(start);
      stays = border && border->rests && border->outward.dot(way) >= -kAlongBorder * way.norm();
    }
    Eigen::Vector3d x = start + way;
    if (stays ? surface().project_onto_border(x) : surface().project_within(x))
      to.u.col(first + i) = x;
    else
      lose(to.u.col(first + i));
  }
}

void BorderedCloud::retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  move(from, step, nullptr, to);
}

void BorderedCloud::retract_onto(const CoordinatePath& from, const Points& step, const BoundsOfPoints& bounds,
                                 CoordinatePath& to) const {
  move(from, step, &bounds, to);
}

void BorderedCloud::retract_beyond(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  prepare_like(from, to);
  const Index first = from.free_begin();
  for (Index i = 0; i < step.cols(); ++i) {
    const Eigen::Vector3d start = from.u.col(first + i), way = step.col(i);
    const auto border = surface().border_near(start);
    const bool stays = border && border->rests && std::abs(border->outward.dot(way)) <= kAlongBorder * way.norm();
    Eigen::Vector3d x = start + way;
    if (stays ? surface().project_onto_border(x) : surface().project_beyond(x))
      to.u.col(first + i) = x;
    else
      lose(to.u.col(first + i));
  }
}

int BorderedCloud::active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const {
  const auto border = surface().border_near(path.u.col(column));
  if (!border || !border->rests) return 0;
  normals.col(0) = border->outward;
  return 1;
}

void BorderedCloud::bounds_within(const CoordinatePath& path, Index column, double reach,
                                  std::vector<NearBound>& found) const {
  found.clear();
  const auto border = surface().border_near(path.u.col(column));
  if (border && border->gap <= reach) found.push_back({0, -border->outward, border->rests ? 0 : border->gap});
}

}  // namespace leastcost
