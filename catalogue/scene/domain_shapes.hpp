// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

// The parts that make_scene() chooses among, one per ability.
#include <leastcost/framework/manifold.hpp>
#include <leastcost/problems/cloud/point_cloud.hpp>
#include <leastcost/problems/distance/has_distance_grid.hpp>
#include <leastcost/problems/level_set/has_level_set.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include "catalogue/scene/scene.hpp"

namespace leastcost {

/// An axis-parallel box around a path.
struct Surroundings {
  Eigen::VectorXd lower, upper;
  Eigen::VectorXd extent() const { return upper - lower; }
  Eigen::VectorXd centre() const { return (lower + upper) / 2; }
  /// With `part` of the longest side put on every side.
  Surroundings enlarged(double part) const;
};
/// The smallest one around all columns; columns that are not finite are left out.
Surroundings around(const Points& x);

/// Where the coordinates of a domain with bounds end, found by asking for the nearest points of far ones; infinite
/// where they do not end.
Surroundings coordinate_bounds(const ConstraintManifold& manifold, const Eigen::VectorXd& inside);

/// The triangles of a mesh, thinned to at most `budget` except around the columns of `focus`.
TriangleSoup mesh_surface(const TriangleMesh& mesh, const Points& focus, std::size_t budget,
                          std::vector<std::string>& notes);

/// The surface of a chart around the columns of `u` (coordinate x m): whole periods, from pole to pole, within its
/// bounds.
TriangleSoup chart_surface(const ConstraintManifold& manifold, const HasChart& chart, const Points& u);

/// The level set of a function of space: all of it where it is closed and not much larger than the path, else the part
/// around the path. `grid`: the domain ends with it.
TriangleSoup level_surface(const ConstraintManifold& manifold, const ConstraintFunction& function,
                           const Surroundings& path, const GridShape* grid, std::vector<std::string>& notes);

/// The same for a function of the plane.
std::vector<Points> level_curves(const ConstraintManifold& manifold, const ConstraintFunction& function,
                                 const Surroundings& path);

/// At most `most` samples of a cloud, evenly thinned.
Surfels cloud_surfels(const PointCloud& cloud, std::size_t most, std::vector<std::string>& notes);

/// Cost per unit of length over a rectangle of the plane; nothing where it is the same everywhere.
std::optional<Raster> cost_raster(const SegmentCost& cost, const Surroundings& rectangle);

}  // namespace leastcost
