// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost::app {

enum class DistanceFormat { csv, vtp, ply };

/// By the ending of a file name; throws InputError that names those there are.
DistanceFormat distance_format(std::string_view file);

/// Distances of all vertices, all digits. `distance` is the length of a path, `error` what it is above the least one
/// at most; a vertex without a path has inf and 0.
/// CSV: vertex (of the file), x, y, z, distance, error. VTP and PLY: the mesh, numbered as here, with both as point
/// data; a vertex without a path has -1 in them, because many readers do not take inf.
std::string distance_text(const TriangleMesh& mesh, const ExactDistances& distances, DistanceFormat format);

}  // namespace leastcost::app
