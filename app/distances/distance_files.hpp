// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost::app {

enum class DistanceFormat { csv, vtp, ply };

/// By the ending of a file name; throws InputError that names those there are.
DistanceFormat distance_format(std::string_view file);

/// What is known of one vertex.
enum class DistanceState {
  exact,        ///< as near as rounding lets it be
  bound,        ///< a path of this length was found; there may be a shorter one, by `error` at most
  not_reached,  ///< no path was found before the search ended
  no_path,      ///< there is none
};
Words<DistanceState> words(DistanceState);

DistanceState state_at(const ExactDistances& distances, std::int32_t v);

/// A value of a vertex, and by how much it is too large at most.
struct AtVertex {
  double value, error;
};

/// PLY or VTP: the mesh, numbered as here, with the values and errors as point data; both finite, because many readers
/// take no inf. `name`: of the values; `comment`: what stands for missing ones.
std::string vertices_ply(const TriangleMesh& mesh, std::string_view name, std::string_view comment,
                         const std::vector<AtVertex>& values);
std::string vertices_vtp(const TriangleMesh& mesh, std::string_view name, const std::vector<AtVertex>& values);

/// Distances of all vertices, all digits. `distance` is the length of a path, `error` what it is above the least one
/// at most; a vertex without a path has inf and 0, one that was not reached inf and inf.
/// CSV: vertex (of the file), x, y, z, distance, error, state (a word of DistanceState). VTP and PLY: the mesh,
/// numbered as here, with distance and error as point data; a vertex without a path has the distance -1, one that was
/// not reached -2, because many readers do not take inf.
std::string distance_text(const TriangleMesh& mesh, const ExactDistances& distances, DistanceFormat format);

}  // namespace leastcost::app
