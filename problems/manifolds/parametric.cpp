// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/parametric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/chart/chart_images.hpp"
#include "problems/drawing/domain_shapes.hpp"

namespace leastcost {

ParametricManifold::ParametricManifold(std::shared_ptr<const ChartMap> map, Box box, std::vector<Seam> seams,
                                       std::vector<SeamMap> poles)
    : map_(std::move(map)), box_(std::move(box)), seams_(std::move(seams)), poles_(std::move(poles)) {}

Projection ParametricManifold::project(CoordinatePath& path) const {
  Projection result;
  for (Index i = 0; i < path.u.cols(); ++i) {
    Eigen::Vector2d u = path.u.col(i);
    box_.clamp(u);
    // Where a formula has no value there is no point.
    if (!map_->position(u).allFinite()) {
      result.failed.push_back(i);
      continue;
    }
    result.moved = std::max(result.moved, (u - path.u.col(i)).norm());
    path.u.col(i) = u;
  }
  return result;
}

void ParametricManifold::tangent_bases(const CoordinatePath& path, Points& bases) const {
  bases = Points::Identity(2, 2).replicate(1, path.u.cols());
}

void ParametricManifold::retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  prepare_like(from, to);
  auto moved = to.u.middleCols(from.free_begin(), from.free_count());
  moved = from.u.middleCols(from.free_begin(), from.free_count()) + step;
  box_.clamp(moved);
}

double ParametricManifold::residual(const CoordinatePath& path) const {
  CoordinatePath inside = path;
  return project(inside).moved;
}

void ParametricManifold::embed(const CoordinatePath& path, Points& x) const {
  x.resize(3, path.u.cols());
  for (Index i = 0; i < path.u.cols(); ++i) x.col(i) = map_->position(path.u.col(i));
}

void ParametricManifold::jacobians(const CoordinatePath& path, Points& j) const {
  j.resize(3, 2 * path.u.cols());
  for (Index i = 0; i < path.u.cols(); ++i) j.middleCols<2>(2 * i) = map_->jacobian(path.u.col(i));
}

void ParametricManifold::embed_with_jacobians(const CoordinatePath& path, Points& x, Points& j) const {
  x.resize(3, path.u.cols());
  j.resize(3, 2 * path.u.cols());
  Eigen::Matrix<double, 3, 2> slopes;
  for (Index i = 0; i < path.u.cols(); ++i) {
    x.col(i) = map_->position(path.u.col(i), slopes);
    j.middleCols<2>(2 * i) = slopes;
  }
}

void ParametricManifold::curvatures(const CoordinatePath& path, const Points& weights, Points& h) const {
  h.resize(2, 2 * path.u.cols());
  for (Index i = 0; i < path.u.cols(); ++i) h.middleCols<2>(2 * i) = map_->curvature(path.u.col(i), weights.col(i));
}

void ParametricManifold::enclose_chart(std::span<const IntervalJet<2>, 2> u, std::span<IntervalJet<2>> x,
                                       std::span<IntervalJet<2>> jacobian) const {
  map_->enclose(u, x.first<3>(), jacobian.first<6>());
}

void ParametricManifold::draw(const DrawnPaths& paths, Drawing& out) const {
  out.surface = chart_surface(*this, *this, paths.u);
}

std::vector<PointImage> ParametricManifold::images(const Eigen::VectorXd& x, const Eigen::VectorXd& reference,
                                                   std::size_t most) const {
  return chart_images(seams_, poles_, x, reference, most);
}

bool ParametricManifold::states_way(const Eigen::VectorXd& target, const Eigen::VectorXd& source) const {
  constexpr double kRounding = 1e-9;
  if (is_sphere_like()) return false;
  const auto turned = [&](const Seam& seam) {
    return std::abs(target[seam.coordinate] - source[seam.coordinate]) >= (1 - kRounding) * seam.period;
  };
  return std::any_of(seams_.begin(), seams_.end(), turned);
}

Eigen::VectorXd ParametricManifold::nearest_name(const Eigen::VectorXd& x, const Eigen::VectorXd& reference) const {
  if (!is_sphere_like()) return x;
  const Eigen::VectorXi turns = nearest_image(seams_, x, reference);
  return turns.isZero() ? x : seam_map(seams_, 2, turns).apply(x);
}

int ParametricManifold::active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const {
  return box_.bounded() ? box_.active(path.u.col(column), normals) : 0;
}

}  // namespace leastcost
