// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <leastcost/problems/cloud/has_point_cloud.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include "catalogue/scene/domain_shapes.hpp"

namespace leastcost {
namespace {

constexpr std::size_t kMostTriangles = 50000, kMostSurfels = 40000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Points side_by_side(const Points& a, const Points& b) {
  Points both(a.rows(), a.cols() + b.cols());
  both << a, b;
  return both;
}

/// A path as it runs on the domain: along the chart between its points, closed for a ring.
Points chart_line(const Problem& problem, const CoordinatePath& path) {
  constexpr Index kPoints = 400;
  const bool chart = dynamic_cast<const HasChart*>(problem.manifold.get()) != nullptr;
  const Index moves = path.segment_count();
  const Index pieces = chart ? std::max<Index>(1, kPoints / std::max<Index>(1, moves)) : 1;
  CoordinatePath dense;
  dense.u.resize(path.u.rows(), moves * pieces + 1);
  for (Index i = 0; i < moves; ++i) {
    const Eigen::VectorXd a = path.column(i), b = path.column(i + 1);
    for (Index k = 0; k < pieces; ++k)
      dense.u.col(i * pieces + k) = a + (b - a) * static_cast<double>(k) / static_cast<double>(pieces);
  }
  dense.u.col(moves * pieces) = path.column(moves);
  return positions(*problem.manifold, dense);
}

/// The delivered curve; in a chart it is drawn through the points along the chart, because its chords lie below the
/// surface.
Points path_line(const Problem& problem, const Result& result) {
  if (dynamic_cast<const HasChart*>(problem.manifold.get()) != nullptr) return chart_line(problem, result.path);
  return result.curve.x;
}

/// Scans stand upright along y, maps and formulas along z: data that is not flat in z is taken for a scan.
Eigen::Vector3d up_of_data(const std::vector<Eigen::Vector3d>& points) {
  if (points.empty()) return Eigen::Vector3d::UnitZ();
  Eigen::Vector3d lower = points.front(), upper = points.front();
  for (const Eigen::Vector3d& x : points) {
    lower = lower.cwiseMin(x);
    upper = upper.cwiseMax(x);
  }
  const Eigen::Vector3d extent = upper - lower;
  return extent[2] < 0.5 * std::min(extent[0], extent[1]) ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
}

/// The box of the ambient space itself, where the domain is one.
void draw_box(const ConstraintManifold& manifold, const Points& paths, Scene& scene) {
  if (dynamic_cast<const HasBounds*>(&manifold) == nullptr) return;
  const Surroundings box = coordinate_bounds(manifold, paths.col(0));
  if (box.lower.array().isInf().all() && box.upper.array().isInf().all()) return;
  scene.lower = box.lower;
  scene.upper = box.upper;
}

void draw_plane(const Problem& problem, const Points& paths, Scene& scene) {
  Surroundings shown = around(paths).enlarged(0.15);
  // A path along an axis still gets a picture with some height.
  const double least = shown.extent().maxCoeff() * 0.4;
  for (Index i = 0; i < 2; ++i) {
    const double missing = std::max(0.0, least - shown.extent()[i]) / 2;
    shown.lower[i] -= missing;
    shown.upper[i] += missing;
  }
  if (scene.lower.size() > 0) {
    shown.lower = shown.lower.cwiseMax(scene.lower);
    shown.upper = shown.upper.cwiseMin(scene.upper);
  }
  scene.cost = cost_raster(*problem.cost, shown);
}

/// Asks for one ability after the other; the first that the domain has draws it.
void draw_domain(const Problem& problem, const Result& result, const Points& paths, Scene& scene) {
  const ConstraintManifold& manifold = *problem.manifold;
  const auto* level_set = dynamic_cast<const HasLevelSet*>(&manifold);
  const auto* grid = dynamic_cast<const HasDistanceGrid*>(&manifold);
  if (const auto* mesh = dynamic_cast<const HasMesh*>(&manifold)) {
    scene.surface = mesh_surface(mesh->mesh(), paths, kMostTriangles, scene.notes);
    scene.up = up_of_data(scene.surface.vertices);
  } else if (const auto* cloud = dynamic_cast<const HasPointCloud*>(&manifold)) {
    scene.surfels = cloud_surfels(cloud->cloud(), kMostSurfels, scene.notes);
    scene.up = up_of_data(scene.surfels.positions);
  } else if (const auto* chart = dynamic_cast<const HasChart*>(&manifold); chart != nullptr && scene.dimension == 3) {
    scene.surface = chart_surface(manifold, *chart, side_by_side(result.path.u, result.first.path.u));
  } else if (level_set != nullptr && level_set->function().outputs() == 1 && scene.dimension == 3) {
    scene.surface = level_surface(manifold, level_set->function(), around(paths),
                                  grid != nullptr ? &grid->grid().shape() : nullptr, scene.notes);
    if (grid != nullptr) scene.up = up_of_data(scene.surface.vertices);
  } else if (level_set != nullptr && level_set->function().outputs() == 1) {
    scene.curves = level_curves(manifold, level_set->function(), around(paths));
  } else if (manifold.shape() == Shape::flat) {
    draw_box(manifold, paths, scene);
    if (scene.dimension == 2) draw_plane(problem, paths, scene);
  }
}

}  // namespace

Surroundings Surroundings::enlarged(double part) const {
  const double by = part * extent().maxCoeff();
  return {lower.array() - by, upper.array() + by};
}

Surroundings around(const Points& x) {
  Surroundings box{Eigen::VectorXd::Constant(x.rows(), kInfinity), Eigen::VectorXd::Constant(x.rows(), -kInfinity)};
  for (const auto column : x.colwise()) {
    if (!column.allFinite()) continue;
    box.lower = box.lower.cwiseMin(column);
    box.upper = box.upper.cwiseMax(column);
  }
  return box;
}

Surroundings coordinate_bounds(const ConstraintManifold& manifold, const Eigen::VectorXd& inside) {
  const double far = 1e12 * std::max(1.0, inside.cwiseAbs().maxCoeff());
  Surroundings bounds{Eigen::VectorXd::Constant(inside.size(), -kInfinity),
                      Eigen::VectorXd::Constant(inside.size(), kInfinity)};
  CoordinatePath one{inside, {}, true};
  for (Index i = 0; i < inside.size(); ++i) {
    for (const double side : {-1.0, 1.0}) {
      one.u.col(0) = inside;
      one.u(i, 0) = side * far;
      const bool found = manifold.project(one).failed.empty() && std::abs(one.u(i, 0)) < far / 2;
      if (found) (side < 0 ? bounds.lower : bounds.upper)[i] = one.u(i, 0);
    }
  }
  return bounds;
}

Scene make_scene(const Problem& problem, const Result& result, std::span<const FamilyMember> others) {
  Scene scene;
  scene.dimension = problem.manifold->dimensions().ambient;
  if (scene.dimension != 2 && scene.dimension != 3) return scene;
  scene.lines.path = path_line(problem, result);
  scene.lines.first = chart_line(problem, result.first.path);
  for (const FamilyMember& member : others) scene.lines.others.push_back(path_line(member.problem, member.result));
  Points drawn = side_by_side(scene.lines.path, scene.lines.first);
  for (const Points& other : scene.lines.others) drawn = side_by_side(drawn, other);
  const Surroundings box = around(drawn);
  if (box.lower.allFinite() && box.extent().maxCoeff() > 0) draw_domain(problem, result, drawn, scene);
  return scene;
}

}  // namespace leastcost
