// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <leastcost/problems/mesh/edge_path.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

class EdgeLandmarks;

struct LengthSearchOptions {
  MetricRoot metric = {};   ///< lengths |A d|; none: Euclidean
  StopPredicate stop = {};  ///< true: give up; empty: never
  /// Also moves from a vertex straight across one edge to the vertex opposite, as EdgePathOptions::diagonals.
  bool diagonals = false;
  /// Further lower bounds, of this mesh under this metric; null: the straight line alone. They must outlive the search.
  const EdgeLandmarks* landmarks = nullptr;
};

/// What EdgeGraphSearch does, for the length in one constant metric: A* without a call per move, several times as
/// quick. Keeps its memory between queries, so that a query costs what it visits and not the size of the mesh. One
/// object per thread; the mesh must outlive it.
class LengthSearch {
 public:
  explicit LengthSearch(const TriangleMesh& mesh);

  EdgePath shortest(const SurfacePoint& source, const SurfacePoint& target, const LengthSearchOptions& options = {});
  /// Lengths of the shortest routes over edges and diagonals from a vertex to all others; infinite where there is none.
  /// Length units of the metric. After a stop they are upper bounds.
  std::vector<double> lengths_from(std::int32_t vertex, const LengthSearchOptions& options = {});

 private:
  /// Valid when its stamp is that of the query, so that nothing is ever cleared.
  struct Record {
    std::uint32_t stamp = 0;
    std::int32_t predecessor = -1;
    double length = std::numeric_limits<double>::infinity();
    double rest = 0;  // lower bound to the target
  };
  struct Open {
    double key;
    std::int32_t node;
  };
  /// Where a vertex sees another one straight across the far edge of one of its faces.
  struct Diagonal {
    double length = std::numeric_limits<double>::infinity();
    double at = 0;  // of the crossing, from tail (0) to head (1) of the edge
  };
  struct Free {
    void operator()(Record* records) const { std::free(records); }
  };

  bool is_vertex(std::int32_t node) const { return node < mesh_->vertex_count(); }
  Record& record(std::int32_t node);
  Eigen::Vector3d position(std::int32_t node) const;
  double squared_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  double length_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  double rest_from(std::int32_t node) const;
  void begin(const LengthSearchOptions& options);
  void look_at_landmarks();
  void aim(const SurfacePoint& source, const SurfacePoint& target);
  EdgePathOutcome run();
  void leave(std::int32_t node);
  void leave_across(std::int32_t node, const Eigen::Vector3d& from, double so_far);
  void relax(std::int32_t from, Record& r, std::int32_t to, double length);
  Diagonal across(const Eigen::Vector3d& from, std::int32_t halfedge, std::int32_t to) const;
  void push(Open entry);
  Open pop();
  void append_move(std::int32_t from, std::int32_t to, SurfacePath& path) const;
  SurfacePath path_found(std::vector<std::int32_t>& vertices) const;

  const TriangleMesh* mesh_;
  const LengthSearchOptions* options_ = nullptr;
  std::int32_t source_ = -1, target_ = -1;
  SurfacePoint source_point_, target_point_;
  Eigen::Vector3d goal_ = Eigen::Vector3d::Zero();
  std::array<std::int32_t, 3> target_corners_{-1, -1, -1};  // where the target is no vertex
  std::vector<float> target_fields_;                        // of the landmarks, at the target
  bool aims_ = false;
  std::unique_ptr<Record[], Free> records_;  // zeros, which are stale: only pages that are met are touched
  std::vector<Open> open_;                   // a heap of four children each; what was improved is in it twice
  std::uint32_t stamp_ = 0;
  std::int32_t settled_ = 0;
};

}  // namespace leastcost
