// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// What is true of a mesh, good and bad. Lists name the first few offenders by the numbers of the file (-1 for a vertex
/// made by subdivision); the counts are complete.
struct MeshReport {
  static constexpr std::size_t kNamed = 8;  ///< length of the lists of offenders

  /// A connected part of the mesh.
  struct Component {
    std::int32_t vertices = 0;              ///< vertices in it
    std::int32_t edges = 0;                 ///< edges in it
    std::int32_t faces = 0;                 ///< faces in it
    std::int32_t boundary_loops = 0;        ///< closed chains of border edges
    std::int32_t border_edges = 0;          ///< edges with one face
    std::int32_t euler_characteristic = 0;  ///< vertices - edges + faces
    bool manifold = true;                   ///< no non-manifold edge or vertex
    bool orientable = true;                 ///< its faces can be turned so that all neighbours agree
    /// Handles of an orientable surface, cross-caps of a non-orientable one, boundary loops filled; empty when not
    /// manifold.
    std::optional<std::int32_t> genus;
  };

  std::int32_t vertices = 0, edges = 0, faces = 0;  ///< of the whole mesh
  std::vector<Component> components;                ///< numbered as by TriangleMesh::component()
  std::int32_t boundary_loops = 0;                  ///< connected sets of border edges
  std::int32_t border_edges = 0;                    ///< edges with one face
  bool orientable = true;                           ///< whether faces can be turned the same way round

  std::int32_t non_manifold_edges = 0;                                ///< edges with three or more faces
  std::vector<std::array<std::int32_t, 2>> named_non_manifold_edges;  ///< the first of them
  std::int32_t non_manifold_vertices = 0;                 ///< vertices whose faces do not hang together through edges
  std::vector<std::int32_t> named_non_manifold_vertices;  ///< the first of them
  std::int32_t flipped_edges = 0;  ///< edges whose two faces run through them in the same direction
  std::vector<std::array<std::int32_t, 2>> named_flipped_edges;  ///< the first of them
  std::int32_t degenerate_faces = 0;                             ///< corners collinear to rounding
  std::vector<std::int32_t> named_degenerate_faces;              ///< the first of them
  std::int32_t duplicate_faces = 0;                     ///< same three vertices as an earlier face, in any order
  std::vector<std::int32_t> named_duplicate_faces;      ///< the first of them
  std::int32_t duplicate_positions = 0;                 ///< vertices at the position of an earlier one
  std::vector<std::int32_t> named_duplicate_positions;  ///< the first of them
  /// Border vertices close to an earlier one, not at its position: within 1e-5 of the diagonal, and no edge joins them.
  std::int32_t near_positions = 0;
  std::vector<std::int32_t> named_near_positions;  ///< the first of them
  double near_within = 0;                          ///< none of these lies farther away, length units
  std::int32_t unreferenced_vertices = 0;          ///< vertices of the file that no face uses

  double area = 0;                    ///< length units squared
  double min_angle = 0;               ///< smallest corner angle, radians
  double min_edge = 0, max_edge = 0;  ///< length units
};

/// O(n log n).
MeshReport inspect(const TriangleMesh& mesh);

}  // namespace leastcost
