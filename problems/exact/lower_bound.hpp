// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <leastcost/problems/exact/landmarks.hpp>
#include "problems/exact/end_point.hpp"
#include "problems/exact/front_bound.hpp"
#include "problems/exact/window.hpp"

namespace leastcost {

/// The place of a source image relative to an edge: the edge runs from (0, 0) to (length, 0), the image is at
/// (x, -height).
struct ImagePlace {
  double x = 0, height = 0;
};

/// Lower bounds on what is left to the target: straight through space, by landmarks, and by fronts. All are rounded
/// down.
class LowerBound {
 public:
  LowerBound() = default;
  /// Without a target: nothing is left anywhere. Landmarks and fronts may be null. With fronts the bounds hold for
  /// the paths that these count.
  LowerBound(const HalfEdges& mesh, const EndPoint* target, const Landmarks* landmarks, FrontBound* fronts = nullptr);

  bool aims() const { return aims_; }
  /// Of every path from v to the target.
  double from_vertex(std::int32_t v) const;
  /// Of every path from an end of a query to the target.
  double from_end(const EndPoint& end) const;
  /// What `through` needs of the edge of h; `rest_tail` and `rest_head` are those of from_vertex().
  void look_from(std::int32_t h, EdgeState& edge) const;
  /// Of every path from the image straight through [begin, end] of an edge of this length and on to the target.
  double through(const EdgeState& edge, double length, double begin, double end, const ImagePlace& image) const;

 private:
  const HalfEdges* mesh_ = nullptr;
  bool aims_ = false;
  Eigen::Vector3d target_ = Eigen::Vector3d::Zero();
  double target_error_ = 0;
  const Landmarks* landmarks_ = nullptr;
  FrontBound* fronts_ = nullptr;
  // Of each landmark: beyond its distance from the target a field leaves its difference to go, before it likewise.
  std::vector<double> beyond_, before_;
};

}  // namespace leastcost
