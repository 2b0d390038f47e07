// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>

namespace leastcost {

/// Every face of a mesh as an obstacle of its own, all points nearer to it than `radius` (length units): one that a
/// robot can rest on beside others, and whose core is convex. Faces without area, and those with the corners of an
/// earlier one, are left out: what they keep out is kept out by the others. Throws InputError where none is left.
std::vector<std::shared_ptr<const Obstacle>> make_face_obstacles(const TriangleMesh& mesh, double radius);

}  // namespace leastcost
