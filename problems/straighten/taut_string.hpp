// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <leastcost/problems/mesh/surface_path.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include "problems/straighten/funnel.hpp"
#include "problems/straighten/strip.hpp"

namespace leastcost {

/// A path while it is straightened: straight pieces (in the unfolding of their strips) between nodes, which are the two
/// ends and the vertices that the path bends around.
struct TautString {
  struct Node {
    StripEnd end;
    bool changed = true;  ///< a piece next to it changed since its angles were last looked at
  };
  struct Piece {
    Strip strip;
    double length = 0;
    CornerAngles start, finish;  ///< at its first and last node, where these are vertices
  };
  std::vector<Node> nodes;  ///< one more than pieces
  std::vector<Piece> pieces;

  double length() const;
};

/// Makes and changes strings on one mesh in one metric.
class StringPuller {
 public:
  StringPuller(const TriangleMesh& mesh, const MetricRoot& metric);

  /// The path's strips, pulled; the vertices it goes through stay nodes. Throws InputError where it crosses an edge
  /// with three or more faces, or is no connected path.
  TautString from_path(const SurfacePath& path);
  /// Points where it crosses edges and vertices.
  SurfacePath to_path(const TautString& string);

  /// Appends the shortest string through the strip, without the node `from`, with the node `to`. Where both are one
  /// vertex and nothing is left in between, nothing is appended.
  void pull(const StripEnd& from, Strip& strip, const StripEnd& to, TautString& out);

  /// Parameters of the crossings of a straight piece along its doors, from tail (0) to head (1) of each.
  void crossings(const StripEnd& from, const Strip& strip, const StripEnd& to, std::vector<double>& parameters);

  Unfolding& unfolding() { return unfolding_; }
  /// A string nearer to a vertex than this, in length units of the metric, goes through it.
  double touching() const { return touching_; }
  const TriangleMesh& mesh() const { return *mesh_; }

 private:
  StripEnd end_at(const Eigen::Vector3d& p, std::int32_t face) const;
  std::int32_t vertex_near(const Eigen::Vector3d& p, std::int32_t f, std::int32_t g) const;
  std::int32_t door_between(std::int32_t f, std::int32_t g, const Eigen::Vector3d& p) const;
  std::int32_t shared_vertex(std::int32_t f, std::int32_t g, const Eigen::Vector3d& p) const;
  void append_piece(const StripEnd& from, const Eigen::Vector2d& from_at, const StripEnd& to,
                    const Eigen::Vector2d& to_at, const Strip& strip, std::size_t begin, std::size_t end,
                    TautString& out);

  const TriangleMesh* mesh_;
  double tolerance_;  // positions of the given path, length units
  double touching_;
  Unfolding unfolding_;
  Funnel funnel_;
};

/// Names an edge with three or more faces that a path needs to cross, and what can be done.
[[noreturn]] void throw_non_manifold(const TriangleMesh& mesh, std::int32_t halfedge);

}  // namespace leastcost
