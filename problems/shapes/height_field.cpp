// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/shapes/height_field.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include <leastcost/problems/obstacles/mesh_obstacle.hpp>
#include "problems/drawing/draws_surface.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The triangles of the surface, and what closes it: walls under its border, and a floor.
class ClosedField {
 public:
  ClosedField(const RasterGrid& heights, double floor, const Eigen::Isometry3d& pose)
      : rows_(heights.rows), columns_(heights.columns), floor_(floor), pose_(pose) {
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        const Vector2d at = heights.place(row, column);
        soup_.positions.push_back(pose_ * Vector3d(at[0], at[1], heights.value(row, column)));
      }
    soup_.polygon_begin.push_back(0);
    for (int row = 0; row + 1 < rows_; ++row)
      for (int column = 0; column + 1 < columns_; ++column) {
        const std::int32_t a = top(row, column), c = top(row + 1, column + 1);
        add(a, top(row, column + 1), c);
        add(a, c, top(row + 1, column));
      }
    surface_.vertices = soup_.positions;
    for (std::size_t k = 0; k < soup_.corners.size(); k += 3)
      surface_.triangles.push_back({soup_.corners[k], soup_.corners[k + 1], soup_.corners[k + 2]});
    close(heights);
    soup_.source = heights.source;
  }

  const PolygonSoup& soup() const { return soup_; }
  const TriangleSoup& surface() const { return surface_; }

 private:
  std::int32_t top(int row, int column) const { return row * columns_ + column; }

  void add(std::int32_t a, std::int32_t b, std::int32_t c) {
    for (const std::int32_t corner : {a, b, c}) soup_.corners.push_back(corner);
    soup_.polygon_begin.push_back(static_cast<std::int32_t>(soup_.corners.size()));
  }

  /// Around the border, the outside on the right; the floor is two triangles. Distances do not mind that its sides pass
  /// the lower corners of the walls.
  void close(const RasterGrid& heights) {
    std::vector<std::pair<int, int>> ring;
    for (int column = 0; column + 1 < columns_; ++column) ring.emplace_back(0, column);
    for (int row = 0; row + 1 < rows_; ++row) ring.emplace_back(row, columns_ - 1);
    for (int column = columns_ - 1; column > 0; --column) ring.emplace_back(rows_ - 1, column);
    for (int row = rows_ - 1; row > 0; --row) ring.emplace_back(row, 0);
    const auto lower = static_cast<std::int32_t>(soup_.positions.size()),
               count = static_cast<std::int32_t>(ring.size());
    for (const auto& [row, column] : ring) {
      const Vector2d at = heights.place(row, column);
      soup_.positions.push_back(pose_ * Vector3d(at[0], at[1], floor_));
    }
    for (std::int32_t k = 0; k < count; ++k) {
      const std::int32_t next = (k + 1) % count;
      const auto& [row, column] = ring[static_cast<std::size_t>(k)];
      const auto& [next_row, next_column] = ring[static_cast<std::size_t>(next)];
      add(top(row, column), lower + k, lower + next);
      add(top(row, column), lower + next, top(next_row, next_column));
    }
    const std::int32_t right = columns_ - 1, far = right + rows_ - 1, left = far + columns_ - 1;
    add(lower, lower + far, lower + right);
    add(lower, lower + left, lower + far);
  }

  int rows_, columns_;
  double floor_;
  Eigen::Isometry3d pose_;
  PolygonSoup soup_;
  TriangleSoup surface_;
};

/// The walls of a mesh, with an inside that is looked up in the raster.
class HeightField final : public Obstacle, public MeetsTriangles, public DrawsSurface {
 public:
  HeightField(RasterGrid heights, double floor, const Eigen::Isometry3d& pose, const std::string& name)
      : heights_(std::move(heights)), floor_(floor), to_frame_(pose.inverse()) {
    const ClosedField closed(heights_, floor, pose);
    surface_ = closed.surface();
    walls_ = make_mesh_obstacle(TriangleMesh(closed.soup()), MeshInside::surface, 0, name);
    triangles_ = find_ability<MeetsTriangles>(*walls_);
  }

  std::string name() const override { return walls_->name(); }
  Box core_bounds() const override { return walls_->core_bounds(); }
  double radius() const override { return 0; }
  Eigen::MatrixXd corners() const override { return {}; }
  TriangleSoup surface() const override { return surface_; }

  double distance(const Vector& x, Eigen::Ref<Vector> away) const override {
    const double distance = walls_->distance(x, away);
    if (distance == 0 || !inside(x)) return distance;  // on it faces look outwards
    away = -away;
    return -distance;
  }

  double distance_of_segment(const Vector& a, const Vector& b, double& t) const override {
    t = 0;
    return inside(Vector3d(a)) ? 0 : walls_->distance_of_segment(a, b, t);
  }

  double distance_of_triangle(const std::array<Vector3d, 3>& corners, Vector3d& nearest) const override {
    nearest = corners[0];
    return inside(nearest) ? 0 : triangles_->distance_of_triangle(corners, nearest);
  }

 private:
  /// Between the floor and the triangle over it.
  bool inside(const Vector3d& x) const {
    const Vector3d at = to_frame_ * x;
    const Vector2d cells = (at.head<2>() - heights_.place(0, 0)).cwiseQuotient(heights_.cell);
    const int right = heights_.columns - 1, far = heights_.rows - 1;
    if (!(cells[0] >= 0 && cells[0] <= right && cells[1] >= 0 && cells[1] <= far) || at[2] < floor_) return false;
    const int column = std::min(static_cast<int>(cells[0]), right - 1),
              row = std::min(static_cast<int>(cells[1]), far - 1);
    const double u = cells[0] - column, v = cells[1] - row;
    const double first = heights_.value(row, column), last = heights_.value(row + 1, column + 1);
    const double corner = u >= v ? heights_.value(row, column + 1) : heights_.value(row + 1, column);
    const double more = std::max(u, v), less = std::min(u, v);
    return at[2] <= first + more * (corner - first) + less * (last - corner);
  }

  RasterGrid heights_;
  double floor_;
  Eigen::Isometry3d to_frame_;
  TriangleSoup surface_;  ///< for drawing: without the walls and the floor
  std::shared_ptr<const Obstacle> walls_;
  const MeetsTriangles* triangles_;  ///< of the walls
};

void check_heights_of_field(const RasterGrid& heights) {
  constexpr std::size_t kMost = 1000000;
  const std::string size = std::to_string(heights.rows) + " x " + std::to_string(heights.columns);
  if (heights.rows < 2 || heights.columns < 2)
    throw InputError(heights.source + ": a height field has at least 2 x 2 heights, and this one has " + size);
  if (heights.values.size() > kMost)
    throw InputError(heights.source + ": a height field has at most " + std::to_string(kMost) +
                     " heights, and this one has " + size + "; coarsen it, or cut out the part around the robot");
  const auto missing =
      std::find_if(heights.values.begin(), heights.values.end(), [](double z) { return !std::isfinite(z); });
  if (missing == heights.values.end()) return;
  const auto at = static_cast<int>(missing - heights.values.begin());
  throw InputError(
      heights.name_of(at / heights.columns, at % heights.columns) +
      " has no height, or one that programs write where there is none, like -9999; a height field has no gaps: "
      "fill them, or cut out a part without any");
}

}  // namespace

void HeightFieldOptions::fields(FieldVisitor& visit) {
  raster.fields(visit, false);
  visit.field("heights", heights,
              {.help = "Instead of a file: rows of heights, the northernmost first.", .unit = "length"});
  visit.field("depth", depth,
              {.help = "How far the ground reaches down below its least height; default: the diagonal of the field.",
               .unit = "length",
               .minimum = 0,
               .exclusive_minimum = true});
  visit_pose(visit, pose);
}

void check(const HeightFieldOptions& options) {
  check(options.raster);
  if (options.raster.file.empty() && options.heights.size() == 0)
    throw OptionError("file", "is missing: a height field has the file of a raster, or 'heights', rows of numbers");
  if (!options.raster.file.empty() && options.heights.size() > 0)
    throw OptionError("heights", "must not be given beside 'file': a height field has one of them");
  if (options.depth && (!(*options.depth > 0) || !std::isfinite(*options.depth)))
    throw OptionError("depth", "must be a number greater than 0");
  pose_of(options.pose, 3);
}

RasterGrid raster_of_heights(const HeightFieldOptions& options) {
  RasterFile file;
  RasterGrid& raster = file.raster;
  raster.source = "heights";
  raster.rows = static_cast<int>(options.heights.rows());
  raster.columns = static_cast<int>(options.heights.cols());
  for (Eigen::Index row = options.heights.rows(); row-- > 0;)
    for (const double height : options.heights.row(row)) raster.values.push_back(height);
  return placed(std::move(file), options.raster);
}

std::shared_ptr<const Obstacle> make_height_field(const RasterGrid& heights, const HeightFieldOptions& options,
                                                  const std::string& name) {
  check_heights_of_field(heights);
  check_heights(heights, options.raster);
  const Vector2d extent = heights.cell.cwiseProduct(Vector2d(heights.columns - 1, heights.rows - 1));
  const auto [least, most] = std::minmax_element(heights.values.begin(), heights.values.end());
  const double depth = options.depth.value_or(Vector3d(extent[0], extent[1], *most - *least).norm());
  const std::string file = std::filesystem::path(options.raster.file).filename().string();
  return std::make_shared<HeightField>(heights, *least - depth, pose_of(options.pose, 3),
                                       !name.empty()   ? name
                                       : !file.empty() ? "the height field " + file
                                                       : "the height field");
}

}  // namespace leastcost
