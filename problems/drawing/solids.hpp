// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include <leastcost/problems/drawing/draws_itself.hpp>

namespace leastcost {

/// Appends all of another surface.
void append(TriangleSoup& out, const TriangleSoup& more);

/// All points within a radius of a segment, as triangles seen counterclockwise from outside; a ball where the ends are
/// one point. `around`: corners of a circle, at least 3.
TriangleSoup capsule_surface(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, int around);

/// The convex hull of points, as triangles seen counterclockwise from outside (Preparata, Shamos 1985: one point after
/// the other). Of points in a plane a slab too thin to be seen, of points on a line nothing.
TriangleSoup hull_surface(std::vector<Eigen::Vector3d> points);

/// The part of the plane normal . x = offset in a box: a polygon seen counterclockwise from where the normal points to;
/// empty where they do not meet.
TriangleSoup plane_in_box(const Eigen::Vector3d& normal, double offset, const Eigen::AlignedBox3d& box);

}  // namespace leastcost
