// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <leastcost/problems/exact/landmarks.hpp>
#include "problems/exact/end_point.hpp"

namespace leastcost {

/// The place of a source image relative to an edge: the edge runs from (0, 0) to (length, 0), the image is at
/// (x, -height).
struct ImagePlace {
  double x = 0, height = 0;
};

/// Lower bounds on what is left to the target: straight through space, and by landmarks. All are rounded down.
class LowerBound {
 public:
  LowerBound() = default;
  /// Without a target: nothing is left anywhere. Landmarks may be null; those that say most of the pair are used.
  LowerBound(const HalfEdges& mesh, const EndPoint& source, const EndPoint* target, const Landmarks* landmarks);

  /// Of every path from v to the target.
  double from_vertex(std::int32_t v) const;
  /// Of every path from the image straight through [begin, end] of the edge of h and on to the target.
  double through(std::int32_t h, double begin, double end, const ImagePlace& image) const;

 private:
  const HalfEdges* mesh_ = nullptr;
  bool aims_ = false;
  Eigen::Vector3d target_ = Eigen::Vector3d::Zero();
  double target_error_ = 0;
  const Landmarks* landmarks_ = nullptr;
  std::vector<std::int32_t> used_;
  std::vector<double> at_least_, at_most_;  // distance of each used landmark from the target
};

}  // namespace leastcost
