// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "problems/exact/end_point.hpp"
#include "problems/exact/front.hpp"
#include "problems/exact/half_edges.hpp"
#include "problems/exact/large_pages.hpp"

namespace leastcost {

/// Lower bounds of what is left to the target of a query, for paths that are shorter than one that is known
/// (docs/numerics.md Sec. 5.4). A front is the vertices at so many edges from the target, and the edges between them. A
/// path from outside crosses all fronts, one after the other, and from one to the next it is no shorter than the
/// straight line in space. So the bounds at a front follow from those at the front before, and those at any vertex from
/// those at a front. Keeps its memory. Lengths in length units.
class FrontBound {
 public:
  /// Of every path from a vertex to an end, at least.
  using FromVertex = std::function<double(std::int32_t)>;

  explicit FrontBound(const HalfEdges& mesh);

  /// Whether fronts gain more than they take, for a way of this length.
  static bool is_worth(const HalfEdges& mesh, double length);
  /// Makes the fronts around the target. The bounds hold for paths from the source that are shorter than `upper`;
  /// `to_source` bounds how far it is back to the source. None where somebody asks to stop; empty: nobody.
  void aim(const EndPoint& source, const EndPoint& target, double upper, const FromVertex& to_source,
           const std::function<bool()>& stop = {});
  /// Of every path through v: `upper` or more where no path that counts comes by; 0 near the target.
  double from_vertex(std::int32_t v);
  /// Two numbers whose linear interpolation along the edge of h, from its tail, is a bound at each of its points.
  std::optional<std::pair<double, double>> along(std::int32_t h);
  /// Whether there are fronts: else the way is too short for them, and all bounds are 0.
  bool helps() const { return count_ > 0; }

 private:
  struct Vertex {
    std::uint32_t query = 0;  ///< that this is of
    std::int32_t level = 0;   ///< edges from the target, or kApart
    std::int32_t front = 0;   ///< that the bound is by; -1: none
    float bound = -1;         ///< negative: not yet asked for
    float gap = 0;            ///< least distance from the points of that front
  };
  static constexpr std::int32_t kApart = -1;  ///< of a vertex of a front that no path which counts comes near to

  void start(const EndPoint& target);
  void spread(std::int32_t level);
  bool is_apart(std::int32_t v, double sum) const;
  void make_front(std::int32_t level, const FromVertex& to_source);
  template <class Visit>
  void each_edge(std::int32_t v, const Visit& visit) const;
  void add_edges(Front& front, std::int32_t v, const Front::Least& least);
  void add_point(Front& front, const Eigen::Vector3d& position, const Front::Least& least) const;
  Front* before() { return count_ > 0 ? &fronts_[static_cast<std::size_t>(count_) - 1] : nullptr; }
  Front::Least straight(const Eigen::Vector3d& position) const;
  const Vertex* asked(std::int32_t v);
  bool has_seen(std::int32_t v) const { return vertices_[static_cast<std::size_t>(v)].query == query_; }
  bool is_met(std::int32_t v) const { return has_seen(v) && level(v) != kApart; }
  std::int32_t level(std::int32_t v) const { return vertices_[static_cast<std::size_t>(v)].level; }
  std::size_t begin_of(std::int32_t level) const { return level > 0 ? end_of(level - 1) : 0; }
  std::size_t end_of(std::int32_t level) const { return level_end_[static_cast<std::size_t>(level)]; }

  const HalfEdges* mesh_;
  LargeVector<Vertex> vertices_;
  std::vector<std::int32_t> met_;       // vertices in the order of their levels
  std::vector<std::size_t> level_end_;  // per level, into met_
  std::vector<Front::Least> at_front_;  // at the vertices of the front that is made
  Front::Balls near_;                   // of the front before
  std::vector<Front> fronts_;           // more than count_ where earlier queries had more
  std::int32_t count_ = 0, step_ = 0;
  std::uint32_t query_ = 0;
  Eigen::Vector3d source_ = Eigen::Vector3d::Zero(), target_ = Eigen::Vector3d::Zero();
  double target_error_ = 0, upper_ = 0;
  double extent_ = 0;    // no path that counts is longer
  double rounding_ = 0;  // of a bound in floats
};

}  // namespace leastcost
