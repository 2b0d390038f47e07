// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <leastcost/framework/problem/post_processor.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include <leastcost/problems/mesh/surface_path.hpp>

namespace leastcost {

/// The mesh of a problem's domain. Throws InputError("NAME needs a mesh") where there is none.
const HasMesh& mesh_of(const Problem& problem, std::string_view name);

/// A with M = A'A where the problem's cost is a length under a constant metric M (nothing inside: the Euclidean one);
/// nothing where it is not such a cost.
std::optional<MetricRoot> constant_metric(const Problem& problem);

/// A place of a domain that is a mesh, in the space of that mesh: a domain in the plane has its mesh at z = 0.
Eigen::Vector3d in_space(const Eigen::VectorXd& x);

/// The columns of a path on a mesh as points of their faces.
std::vector<SurfacePoint> surface_points(const TriangleMesh& mesh, const CoordinatePath& path);
/// And back, in the coordinates of the problem.
CoordinatePath coordinate_path(const Problem& problem, const TriangleMesh& mesh,
                               const std::vector<SurfacePoint>& points);

/// A path on the surface as the columns and sites of a CoordinatePath; column i has the face of segment i.
CoordinatePath as_coordinates(const Problem& problem, const SurfacePath& path);

/// A path on the surface as a Curve, with its cost.
Curve as_curve(const Problem& problem, const SurfacePath& path);
SurfacePath as_surface_path(const Curve& curve);

/// Cost of the curve between consecutive points of a chain (a ring begins where the curve does), found again on the
/// curve by position: a measurement, not what a resampling meant to do. +infinity from the first point on that is not
/// on the curve.
Eigen::VectorXd costs_along(const Problem& problem, const Curve& curve, const CoordinatePath& chain);

}  // namespace leastcost
