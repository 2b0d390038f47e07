// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/problems/distance/distance_source.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// Exact distances from a triangle mesh. With `sides`, negative where the winding number rounds to anything but 0 (so
/// an inside-out mesh is as good as another, and a closed part inside another is a cavity when its faces look the other
/// way); faces that disagree with their neighbours are turned first. Throws InputError when the mesh then has no
/// inside: borders, edges with an odd number of faces, a one-sided surface (said at once), winding numbers that are no
/// integers (said by sample()).
std::shared_ptr<const DistanceSource> make_mesh_distance(const TriangleMesh& mesh, bool sides);

}  // namespace leastcost
