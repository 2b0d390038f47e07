// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/data/map.hpp>

#include <algorithm>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/occupancy/free_mesh.hpp"

namespace leastcost {
namespace {

/// The same path at z = 0.
CoordinatePath lifted(const CoordinatePath& path) {
  CoordinatePath out = path;
  out.u.conservativeResize(3, Eigen::NoChange);
  out.u.row(2).setZero();
  return out;
}

}  // namespace

struct MapManifold::Meshed {
  std::vector<CellBox> boxes;
  FreeMesh mesh;

  explicit Meshed(const OccupancyGrid& grid) : boxes(free_boxes(grid)) {
    if (boxes.empty()) throw InputError(grid.source + ": the map has no free cell");
    mesh = free_mesh(grid, boxes);
  }
};

MapManifold::MapManifold(const OccupancyGrid& grid) : MapManifold(grid, Meshed(grid)) {}

MapManifold::MapManifold(OccupancyGrid grid, Meshed meshed)
    : grid_(std::move(grid)),
      boxes_(std::move(meshed.boxes)),
      face_begin_(std::move(meshed.mesh.face_begin)),
      box_of_cell_(grid_.blocked.size(), -1),
      surface_(TriangleMesh(meshed.mesh.triangles)) {
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    for (int row = boxes_[i].row; row < boxes_[i].row_end; ++row)
      for (int column = boxes_[i].column; column < boxes_[i].column_end; ++column)
        box_of_cell_[grid_.index(row, column)] = static_cast<std::int32_t>(i);
}

Projection MapManifold::project(CoordinatePath& path) const {
  CoordinatePath in_space = lifted(path);
  Projection result = surface_.project(in_space);
  for (Index i = 0; i < path.u.cols(); ++i) {  // the nearest point of a triangle is the point itself to rounding only
    const Eigen::Vector2d at = cell_at(path.u.col(i));
    const bool near = at.cwiseAbs().maxCoeff() < grid_.rows + grid_.columns;  // NaN is not
    if (!near || !grid_.free(static_cast<int>(at[0]), static_cast<int>(at[1])))
      path.u.col(i) = in_space.u.col(i).head(2);
  }
  path.sites = std::move(in_space.sites);
  return result;
}

Eigen::Vector2d MapManifold::cell_at(const Eigen::Vector2d& x) const {
  return ((x - grid_.origin) / grid_.cell).array().floor().reverse();
}

std::string MapManifold::why_not_free(const Eigen::VectorXd& x) const {
  const Eigen::Vector2d at = cell_at(x);
  if (!(at.minCoeff() >= 0 && at[0] < grid_.rows && at[1] < grid_.columns)) return "is outside " + grid_.source;
  const std::size_t cell = grid_.index(static_cast<int>(at[0]), static_cast<int>(at[1]));
  if (!grid_.blocked[cell]) return "";
  if (grid_.unknown.empty() || !grid_.unknown[cell]) return "is in blocked cells of " + grid_.source;
  return "is in unknown cells of " + grid_.source + "; to let paths enter them, set `unknown: free` of the map";
}

void MapManifold::tangent_bases(const CoordinatePath& path, Points& bases) const {
  bases = Points::Identity(2, 2).replicate(1, path.u.cols());
}

void MapManifold::retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  prepare_like(from, to);
  CoordinatePath free{from.u.middleCols(from.free_begin(), from.free_count()) + step, {}, true};
  for (Index i = 0; i < from.free_count(); ++i) free.sites.push_back(from.site(from.free_begin() + i));
  project(free);
  to.u.middleCols(from.free_begin(), from.free_count()) = free.u;
  to.sites.resize(static_cast<std::size_t>(to.u.cols()), kNoSite);
  std::copy(free.sites.begin(), free.sites.end(), to.sites.begin() + from.free_begin());
}

double MapManifold::residual(const CoordinatePath& path) const { return surface_.residual(lifted(path)); }

bool MapManifold::is_asked_by(const CoordinatePath& path) const { return surface_.is_asked_by(lifted(path)); }

int MapManifold::active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const {
  Points in_space(3, 3);
  const CoordinatePath one = lifted({path.u.col(column), {path.site(column)}, true});
  const int count = std::min<int>(surface_.active_bounds(one, 0, in_space), 2);
  normals.leftCols(count) = in_space.topLeftCorner(2, count);
  return count;
}

}  // namespace leastcost
