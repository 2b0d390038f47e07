// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

/// Capsules (of link 0) whose union holds a solid shape, in the frame of the shape.
struct Covering {
  std::vector<Capsule> capsules = {};  ///< of link 0
  double adds = 0;                     ///< how far they reach out of the shape, at most
};

/// One capsule, as small as its ends and its radius can be chosen together. Its ends are no farther out than the faces
/// of the cylinder, which is around the z axis and has its middle in the origin. Throws OptionError("length"),
/// ("radius").
Covering cover_cylinder(double length, double radius);

/// Side by side along the longest edge, one for each square of the cross-section, at most 8: a body of faces alone
/// would be hollow, and parts must not touch others inside it. The middle of the box is the origin. Throws
/// OptionError("size").
Covering cover_box(const Eigen::Vector3d& size);

/// One capsule around points. A capsule is convex, so it holds their convex hull as well: all of a mesh whose corners
/// they are. Its radius is rounded up from the distance of the farthest point. What it adds to the hull is measured in
/// 400 directions, for information. Throws OptionError("points") where there is none, and for numbers that are not
/// finite.
Covering cover_points(const std::vector<Eigen::Vector3d>& points);

/// How far capsules reach out of the convex hull of points, at most of 400 directions.
double reach_beyond(const std::vector<Capsule>& capsules, const std::vector<Eigen::Vector3d>& points);

}  // namespace leastcost
