// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include <leastcost/problems/mesh/edge_path.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

/// Inside EdgeGraphSearch: the graph of one query. Its nodes are the vertices of the mesh and up to two ends that are
/// none; its moves are made, with their costs, when a node is examined.
namespace leastcost {

enum class NodeState : std::uint8_t { unseen, open, settled };

/// What a query knows about a node. A record is valid when its stamp is that of the query, so nothing is ever cleared.
struct NodeRecord {
  std::uint32_t stamp = 0;
  NodeState state = NodeState::unseen;
  std::int32_t predecessor = -1;
  double distance = std::numeric_limits<double>::infinity();
  double key = std::numeric_limits<double>::infinity();  // distance + lower bound
};

struct Move {
  std::int32_t from, to;
  double cost;
  bool operator==(const Move&) const = default;
};

struct Free {
  void operator()(NodeRecord* records) const;
};

class EdgeQuery {
 public:
  explicit EdgeQuery(const TriangleMesh& mesh);

  /// Cost and options must outlive the search.
  void begin(const SurfacePoint& source, const SurfacePoint& target, const MoveCost& cost,
             const EdgePathOptions& options);
  std::int32_t source() const { return source_; }
  std::int32_t target() const { return target_; }

  NodeRecord& record(std::int32_t node) {
    NodeRecord& r = records_[static_cast<std::size_t>(node)];
    if (r.stamp != stamp_) r = NodeRecord{.stamp = stamp_, .predecessor = node};
    return r;
  }
  double bound(std::int32_t node) const;
  /// The passable moves out of a node to nodes that are not settled; valid until the next call.
  const std::vector<Move>& moves_from(std::int32_t node);
  /// Counts a settled node; true when the search is to stop.
  bool settle();
  std::int32_t settled() const { return settled_; }

  /// The path that the predecessors tell, and the vertices on it.
  SurfacePath path_found(std::vector<std::int32_t>& vertices) const;

 private:
  /// Where a vertex sees another one straight across the far edge of one of its faces.
  struct Diagonal {
    std::int32_t across_edge = -1, to = -1;
    Eigen::Vector3d crossing = Eigen::Vector3d::Zero();
  };
  bool is_vertex(std::int32_t node) const { return node < mesh_->vertex_count(); }
  Eigen::Vector3d position(std::int32_t node) const;
  void try_move(std::int32_t from, const Eigen::Vector3d& a, std::int32_t to);
  void try_diagonals(std::int32_t from, const Eigen::Vector3d& a);
  template <class Visit>
  void for_diagonals(std::int32_t from, Visit visit) const;
  bool cross_straight(const Eigen::Vector3d& a, Diagonal& diagonal) const;
  double cost_of(const Eigen::Vector3d& a, const Diagonal& diagonal) const;
  void append_move(std::int32_t from, std::int32_t to, SurfacePath& path) const;

  const TriangleMesh* mesh_;
  std::int32_t source_ = -1, target_ = -1;
  SurfacePoint source_point_, target_point_;
  std::array<std::int32_t, 3> target_corners_{-1, -1, -1};  // where the target is no vertex
  const MoveCost* cost_ = nullptr;
  const EdgePathOptions* options_ = nullptr;
  /// Zeros, which are stale: only the pages of nodes that a search meets are ever touched, so that making and freeing
  /// it takes no time on a mesh of a million vertices.
  std::unique_ptr<NodeRecord[], Free> records_;
  std::vector<Move> moves_;
  std::uint32_t stamp_ = 0;
  std::int32_t settled_ = 0;
};

}  // namespace leastcost
