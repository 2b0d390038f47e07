// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/data/terrain.hpp>

#include <algorithm>
#include <utility>

#include "problems/drawing/domain_shapes.hpp"
#include "problems/raster/raster_function.hpp"

namespace leastcost {
namespace {

Box box_of(const RasterPatches& patches) {
  return Box(2, {Eigen::VectorXd(patches.lower()), Eigen::VectorXd(patches.upper())});
}

}  // namespace

TerrainManifold::TerrainManifold(RasterGrid heights)
    : raster_(std::move(heights)),
      heights_(std::make_shared<const SplineFunction>(SplineFunction::through(raster_))),
      box_(box_of(heights_->patches())) {}

Eigen::Vector3d TerrainManifold::on_surface(const Eigen::Vector2d& place) const {
  return {place[0], place[1], heights_->at(place[0], place[1]).value};
}

Projection TerrainManifold::project(CoordinatePath& path) const {
  Projection result;
  for (Index i = 0; i < path.u.cols(); ++i) {
    Eigen::Vector2d u = path.u.col(i);
    box_.clamp(u);
    if (!on_surface(u).allFinite()) {
      result.failed.push_back(i);
      continue;
    }
    result.moved = std::max(result.moved, (u - path.u.col(i)).norm());
    path.u.col(i) = u;
  }
  return result;
}

void TerrainManifold::tangent_bases(const CoordinatePath& path, Points& bases) const {
  bases = Points::Identity(2, 2).replicate(1, path.u.cols());
}

void TerrainManifold::retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  prepare_like(from, to);
  auto moved = to.u.middleCols(from.free_begin(), from.free_count());
  moved = from.u.middleCols(from.free_begin(), from.free_count()) + step;
  box_.clamp(moved);
}

double TerrainManifold::residual(const CoordinatePath& path) const {
  CoordinatePath inside = path;
  return project(inside).moved;
}

void TerrainManifold::embed(const CoordinatePath& path, Points& x) const {
  x.resize(3, path.u.cols());
  for (Index i = 0; i < path.u.cols(); ++i) x.col(i) = on_surface(path.u.col(i));
}

void TerrainManifold::jacobians(const CoordinatePath& path, Points& j) const {
  j.resize(3, 2 * path.u.cols());
  for (Index i = 0; i < path.u.cols(); ++i) {
    j.block<2, 2>(0, 2 * i).setIdentity();
    j.block<1, 2>(2, 2 * i) = heights_->at(path.u(0, i), path.u(1, i)).gradient.transpose();
  }
}

void TerrainManifold::curvatures(const CoordinatePath& path, const Points& weights, Points& h) const {
  h.resize(2, 2 * path.u.cols());
  for (Index i = 0; i < path.u.cols(); ++i)
    h.middleCols<2>(2 * i) = weights(2, i) * heights_->at(path.u(0, i), path.u(1, i)).hessian;
}

const std::vector<SeamMap>& TerrainManifold::poles() const {
  static const std::vector<SeamMap> none;
  return none;
}

int TerrainManifold::active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const {
  return box_.active(path.u.col(column), normals);
}

Eigen::Vector2d TerrainManifold::longitude_latitude(const Eigen::VectorXd& u) const {
  return raster_.longitude_latitude(u.head<2>());
}

std::string TerrainManifold::why_not_projected(const Eigen::VectorXd& x) const {
  return heights_->patches().why_unknown(x[0], x[1]);
}

const RasterPatches& TerrainManifold::known_patches() const { return heights_->patches(); }

double TerrainManifold::diameter() const { return (box_.upper() - box_.lower()).norm(); }

double TerrainManifold::end_tolerance() const { return 0.5 * raster_.cell.minCoeff(); }

std::vector<std::string> TerrainManifold::notes() const {
  const std::string note = raster_.place_note();
  return note.empty() ? std::vector<std::string>{} : std::vector<std::string>{note};
}

std::vector<DataCount> TerrainManifold::counts() const {
  const auto missing =
      std::count_if(raster_.values.begin(), raster_.values.end(), [](double z) { return !std::isfinite(z); });
  std::vector<DataCount> all = {{"cell", "cells", static_cast<long>(raster_.values.size())}};
  if (missing > 0) all.push_back({"cell without data", "cells without data", static_cast<long>(missing)});
  return all;
}

void TerrainManifold::draw(const DrawnPaths& paths, Drawing& out) const {
  out.surface = chart_surface(*this, *this, paths.u);
}

}  // namespace leastcost
